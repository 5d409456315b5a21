#include "training/metric.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <numbers>
#include <set>

#include "tests/training/page_table.h"
#include "tests/training/written_session.h"
#include <gtest/gtest.h>

#include "core/random.h"
#include "io/probe_library_file.h"

namespace bodkin {

using namespace bodkin::forces;
using namespace bodkin::training;
namespace {

std::optional<double> value_of(WrittenSession& written, std::string_view metric) {
  const Attempt attempt(written.session(), written_description());
  return find_metric(metric)->compute(Measured(attempt));
}

// A motion along the path of this length and duration, by the polynomial of least jerk.
WrittenSession least_jerk(double length, int ticks) {
  WrittenSession written;
  written.to(0, 100, WrittenSession::air).rest(300, WrittenSession::air);
  for (int i = 0; i <= ticks; ++i) {
    const double s = static_cast<double>(i) / ticks;
    const double share = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
    written.add(Vec3(0, -length * share, 0), {true, tissue::fat, 1.0});
  }
  written.rest(300, {});  // too short to be a rest
  return written;
}

TEST(Metric, names_are_unique_and_say_their_unit) {
  std::set<std::string_view> names;
  for (const Metric& metric : all_metrics()) {
    EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
    EXPECT_EQ(find_metric(metric.name), &metric);
    EXPECT_FALSE(metric.title.empty() || metric.definition.empty() || metric.source.empty()) << metric.name;
    if (metric.unit == "mm") {
      EXPECT_TRUE(metric.name.ends_with("_mm")) << metric.name;
    }
    if (metric.unit == "s") {
      EXPECT_TRUE(metric.name.ends_with("_s")) << metric.name;
    }
  }
  EXPECT_GE(names.size(), 75U);
}

TEST(Metric, a_straight_insertion_to_the_target_has_the_numbers_that_it_was_made_with) {
  WrittenSession written;
  written.to(0, 1000, WrittenSession::air);
  written.to(50, 5000, {true, tissue::fat, 2.0}).rest(1000, {true, tissue::fat, 1.0});
  EXPECT_NEAR(*value_of(written, "duration_s"), 7.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "time_in_body_s"), 6.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "final_distance_mm"), 0.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "deviation_max_mm"), 0.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "path_length_mm"), 50.0, 0.1);
  EXPECT_NEAR(*value_of(written, "path_inefficiency_percent"), 0.0, 0.2);
  EXPECT_NEAR(*value_of(written, "travel_along_mm"), 50.0, 0.1);
  EXPECT_NEAR(*value_of(written, "swept_area_mm2"), 0.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "work_N_mm"), 100.0, 0.1);  // 2 N over 50 mm
  EXPECT_NEAR(*value_of(written, "peak_force_N"), 2.0, 1e-12);
  EXPECT_NEAR(*value_of(written, "mean_force_N"), 11.0 / 6.0, 1e-3);
  EXPECT_EQ(*value_of(written, "insertions"), 1.0);
  EXPECT_FALSE(value_of(written, "loss_depth_mm").has_value());
  EXPECT_FALSE(value_of(written, "tip_to_slice_mean_mm").has_value());
}

TEST(Metric, a_miss_is_split_into_depth_and_side) {
  WrittenSession written;
  written.go(Vec3(4, 0, 3), 100, WrittenSession::air);
  written.go(Vec3(4, -42, 3), 2000, {}).go(Vec3(4, -42, 3), 1000, {});
  EXPECT_NEAR(*value_of(written, "final_axial_mm"), -8.0, 1e-6);
  EXPECT_NEAR(*value_of(written, "final_lateral_mm"), 5.0, 1e-6);
  EXPECT_NEAR(*value_of(written, "final_distance_mm"), std::sqrt(64.0 + 25.0), 1e-6);
  EXPECT_NEAR(*value_of(written, "deviation_rms_mm"), 5.0, 1e-6);
  EXPECT_EQ(*value_of(written, "past_target_mm"), 0.0);
}

