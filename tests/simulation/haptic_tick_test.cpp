#include "simulation/haptic_tick.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "tests/simulation/slab_patient.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "haptics/force_governor.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::haptics;
using namespace bodkin::simulation;
namespace {

using namespace tissue;

// Drives a tick and records the results.
struct Drive {
  explicit Drive(const Case& patient) : tick(patient) {}

  TickOutput to(const TickInput& input) {
    output = tick.step(input);
    events.insert(events.end(), output.events.begin(), output.events.end());
    return output;
  }
  TickOutput to(double new_depth) { return to(needle_at(depth = new_depth)); }
  TickOutput move(double new_depth, double speed) {
    const double start = depth;
    const int ticks = std::max(1, static_cast<int>(std::lround(std::abs(new_depth - start) / (speed * tick.dt()))));
    for (int step = 1; step <= ticks; ++step) {
      to(start + (new_depth - start) * step / ticks);
      peak = std::max(peak, output.resistance);
    }
    return output;
  }
  std::vector<Event> seen(EventKind kind) const {
    std::vector<Event> found;
    for (const Event& event : events) {
      if (event.kind == kind) found.push_back(event);
    }
    return found;
  }

  HapticTick tick;
  TickOutput output;
  std::vector<Event> events;
  double depth = -5.0;
  double peak = 0.0;
};

std::vector<TickInput> wandering_needle(std::uint64_t seed, int ticks) {
  Random random(seed);
  std::vector<TickInput> inputs;
  double depth = -3.0, speed = 0.0;
  Vec3 side = Vec3::Zero();
  for (int tick = 0; tick < ticks; ++tick) {
    speed += 0.02 * (30.0 * random.normal() - speed) + 0.3;
    if (depth > 34.0) speed -= 4.0;
    depth += 0.001 * speed;
    side += 0.002 * Vec3(random.normal(), random.normal(), 0.0);
    inputs.push_back(needle_at(side + Vec3(0.0, 0.0, depth), Vec3(0.05 * side.x(), 0.0, 1.0)));
  }
  return inputs;
}

TEST(HapticTick, contact_is_found_between_two_ticks_and_depth_counts_from_the_skin) {
  const Case patient = slab_patient();
  Drive drive(patient);
  drive.to(-0.3);
  EXPECT_FALSE(drive.output.in_contact);
  EXPECT_EQ(drive.output.tissue, air);
  drive.to(0.4);
  EXPECT_TRUE(drive.output.in_contact);
  EXPECT_EQ(drive.output.tissue, skin);
  EXPECT_NEAR(drive.output.depth, 0.4, 1e-6);
  EXPECT_EQ(drive.seen(EventKind::contact).size(), 1u);
}

TEST(HapticTick, the_measured_speed_does_not_change_at_contact) {
  const Case patient = slab_patient();
  HapticTick haptics(patient);
  for (int tick = 0; tick < 250; ++tick) {
    const double depth = -3.001 + 0.02 * tick;  // the skin is reached a twentieth into a tick
    const TickOutput output = haptics.step(needle_at(depth));
    if (depth > -2.0) {
      EXPECT_NEAR(output.velocity, 20.0, 0.05) << depth;
    }
  }
}

TEST(HapticTick, a_needle_that_trembles_across_a_border_enters_a_tissue_once) {
  const Case patient = slab_patient();
  Drive drive(patient);
  drive.move(12.05, 10.0);
  const std::size_t before = drive.seen(EventKind::tissue_entered).size();
  for (int turn = 0; turn < 20; ++turn) drive.move(turn % 2 == 0 ? 11.95 : 12.05, 10.0);
  EXPECT_LE(drive.seen(EventKind::tissue_entered).size(), before + 1);
}

TEST(HapticTick, a_needle_that_starts_inside_touches_there) {
  const Case patient = slab_patient();
  Drive drive(patient);
  drive.to(15.0);
  EXPECT_EQ(drive.output.resistance, 0.0);
  drive.to(16.0);
  EXPECT_TRUE(drive.output.in_contact);
  EXPECT_NEAR(drive.output.depth, 1.0, 1e-12);
  EXPECT_EQ(drive.seen(EventKind::contact).size(), 1u);
}

TEST(HapticTick, an_insertion_tells_its_story_in_order) {
  const Case patient = slab_patient();
  Drive drive(patient);
  drive.move(46.0, 10.0);
  std::vector<std::pair<EventKind, TissueId>> story;
  for (const Event& event : drive.events) {
    if (event.kind != EventKind::tissue_entered) story.emplace_back(event.kind, event.tissue);
  }
  const std::vector<std::pair<EventKind, TissueId>> expected = {{EventKind::contact, skin},
                                                                {EventKind::puncture, skin},
                                                                {EventKind::puncture, muscle},
                                                                {EventKind::puncture, ligamentum_flavum},
                                                                {EventKind::loss_of_resistance, epidural_fat},
                                                                {EventKind::bone_contact, cortical_bone}};
  EXPECT_EQ(story, expected);
  std::vector<TissueId> entered;
  for (const Event& event : drive.seen(EventKind::tissue_entered)) entered.push_back(event.tissue);
  EXPECT_EQ(entered, (std::vector<TissueId>{skin, fat, muscle, ligamentum_flavum, epidural_fat, cortical_bone}));
  EXPECT_GT(drive.seen(EventKind::loss_of_resistance)[0].value, 2.0);
}

TEST(HapticTick, the_hub_stops_a_needle_that_is_in_to_its_whole_length) {
  Case patient = slab_patient();
  patient.description.needle.length = 20.0;
  Drive drive(patient);
  drive.move(19.9, 10.0);
  EXPECT_TRUE(drive.seen(EventKind::hub_contact).empty());
  const double before = drive.output.resistance;
  drive.move(21.0, 10.0);
  EXPECT_EQ(drive.seen(EventKind::hub_contact).size(), 1u);
  EXPECT_GT(drive.output.resistance, before + 0.5 * patient.description.device.stiffness);
}

TEST(HapticTick, withdrawal_ends_contact_and_a_new_entry_meets_whole_skin) {
  const Case patient = slab_patient();
  Drive drive(patient);
  drive.move(10.0, 20.0);
  drive.move(-5.0, 20.0);
  EXPECT_FALSE(drive.output.in_contact);
  EXPECT_EQ(drive.output.resistance, 0.0);
  EXPECT_EQ(drive.seen(EventKind::withdrawn).size(), 1u);
  drive.move(10.0, 20.0);
  EXPECT_EQ(drive.seen(EventKind::puncture).size(), 2u);
}

TEST(HapticTick, force_acts_along_the_frozen_line_even_when_the_hand_tilts) {
  const Case patient = slab_patient();
  Drive drive(patient);
  drive.move(1.5, 10.0);
  const Vec3 tilted = Vec3(0.3, 0.0, 1.0).normalized();
  for (int tick = 0; tick < 50; ++tick) drive.to(needle_at(Vec3(0.0, 0.0, 1.5), tilted));
  EXPECT_GT(drive.output.resistance, 0.05);
  EXPECT_NEAR(drive.output.requested.force.x(), 0.0, 1e-9);
  EXPECT_NEAR(drive.output.requested.force.z(), -drive.output.resistance, 1e-12);
}

TEST(HapticTick, off_the_line_the_constraint_pulls_back) {
  const Case patient = slab_patient();
  Drive drive(patient);
  drive.move(5.0, 10.0);
  for (int tick = 0; tick <= 200; ++tick) drive.to(needle_at(Vec3(0.01 * tick, 0.0, 5.0)));
  EXPECT_NEAR(drive.output.requested.force.x(), -1.0, 1e-9);
  EXPECT_NEAR(drive.output.constraint, 1.0, 1e-9);
}

TEST(HapticTick, the_weight_of_the_device_is_carried_in_air_and_in_tissue) {
  Case patient = slab_patient();
  patient.description.haptics.compensation = {.up = Vec3::UnitY(), .weight = 0.7};
  Drive drive(patient);
  for (int tick = 0; tick < 100; ++tick) drive.to(-5.0);
  EXPECT_NEAR(drive.output.applied.force.y(), 0.7, 1e-12);
  drive.move(5.0, 10.0);
  EXPECT_NEAR(drive.output.requested.force.y(), 0.7, 1e-12);
}

TEST(HapticTick, the_same_recording_twice_gives_the_same_bits) {
  const Case patient = slab_patient();
  const auto inputs = wandering_needle(5, 20000);
  HapticTick a(patient), b(patient);
  for (int warm = 0; warm < 5000; ++warm) b.step(inputs[static_cast<std::size_t>(warm)]);
  b.reset();  // a reset leaves nothing behind
  for (const TickInput& input : inputs) {
    const TickOutput x = a.step(input), y = b.step(input);
    ASSERT_EQ(std::memcmp(x.applied.force.data(), y.applied.force.data(), 24), 0);
    ASSERT_EQ(std::memcmp(x.requested.force.data(), y.requested.force.data(), 24), 0);
    ASSERT_EQ(std::memcmp(&x.depth, &y.depth, 8), 0);
    ASSERT_EQ(std::memcmp(&x.velocity, &y.velocity, 8), 0);
    ASSERT_EQ(x.events.size(), y.events.size());
    ASSERT_EQ(x.limits, y.limits);
  }
}

TEST(HapticTick, a_still_needle_is_finite_and_steady_in_any_state) {
  const Case patient = slab_patient();
  for (double depth = -4.0; depth < 50.0; depth += 1.7) {
    Drive drive(patient);
    drive.move(depth, 50.0);
    for (int tick = 0; tick < 200; ++tick) drive.to(depth);
    const double settled = drive.output.resistance;
    EXPECT_TRUE(std::isfinite(settled));
    for (int tick = 0; tick < 100; ++tick) EXPECT_NEAR(drive.to(depth).resistance, settled, 1e-6);
  }
}

TEST(HapticTick, half_the_time_step_gives_the_same_force) {
  Case coarse = slab_patient(), fine = slab_patient();
  fine.description.haptics.rate = 2000.0;
  Drive a(coarse), b(fine);
  for (double depth = -4.0; depth <= 31.0; depth += 0.5) {
    const double from_coarse = a.move(depth, 10.0).resistance, from_fine = b.move(depth, 10.0).resistance;
    EXPECT_NEAR(from_coarse, from_fine, 1.0 * 10.0 * 0.001 + 0.005) << "depth " << depth;  // K v dt
  }
}

TEST(HapticTick, a_needle_fired_in_at_1_m_per_second_stays_within_the_device) {
  const Case patient = slab_patient();
  Drive drive(patient);
  for (int tick = 0; tick < 300; ++tick) {
    drive.to(-5.0 + tick);
    EXPECT_LE(drive.output.applied.force.norm(), 6.0 + 1e-12);
    EXPECT_TRUE(drive.output.requested.force.allFinite());
  }
  for (int tick = 0; tick < 200; ++tick) drive.to(300.0);
  EXPECT_TRUE(drive.output.limits & (force_limit::peak | force_limit::thermal));
  EXPECT_FALSE(drive.seen(EventKind::force_limited).empty());
}

TEST(HapticTick, a_force_beyond_the_device_is_told_again_only_after_a_rest) {
  Case patient = slab_patient();
  patient.description.haptics.resistance = SpringDamperWallSettings{.stiffness = 0.5, .damping = 0.0};
  patient.description.device.peak_force = 1.0;
  patient.description.device.continuous_force = 1.0;
  Drive drive(patient);
  drive.move(6.0, 20.0);
  for (int tick = 0; tick < 300; ++tick) drive.to(6.0);
  EXPECT_TRUE(drive.output.limits & force_limit::peak);
  EXPECT_EQ(drive.seen(EventKind::force_limited).size(), 1U);
  drive.move(1.0, 20.0);  // 0.2 s below the limit
  EXPECT_FALSE(drive.output.limits & force_limit::peak);
  drive.move(6.0, 20.0);
  EXPECT_EQ(drive.seen(EventKind::force_limited).size(), 2U);
}

TEST(HapticTick, tissue_that_is_stiffer_than_the_device_renders_is_told) {
  for (const double renders : {0.1, 100.0}) {
    Case patient = slab_patient();
    patient.description.device.stiffness = renders;
    Drive drive(patient);
    int told = 0;
    for (double depth = -1.0; depth < 30.0; depth += 0.02)
      told += (drive.to(depth).limits & force_limit::stiffness) != 0 ? 1 : 0;
    if (renders < 1.0) {
      EXPECT_GT(told, 50);
    } else {
      EXPECT_EQ(told, 0);
    }
  }
}

TEST(HapticTick, leaving_the_volume_is_air_and_said_once) {
  const Case patient = slab_patient({muscle, muscle, muscle, muscle, muscle, muscle, muscle, muscle});
  Drive drive(patient);
  drive.move(60.0, 20.0);
  int air_events = 0;
  for (const Event& event : drive.seen(EventKind::tissue_entered)) air_events += event.tissue == air ? 1 : 0;
  EXPECT_EQ(air_events, 1);
  EXPECT_EQ(drive.output.tissue, air);
}

TEST(HapticTick, reversing_at_every_tick_never_grows_into_chatter) {
  const Case patient = slab_patient();
  for (const double amplitude : {0.005, 0.03, 0.2}) {
    Drive drive(patient);
    drive.move(28.0, 10.0);
    double first_second = 0.0, last_second = 0.0;
    for (int tick = 0; tick < 10000; ++tick) {
      drive.to(28.0 + (tick % 2 == 0 ? amplitude : -amplitude));
      const double size = std::abs(drive.output.resistance);
      if (tick < 1000) first_second = std::max(first_second, size);
      if (tick >= 9000) last_second = std::max(last_second, size);
    }
    EXPECT_LE(last_second, first_second + 1e-9);
    EXPECT_LE(last_second, 1.0);
  }
}

TEST(HapticTick, no_tick_raises_the_force_by_more_than_the_slew) {
  const Case patient = slab_patient();
  HapticTick tick(patient);
  Vec3 last = Vec3::Zero();
  for (const TickInput& input : wandering_needle(9, 20000)) {
    const Vec3 now = tick.step(input).applied.force;
    const double kept = last.squaredNorm() > 0.0 ? std::clamp(now.dot(last) / last.squaredNorm(), 0.0, 1.0) : 0.0;
    ASSERT_LE((now - kept * last).norm(), 0.2 + 1e-9);
    last = now;
  }
}

TEST(HapticTick, an_ordinary_insertion_leaves_the_passivity_controller_idle) {
  const Case patient = slab_patient();
  Drive drive(patient);
  const auto idle = [&drive] { return (drive.output.limits & force_limit::passivity) == 0; };
  for (const double target : {20.0, 10.0, 34.0, -10.0}) {
    const double step = target > drive.depth ? 0.01 : -0.01;
    while ((target - drive.depth) * step > 0.0) {
      drive.to(drive.depth + step);
      ASSERT_TRUE(idle()) << "depth " << drive.depth;
    }
  }
}

TEST(HapticTick, the_energy_is_the_work_that_the_hand_did_along_the_needle) {
  const Case patient = slab_patient();
  Drive drive(patient);
  double work = 0.0, last = 0.0;
  for (int i = 1; i <= 2000; ++i) {
    drive.to(-2.0 + 0.01 * i);
    if (drive.output.in_contact) work += drive.output.resistance * 0.01;
    EXPECT_GE(drive.output.energy, last - 1e-9) << "an insertion only gives";
    last = drive.output.energy;
  }
  EXPECT_GT(work, 1.0);
  EXPECT_NEAR(last, work, 0.02 * work);
}

TEST(HapticTick, what_is_not_a_number_ends_in_a_ramp_to_zero_and_reset_leads_out) {
  const Case patient = slab_patient();
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300,
                        -2e5};
  for (const double value : bad) {
    Drive drive(patient);
    drive.move(3.5, 10.0);
    const double before = drive.output.applied.force.norm();
    ASSERT_GT(before, 0.1);
    TickInput broken = needle_at(3.5);
    broken.needle.translation().z() = value;
    double last = before;
    for (int tick = 0; tick < 30; ++tick) {
      drive.to(tick % 3 == 0 ? broken : needle_at(3.5));
      const double now = drive.output.applied.force.norm();
      EXPECT_LE(now, last + 1e-12);
      EXPECT_LT(last - now, 0.2 * before);
      EXPECT_TRUE(std::isfinite(drive.output.depth) && std::isfinite(drive.output.velocity));
      EXPECT_EQ(drive.output.requested.force.norm(), 0.0);
      last = now;
    }
    EXPECT_NEAR(last, 0.0, 1e-9);
    EXPECT_EQ(drive.seen(EventKind::fault).size(), 1u);
    drive.tick.reset();
    drive.depth = -5.0;
    drive.move(3.5, 10.0);
    EXPECT_GT(drive.output.applied.force.norm(), 0.1);
  }
}