TEST(Metric, drawing_back_and_turning_is_a_redirection_and_drawing_back_alone_is_none) {
  const Vec3 turned = Vec3(std::sin(0.1), -std::cos(0.1), 0.0);  // 5.7 degrees
  for (const bool turn : {false, true}) {
    WrittenSession written;
    written.to(30, 3000, {}).to(15, 1000, {});
    written.go(Vec3(0, -40, 0), 2000, {}, turn ? turned : Vec3(-Vec3::UnitY()));
    EXPECT_EQ(*value_of(written, "redirections"), turn ? 1.0 : 0.0);
  }
}

TEST(Metric, a_needle_that_leaves_for_a_moment_is_still_the_same_insertion) {
  WrittenSession written;
  written.to(10, 500, {}).to(0, 200, {}).to(-1, 100, WrittenSession::air).to(10, 500, {});  // 0.1 s and 1 mm outside
  EXPECT_EQ(*value_of(written, "insertions"), 1.0);
  written.to(0, 200, {}).to(-8, 100, WrittenSession::air).to(10, 500, {});  // 8 mm
  EXPECT_EQ(*value_of(written, "insertions"), 2.0);
  written.to(0, 200, {}).to(-1, 600, WrittenSession::air).to(10, 500, {});  // 0.6 s
  EXPECT_EQ(*value_of(written, "insertions"), 3.0);
}

TEST(Metric, the_final_position_is_the_deepest_rest_and_the_last_of_equal_ones) {
  WrittenSession written;
  written.to(20, 1000, {}).rest(1000, {}).to(40, 1000, {}).rest(1000, {}).to(39.5, 500, {}).rest(1000, {});
  written.to(15, 1000, {}).rest(1000, {});
  EXPECT_NEAR(*value_of(written, "final_axial_mm"), -10.5, 0.02);
}

TEST(Metric, tremor_does_not_lengthen_the_path_much_and_is_found_with_amplitude_and_frequency) {
  WrittenSession written;
  written.to(0, 100, WrittenSession::air);
  constexpr double amplitude = 0.2, frequency = 9.0;  // mm, Hz
  for (int i = 0; i < 5000; ++i) {
    const double wave = amplitude * std::sin(2.0 * std::numbers::pi * frequency * i * 0.001);
    written.add(Vec3(wave, -0.008 * i, 0), {});
  }
  EXPECT_NEAR(*value_of(written, "tremor_mm"), amplitude / std::sqrt(2.0), 0.02 * amplitude);
  EXPECT_EQ(*value_of(written, "tremor_Hz"), frequency);
  WrittenSession noisy;
  noisy.to(0, 100, WrittenSession::air);
  Random random(3);
  for (int i = 0; i < 5000; ++i) noisy.add(Vec3(0.01 * random.normal(), -0.008 * i, 0.01 * random.normal()), {});
  EXPECT_NEAR(*value_of(noisy, "path_length_mm"), 40.0, 0.3);  // 80 mm when every tick counts
}

// T^3/v^2 times the integral of the squared jerk is 720/1.875^2 = 204.8, whatever the length and the time.
TEST(Metric, a_movement_of_least_jerk_has_the_smoothness_of_the_literature) {
  for (const double length : {20.0, 45.0}) {
    for (const int ticks : {2000, 4000}) {
      WrittenSession written = least_jerk(length, ticks);
      EXPECT_NEAR(*value_of(written, "smoothness"), -std::log(204.8), 0.2) << length << ' ' << ticks;
    }
  }
  WrittenSession steps;
  steps.to(0, 100, WrittenSession::air);
  for (int i = 1; i <= 8; ++i) steps.to(5.0 * i, 200, {}).rest(200, {});
  EXPECT_LT(*value_of(steps, "smoothness"), -8.0);
}

// The motion of least jerk of length L in time T has an integrated squared jerk of 720 L^2 / T^5.
TEST(Metric, the_root_of_the_jerk_is_that_of_the_polynomial) {
  WrittenSession written = least_jerk(40.0, 2000);
  const double expected = std::sqrt(720.0 * 40.0 * 40.0 / std::pow(2.0, 5.0));
  // It is largest at both ends, which the filter smooths.
  EXPECT_NEAR(*value_of(written, "jerk_mm_per_s2_5"), expected, 0.05 * expected);
}

TEST(Metric, a_needle_turned_about_its_entry_sweeps_a_sector) {
  WrittenSession written;
  written.to(0, 100, WrittenSession::air).to(40, 1000, {});
  const double straight = *value_of(written, "swept_area_mm2");
  constexpr double turn = 0.2;  // rad
  for (int i = 1; i <= 1000; ++i) {
    const double angle = turn * i / 1000.0;
    const Vec3 axis(std::sin(angle), -std::cos(angle), 0.0);
    written.add(40.0 * axis, {}, axis);
    written.session().ticks.back().output.depth = 40.0;
  }
  EXPECT_NEAR(*value_of(written, "swept_area_mm2") - straight, 0.5 * 40.0 * 40.0 * turn, 0.5);
  EXPECT_NEAR(*value_of(written, "shaft_sweep_deg"), turn / degree, 0.1);
}

TEST(Metric, force_on_bone_is_that_between_meeting_and_leaving_it) {
  WrittenSession written;
  written.to(0, 100, WrittenSession::air).to(30, 1000, {true, tissue::muscle, 9.0});
  written.to(30.1, 10, {true, tissue::cortical_bone, 2.0}).event(EventKind::bone_contact, tissue::cortical_bone);
  written.rest(100, {true, tissue::cortical_bone, 4.5}).to(29, 10, {true, tissue::muscle, 1.0});
  written.event(EventKind::bone_left).to(10, 500, {true, tissue::muscle, 8.0});
  EXPECT_NEAR(*value_of(written, "bone_force_N"), 4.5, 1e-12);
  EXPECT_EQ(*value_of(written, "bone_contacts"), 1.0);
}

TEST(Metric, the_needle_in_an_ultrasound_slice_is_measured_from_the_probes_pose) {
  WrittenSession written;
  written.to(0, 100, WrittenSession::air).to(40, 4000, {});
  written.session().header.second = session::SecondHeader{session::SecondRole::probe, "{}"};
  for (int i = 0; i < 400; ++i) {
    session::SecondSample sample;
    sample.time = 0.01 * i;
    sample.position = Vec3(20, 0, 3);  // the slice lies in x and y, 3 mm from the needle
    sample.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitX()));
    written.session().second.push_back(sample);
  }
  EXPECT_NEAR(*value_of(written, "tip_to_slice_mean_mm"), 3.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "tip_to_slice_max_mm"), 3.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "tip_in_slice_percent"), 0.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "needle_to_slice_deg"), 0.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "needle_to_slice_max_deg"), 0.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "needle_to_slice_moving_max_deg"), 0.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "tip_to_slice_moving_mean_mm"), 3.0, 1e-9);  // at 10 mm/s
  EXPECT_NEAR(*value_of(written, "tip_to_slice_moving_max_mm"), 3.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "target_in_slice_percent"), 100.0, 1e-9);  // 3 mm off, in front of the probe
  EXPECT_NEAR(*value_of(written, "needle_to_target_deg"), 0.0, 1e-6);
  for (session::SecondSample& each : written.session().second) each.position.z() = 6.0;
  EXPECT_NEAR(*value_of(written, "target_in_slice_percent"), 0.0, 1e-9);
}