TEST(HapticTick, a_needle_without_an_axis_is_a_fault) {
  const Case patient = slab_patient();
  Drive drive(patient);
  TickInput broken = needle_at(1.0);
  broken.needle.linear().setZero();
  drive.to(broken);
  EXPECT_EQ(drive.seen(EventKind::fault).size(), 1u);
}

TEST(HapticTick, random_labels_and_random_needles_give_finite_bounded_forces) {
  Random random(21);
  for (int patient_number = 0; patient_number < 20; ++patient_number) {
    std::vector<TissueId> slabs(100);
    const TissueId kinds[] = {air, skin, fat, muscle, muscle, cortical_bone, ligamentum_flavum, epidural_fat, 77};
    for (TissueId& slab : slabs) slab = kinds[random.next() % 9];
    const Case patient = slab_patient(slabs);
    HapticTick tick(patient);
    Vec3 tip(0.0, 0.0, -2.0), velocity = Vec3::Zero();
    for (int step = 0; step < 3000; ++step) {
      velocity += 0.05 * (100.0 * Vec3(random.normal(), random.normal(), random.normal() + 0.5) - velocity);
      tip += 0.001 * velocity;
      const TickOutput output = tick.step(needle_at(tip, Vec3(random.normal(), random.normal(), 5.0)));
      ASSERT_TRUE(output.applied.force.allFinite());
      ASSERT_LE(output.applied.force.norm(), 6.0 + 1e-12);
      ASSERT_FALSE(output.limits & force_limit::fault);
    }
  }
}