// Turning counts as action, about the needle's own axis as well as of its shaft.
TEST(Metric, a_needle_is_in_action_while_it_moves_or_turns) {
  const auto percent = [](double turn_deg_per_s, const Vec3& about) {
    WrittenSession written;
    written.to(0, 100, WrittenSession::air).to(0.01, 1, {}).rest(3999, {});
    auto& ticks = written.session().ticks;
    for (std::size_t i = ticks.size() - 2000; i < ticks.size(); ++i) {
      const double angle = turn_deg_per_s * degree * 0.001 * static_cast<double>(i + 2000 - ticks.size());
      ticks[i].input.needle.rotate(Eigen::AngleAxisd(angle, about));
    }
    return *value_of(written, "in_action_percent");
  };
  EXPECT_NEAR(percent(20.0, Vec3::UnitZ()), 50.0, 1.5);
  EXPECT_NEAR(percent(20.0, Vec3::UnitX()), 50.0, 1.5);
  EXPECT_NEAR(percent(9.0, Vec3::UnitX()), 0.0, 1e-12) << "TrainUS has 10 deg/s";
  WrittenSession moving;
  moving.to(0, 100, WrittenSession::air).to(10, 1000, {}).rest(1000, {});  // at 10 mm/s, then at rest
  EXPECT_NEAR(*value_of(moving, "in_action_percent"), 50.0, 1.5);
  WrittenSession slow;
  slow.to(0, 100, WrittenSession::air).to(4, 1000, {}).rest(1000, {});
  EXPECT_NEAR(*value_of(slow, "in_action_percent"), 0.0, 1e-12) << "4 mm/s is slower than 5";
}

TEST(Metric, the_whole_path_has_the_ways_outside_the_body_too) {
  WrittenSession written;
  written.to(0, 1000, WrittenSession::air).to(30, 3000, {}).rest(500, {});
  EXPECT_NEAR(*value_of(written, "path_length_mm"), 30.0, 0.2);
  EXPECT_NEAR(*value_of(written, "whole_path_length_mm"), 40.0, 0.2);
}

// A mouse moves the probe on the screen: the samples of the ultrasound machine hold its poses.
TEST(Metric, a_probe_on_the_screen_is_measured_as_one_in_a_second_hand) {
  WrittenSession written;
  written.to(0, 100, WrittenSession::air).to(40, 4000, {});
  session::Session& session = written.session();
  session.header.ultrasound = io::find_probe("L12-3");
  session::ScanSample sample;
  sample.time = 0.05;
  sample.probe.translation() = Vec3(10, 0, 3);  // the face is 38.4 mm long: the target lies under it
  sample.probe.linear().col(0) = Vec3::UnitX();
  sample.probe.linear().col(1) = -Vec3::UnitY();  // into the patient
  sample.probe.linear().col(2) = -Vec3::UnitZ();
  session.scans.push_back(sample);
  EXPECT_NEAR(*value_of(written, "tip_to_slice_mean_mm"), 3.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "needle_to_slice_deg"), 0.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "target_in_slice_percent"), 100.0, 1e-9);
  // From 2.1 s on, half of the time in the body, the tip is in the slice: a sample holds until the next one.
  sample.time = 2.1;
  sample.probe.translation().z() = 0.0;
  session.scans.push_back(sample);
  EXPECT_NEAR(*value_of(written, "tip_in_slice_percent"), 50.0, 0.5);
  EXPECT_NEAR(*value_of(written, "tip_to_slice_mean_mm"), 1.5, 0.02);
  EXPECT_NEAR(*value_of(written, "tip_to_slice_max_mm"), 3.0, 1e-9);
}

TEST(Metric, structures_scanned_counts_what_the_procedure_names) {
  WrittenSession written;
  written.to(0, 100, WrittenSession::air).to(40, 4000, {});
  session::Session& session = written.session();
  session.scanned = {{false, "skin", 0.1}, {false, "nerve", 0.2}, {true, "humerus", 0.3}};
  const auto count = [&](const std::vector<std::string>& named) {
    const Attempt attempt(session, written_description());
    return find_metric("structures_scanned")->compute(Measured(attempt, named));
  };
  EXPECT_FALSE(count({"nerve"}).has_value()) << "there was no machine";
  session.header.ultrasound = io::find_probe("L12-3");
  EXPECT_EQ(count({"nerve", "humerus", "lung"}), 2.0);
  EXPECT_EQ(count({"lung"}), 0.0);
}

TEST(Metric, lifting_thrusting_and_twirling_have_the_amplitude_and_frequency_that_they_were_made_with) {
  WrittenSession written;
  written.to(0, 100, WrittenSession::air).to(20, 1000, {});
  constexpr double amplitude = 4.0, lifting = 0.5;  // mm from top to bottom, Hz
  constexpr double turn = 90.0, twirling = 1.0;     // deg from one side to the other, Hz
  for (int i = 0; i < 10000; ++i) {
    const double t = 0.001 * i;
    written.add(Vec3(0, -20.0 - 0.5 * amplitude * std::sin(2.0 * std::numbers::pi * lifting * t), 0), {});
    Pose& needle = written.session().ticks.back().input.needle;
    needle.rotate(
        Eigen::AngleAxisd(0.5 * turn * degree * std::sin(2.0 * std::numbers::pi * twirling * t), Vec3::UnitZ()));
  }
  written.to(0, 1000, {});
  EXPECT_NEAR(*value_of(written, "lift_thrust_mm"), amplitude, 0.02);
  EXPECT_NEAR(*value_of(written, "lift_thrust_Hz"), lifting, 0.01);
  EXPECT_LT(*value_of(written, "lift_thrust_scatter_mm"), 1.0);
  EXPECT_NEAR(*value_of(written, "thrust_depth_mm"), 22.0 - 50.0, 0.02);  // 20 mm and half the stroke, target at 50
  EXPECT_NEAR(*value_of(written, "twirl_deg"), turn, 1.0);
  EXPECT_NEAR(*value_of(written, "twirl_Hz"), twirling, 0.01);
  WrittenSession straight = good_puncture();
  EXPECT_FALSE(value_of(straight, "lift_thrust_mm").has_value());
  EXPECT_FALSE(value_of(straight, "twirl_deg").has_value());
}

// 3 mm from the planned path throughout, with one return towards the beginning: the maximum of the distances does not
// notice the return, the Fréchet distance does, because the plan cannot be walked backwards.
TEST(Metric, a_way_that_turns_back_is_far_from_the_plan_by_frechet_and_near_it_by_the_greatest_distance) {
  WrittenSession beside;
  beside.go(Vec3(3, 0, 0), 100, WrittenSession::air).go(Vec3(3, -50, 0), 5000, {}).rest(1000, {});
  EXPECT_NEAR(*value_of(beside, "deviation_frechet_mm"), 3.0, 0.02);
  EXPECT_NEAR(*value_of(beside, "deviation_mean_mm"), 3.0, 1e-6);
  WrittenSession back;
  back.go(Vec3(3, 0, 0), 100, WrittenSession::air).go(Vec3(3, -45, 0), 4500, {}).go(Vec3(3, -5, 0), 4000, {});
  back.go(Vec3(3, -50, 0), 4500, {}).rest(1000, {});
  EXPECT_NEAR(*value_of(back, "deviation_max_mm"), 3.0, 1e-6);
  // The best walk waits in the middle of the stretch walked twice: 20 mm from either end, and 3 mm to the side.
  EXPECT_NEAR(*value_of(back, "deviation_frechet_mm"), std::hypot(20.0, 3.0), 0.3);
  EXPECT_GT(*value_of(back, "deviation_warped_mm"), *value_of(beside, "deviation_warped_mm"));
}