TEST(HapticTick, a_quantised_device_feels_the_same_insertion) {
  Case patient = slab_patient();
  Drive exact(patient);
  exact.move(34.0, 10.0);
  Case coarse = slab_patient();
  coarse.description.device.position_resolution = 0.03;
  Drive quantised(coarse);
  for (double depth = -5.0; depth < 34.0; depth += 0.01) quantised.to(std::round(depth / 0.03) * 0.03);
  ASSERT_EQ(exact.seen(EventKind::puncture).size(), quantised.seen(EventKind::puncture).size());
  EXPECT_NEAR(exact.output.resistance, quantised.output.resistance, 0.08);
}

TEST(HapticTick, refuses_a_case_that_cannot_be_felt) {
  EXPECT_THROW(HapticTick{Case{}}, InputError);
  Case patient = slab_patient();
  patient.description.haptics.rate = 10.0;
  EXPECT_THROW(HapticTick{patient}, InputError);
  patient = slab_patient();
  patient.description.device.continuous_force = 10.0;
  EXPECT_THROW(HapticTick{patient}, InputError);
  patient = slab_patient();
  patient.description.haptics.resistance = LayeredSettings{.layer = 0.0};
  EXPECT_THROW(HapticTick{patient}, InputError);
  patient = slab_patient();
  patient.description.device.stiffness = 0.0;
  EXPECT_THROW(HapticTick{patient}, InputError);
  patient = slab_patient();
  patient.description.device.lateral_stiffness = -1.0;
  EXPECT_THROW(HapticTick{patient}, InputError);
  patient = slab_patient();
  patient.description.device.peak_force = 500.0;
  EXPECT_NO_THROW(HapticTick{patient}) << "stronger than a case file can state";
}

}  // namespace
}  // namespace bodkin