TEST(Metric, a_straight_insertion_has_the_spread_the_box_and_the_times_that_follow_from_its_length) {
  WrittenSession written;
  written.to(0, 100, WrittenSession::air).to(50, 5000, {});
  EXPECT_NEAR(*value_of(written, "spread_mm"), 50.0 / std::sqrt(12.0), 0.02);  // of an even distribution
  EXPECT_NEAR(*value_of(written, "box_mm3"), 0.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "box_across_mm"), 0.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "box_through_mm"), 50.0, 0.02);
  EXPECT_NEAR(*value_of(written, "box_along_mm"), 0.0, 1e-9);
  EXPECT_NEAR(*value_of(written, "time_to_target_s"), 4.7, 0.002);  // 3 mm before the target, at 10 mm/s
  EXPECT_NEAR(*value_of(written, "closest_time_s"), 5.0, 0.002);
  EXPECT_NEAR(*value_of(written, "sawing"), 1.0, 0.01);
  EXPECT_EQ(*value_of(written, "translational_actions"), 0.0);
  EXPECT_NEAR(*value_of(written, "spin_deg"), 0.0, 1e-6);
  WrittenSession short_of_it;
  short_of_it.to(0, 100, WrittenSession::air).to(46, 5000, {});
  EXPECT_FALSE(value_of(short_of_it, "time_to_target_s").has_value());
}

TEST(Metric, quick_movements_and_turns_count_when_they_last) {
  WrittenSession written;
  written.rest(1000, WrittenSession::air);
  for (int k = 0; k < 3; ++k)  // 100 mm/s for 0.4 s
    written.to(k % 2 == 0 ? -50 : -10, 400, WrittenSession::air).rest(600, WrittenSession::air);
  written.to(-45, 50, WrittenSession::air).rest(600, WrittenSession::air);  // equally fast, for 0.05 s
  EXPECT_EQ(*value_of(written, "translational_actions"), 3.0);
  EXPECT_EQ(*value_of(written, "rotational_actions"), 0.0);

  WrittenSession turned;
  turned.to(0, 100, WrittenSession::air).to(20, 2000, {});
  for (int i = 1; i <= 1000; ++i) {  // 90 degrees in a second
    turned.add(Vec3(0, -20, 0), {});
    turned.session().ticks.back().input.needle.rotate(Eigen::AngleAxisd(0.09 * i * degree, Vec3::UnitZ()));
  }
  EXPECT_NEAR(*value_of(turned, "spin_deg"), 90.0, 5.0);  // 50 ms lost at either end
  EXPECT_EQ(*value_of(turned, "rotational_actions"), 1.0);
}

TEST(Metric, hands_that_move_and_rest_together_correlate) {
  const auto of_hands = [](double shift) {
    WrittenSession written;
    written.to(0, 1000, WrittenSession::air);
    for (int k = 0; k < 4; ++k) written.to(5.0 * (k + 1), 1000, {}).rest(1000, {});
    written.session().header.second = session::SecondHeader{session::SecondRole::plunger, "{}"};
    for (int i = 0; i < 800; ++i) {
      session::SecondSample sample;
      sample.time = 1.0 + 0.01 * i;
      const double phase = std::fmod(0.01 * i + shift, 2.0), whole = std::floor((0.01 * i + shift) / 2.0);
      sample.position = Vec3(7.0 * (whole + std::min(phase, 1.0)), 0, 0);
      written.session().second.push_back(sample);
    }
    return *value_of(written, "hands_together");
  };
  EXPECT_NEAR(of_hands(0.0), 1.0, 0.03);
  EXPECT_NEAR(of_hands(1.0), -1.0, 0.03);
  EXPECT_NEAR(of_hands(0.5), 0.0, 0.05);
}

// docs/metrics.md holds the table of all metrics; BODKIN_WRITE_PAGES=1 writes it.
TEST(Metric, the_page_defines_every_one) {
  expect_table_on_page("metrics.md", "| name |", metrics_table());
}

}  // namespace
}  // namespace bodkin
