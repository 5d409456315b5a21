#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

namespace bodkin_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

using PerformCommand = PatientCommand;

const std::string device = "force_dimension --settings library=" BODKIN_MOCKS "/force_dimension/libdrd.so ";

// A simulated hand that would continue beyond the lesion.
TEST_F(PerformCommand, a_biopsy_ends_when_the_tip_touches_the_lesion) {
  const Outcome made = bodkin(
      "-q case synthesize lumbar lesion --spacing 2 --lesion 20 --procedure ct_guided_biopsy --target lesion "
      "--needle 18,150,chiba");
  ASSERT_EQ(made.exit_code, 0) << made.text();
  const Outcome outcome = bodkin(
      "perform lesion simulated --settings 'speed_mm_s=60 start_mm=5 depth_mm=110 wait_s=0 tremor_mm=0' "
      "--allow-late -o biopsy.bodkin");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  EXPECT_THAT(outcome.text(), HasSubstr("the tip touched the lesion"));
  const ::bodkin::session::Session session = ::bodkin::session::read_session(folder_ / "biopsy.bodkin");
  EXPECT_TRUE(session.finished);
  const double path = session.header.path.length();
  double deepest = 0.0;
  for (const auto& tick : session.ticks) deepest = std::max(deepest, tick.output.depth);
  EXPECT_GT(deepest, path - 11.0) << "the lesion begins 10 mm before its middle";
  EXPECT_LT(deepest, path + 10.0) << "and not 30 mm behind it, where the hand was going";
}

// A simulated hand that continues the withdrawal for 5.5 s after the needle has left the body.
TEST_F(PerformCommand, a_needle_that_is_taken_out_ends_an_acupuncture_and_no_puncture_that_has_missed) {
  ASSERT_EQ(bodkin("-q case synthesize lumbar needled --spacing 2 --procedure acupuncture").exit_code, 0);
  const std::string hand =
      " simulated --settings 'speed_mm_s=30 start_mm=165 depth_mm=15 wait_s=0 tremor_mm=0' --allow-late -o ";
  const Outcome needled = bodkin("perform needled" + hand + "needled.bodkin");
  ASSERT_EQ(needled.exit_code, 0) << needled.text();
  EXPECT_THAT(needled.text(), HasSubstr("the needle was taken out: the attempt is complete"));
  const ::bodkin::session::Session session = ::bodkin::session::read_session(folder_ / "needled.bodkin");
  EXPECT_TRUE(session.finished);
  const auto left = std::find_if(session.ticks.rbegin(), session.ticks.rend(),
                                 [](const auto& tick) { return tick.output.in_contact; });
  const double outside = static_cast<double>(left - session.ticks.rbegin()) * session.header.dt;
  EXPECT_NEAR(outside, 5.0, 0.4) << "s";
  const Outcome served = bodkin("serve needled --port 0" + hand + "served.bodkin");
  EXPECT_EQ(served.exit_code, 0) << served.text();
  EXPECT_THAT(served.text(), HasSubstr("the needle was taken out: the attempt is complete"));

  const Outcome missed = bodkin("perform patient" + hand + "missed.bodkin");
  ASSERT_EQ(missed.exit_code, 0) << missed.text();
  EXPECT_THAT(missed.text(), Not(HasSubstr("was taken out")));
  const ::bodkin::session::Session whole = ::bodkin::session::read_session(folder_ / "missed.bodkin");
  EXPECT_GT(whole.ticks.size(), session.ticks.size() + 500) << "to the end of what the hand does";
}

TEST_F(PerformCommand, records_a_hand_on_a_device_and_the_recording_replays_to_the_bit) {
  const Outcome outcome = bodkin("--json -q perform patient " + device + "--max-time 2 -o hand.bodkin");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  const json said = json::parse(outcome.output);
  EXPECT_EQ(said.at("operator"), "hand");
  const ::bodkin::session::Session session = ::bodkin::session::read_session(folder_ / "hand.bodkin");
  EXPECT_TRUE(session.finished);
  EXPECT_GT(session.ticks.size(), 10u);
  ASSERT_TRUE(session.timings.has_value()) << "how well it kept its time";
  EXPECT_GT(::bodkin::session::count_of(session.timings->compute), 0u);
  EXPECT_LE(::bodkin::session::count_of(session.timings->compute), session.ticks.size());
  EXPECT_EQ(said.at("timings").at("overruns"), session.timings->overruns);
  // The models were created for the held device, as recorded.
  ASSERT_TRUE(session.header.device.has_value());
  EXPECT_NE(session.header.device->profile, "generic");
  const json settings = json::parse(session.header.operator_settings);
  EXPECT_EQ(settings.at("driver"), "force_dimension");
  // The driver's stated delay, and the device's remaining stiffness in our loop of 1 kHz.
  EXPECT_EQ(settings.at("delay_s"), 0.00025);
  EXPECT_THAT(settings.at("delay_source").get<std::string>(), Not(testing::IsEmpty()));
  EXPECT_NEAR(settings.at("force_delay_s").get<double>(), 0.00125, 1e-9);
  EXPECT_GT(settings.at("stiffness_N_per_mm").get<double>(), 0.1);
  EXPECT_LT(settings.at("stiffness_N_per_mm").get<double>(),
            settings.at("published_stiffness_N_per_mm").get<double>());
  const Outcome replay = bodkin("-q replay hand.bodkin");
  EXPECT_EQ(replay.exit_code, 0) << replay.text();
  EXPECT_THAT(replay.output, HasSubstr("identical: "));
}

TEST_F(PerformCommand, scales_are_recorded_and_the_hand_begins_above_the_skin) {
  const Outcome outcome =
      bodkin("--json -q perform patient " + device + "--max-time 1 --scale 2 --force-scale 0.5 -o scaled.bodkin");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  const ::bodkin::session::Session session = ::bodkin::session::read_session(folder_ / "scaled.bodkin");
  const json settings = json::parse(session.header.operator_settings);
  EXPECT_EQ(settings.at("scale"), 2.0);
  EXPECT_EQ(settings.at("force_scale"), 0.5);
  // The patient lies prone, so above the skin is behind it (LPS y).
  const ::bodkin::Vec3 tip = session.ticks.front().input.needle.translation();
  EXPECT_NEAR((tip - session.header.path.entry).y(), 30.0, 10.0) << tip.transpose();
}

TEST_F(PerformCommand, uses_what_was_calibrated_of_the_device_and_says_so) {
  const std::filesystem::path config = folder_.string() + "_config/bodkin";
  std::filesystem::create_directories(config);
  std::ofstream(config / "calibrations.xml")
      << R"(<calibrations version="1"><device driver="force_dimension" model="sigma.7" serial="10204" )"
      << R"(measured_at="2026-11-22T04:30:00Z"><reach low_x_mm="-70" low_y_mm="-60" low_z_mm="-10" )"
      << R"(high_x_mm="30" high_y_mm="60" high_z_mm="50"/></device></calibrations>)";
  const auto first_tip = [](const std::string& more) -> ::bodkin::Vec3 {
    const Outcome outcome =
        bodkin("--json perform patient " + device + "--max-time 1 --overwrite -o a.bodkin " + more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text();
    EXPECT_EQ(outcome.errors.find("calibrated 2026-11-22") != std::string::npos, more.empty()) << outcome.errors;
    return ::bodkin::session::read_session(folder_ / "a.bodkin").ticks.front().input.needle.translation();
  };
  const ::bodkin::Vec3 plain = first_tip("--no-calibration");
  const ::bodkin::Vec3 calibrated = first_tip("");
  std::filesystem::remove(config / "calibrations.xml");
  // The middle is 20 mm to the left and 20 mm up; the hand is therefore 20 mm right (LPS -x) of it and lower (-y).
  EXPECT_NEAR((calibrated - plain - ::bodkin::Vec3(-20.0, -20.0, 0.0)).norm(), 0.0, 1.0)
      << (calibrated - plain).transpose();
}

TEST_F(PerformCommand, keeps_a_session_that_is_there_and_says_what_is_missing) {
  ASSERT_EQ(bodkin("-q perform patient " + device + "--max-time 1 -o kept.bodkin").exit_code, 0);
  const std::string before = text_of("kept.bodkin");
  const Outcome again = bodkin("-q perform patient " + device + "--max-time 1 -o kept.bodkin");
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.errors, HasSubstr("kept.bodkin"));
  EXPECT_EQ(text_of("kept.bodkin"), before);

  const Outcome nothing = bodkin("-q perform patient force_dimension --settings library=/no/such/libdrd.so");
  EXPECT_EQ(nothing.exit_code, 1);
  EXPECT_EQ(lines_of(nothing.errors), 1) << nothing.errors;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "session-by-hand.bodkin"));
}

const std::string quick = "--settings \"speed_mm_s=60 wait_s=0.6\" ";

double deepest(const ::bodkin::session::Session& session) {
  double depth = 0.0;
  for (const ::bodkin::simulation::TickRecord& tick : session.ticks) depth = std::max(depth, tick.output.depth);
  return depth;
}

// 1.5 s at rest, 84 mm in and out at 60 mm/s, 0.6 s at the end of the path, half a second at rest.
TEST_F(PerformCommand, a_simulated_hand_aims_at_the_target_and_ends_by_itself) {
  const Outcome outcome = bodkin("--json -q perform patient simulated " + quick + "-o simulated.bodkin");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  const ::bodkin::session::Session session = ::bodkin::session::read_session(folder_ / "simulated.bodkin");
  EXPECT_TRUE(session.finished);
  const double path = session.header.path.length();
  EXPECT_NEAR(static_cast<double>(session.ticks.size()) * session.header.dt, 2.6 + 2.0 * (path + 30.0) / 60.0, 0.5);
  EXPECT_NEAR(deepest(session), path, 4.0);  // the spring of the hand yields
  double closest = path;
  for (const ::bodkin::simulation::TickRecord& tick : session.ticks) {
    closest = std::min(closest, (tick.input.needle.translation() - session.header.path.target).norm());
  }
  EXPECT_LT(closest, 3.0);
  EXPECT_GT((session.ticks.back().input.needle.translation() - session.header.path.entry).norm(), 29.0);
  // The force acted on the hand: it stayed behind its intended position.
  EXPECT_EQ(session.header.device->profile, "simulated hand");
  EXPECT_THAT(bodkin("-q replay simulated.bodkin").output, HasSubstr("identical: "));
}

TEST_F(PerformCommand, the_users_words_come_before_the_planned_path) {
  const Outcome outcome =
      bodkin("--json -q perform patient simulated --settings \"speed_mm_s=200 wait_s=0 depth_mm=5\" -o short.bodkin");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  const double depth = deepest(::bodkin::session::read_session(folder_ / "short.bodkin"));
  EXPECT_GT(depth, 1.0);
  EXPECT_LT(depth, 10.0);
}

TEST_F(PerformCommand, a_recording_is_a_hand_with_the_same_needle_and_the_same_forces) {
  ASSERT_EQ(bodkin("-q perform patient simulated " + quick + "-o first.bodkin").exit_code, 0);
  const Outcome outcome = bodkin("--json -q perform patient recorded:first.bodkin -o second.bodkin");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  const ::bodkin::session::Session first = ::bodkin::session::read_session(folder_ / "first.bodkin");
  const ::bodkin::session::Session second = ::bodkin::session::read_session(folder_ / "second.bodkin");
  EXPECT_EQ(second.header.device->profile, first.header.device->profile);
  ASSERT_GE(second.ticks.size(), first.ticks.size());
  EXPECT_LT(second.ticks.size(), first.ticks.size() + 2000);
  ASSERT_GT(deepest(second), 30.0);
  double apart = 0.0, force_apart = 0.0;
  for (std::size_t i = 0; i < first.ticks.size(); ++i) {
    const auto &one = first.ticks[i], &other = second.ticks[i];
    apart = std::max(apart, (one.input.needle.translation() - other.input.needle.translation()).norm());
    force_apart = std::max(force_apart, (one.output.requested.force - other.output.requested.force).norm());
  }
  EXPECT_LT(apart, 1e-9);        // mm
  EXPECT_LT(force_apart, 1e-6);  // N
}

TEST_F(PerformCommand, a_hand_of_another_rate_is_refused) {
  std::filesystem::copy(folder_ / "patient", folder_ / "slow", std::filesystem::copy_options::recursive);
  std::string document = text_of("slow/case.xml");
  const std::string rate = "rate_Hz=\"1000\"";
  ASSERT_NE(document.find(rate), std::string::npos);
  write("slow/case.xml", document.replace(document.find(rate), rate.size(), "rate_Hz=\"500\""));
  ASSERT_EQ(bodkin("-q run patient --max-time 1 -o fast.bodkin").exit_code, 0);
  const std::vector<std::pair<std::string, std::string>> refused = {
      {"recorded:fast.bodkin", "fast.bodkin was recorded at 1000 Hz and the case runs at 500 Hz"},
      {"simulated", "add --settings rate_Hz=500"}};
  for (const auto& [hand, sentence] : refused) {
    const Outcome outcome = bodkin("-q perform slow " + hand + " -o refused.bodkin");
    EXPECT_EQ(outcome.exit_code, 2) << outcome.text();
    EXPECT_THAT(outcome.errors, HasSubstr(sentence));
    EXPECT_EQ(lines_of(outcome.errors), 1) << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "refused.bodkin"));
  }
}

TEST_F(PerformCommand, a_bad_recording_is_one_sentence) {
  write("text.bodkin", "this is no session");
  for (const std::string hand : {"recorded", "recorded:none.bodkin", "recorded:text.bodkin"}) {
    const Outcome outcome = bodkin("-q perform patient " + hand);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.text();
    EXPECT_EQ(lines_of(outcome.errors), 1) << outcome.errors;
  }
}

TEST_F(PerformCommand, without_real_time_the_force_of_either_hand_and_of_a_vendors_loop_is_kept_low) {
  const LittleLockedMemory little;
  const std::string of_force_dimension = "library=" BODKIN_MOCKS "/force_dimension/libdrd.so";
  const std::string perform = "perform patient simulated --settings \"speed_mm_s=60 wait_s=0.2\" ";
  const std::string second =
      "--second force_dimension --second-settings " + of_force_dimension + " --second-as probe ";
  const Outcome capped = bodkin(perform + second + "-o capped.bodkin");
  EXPECT_THAT(capped.errors, HasSubstr("second hand: other programs can hold up the force"));
  EXPECT_THAT(capped.errors, HasSubstr("kept below 1.5 N; --allow-late lifts that limit"));
  const Outcome allowed = bodkin(perform + second + "--allow-late -o allowed.bodkin");
  EXPECT_THAT(allowed.errors, HasSubstr("second hand: other programs can hold up the force"));
  EXPECT_THAT(allowed.errors, Not(HasSubstr("kept below 1.5 N")));
  // The vendor's own loop; the note appears before the hand is active.
  const Outcome vendors = bodkin("perform patient openhaptics --max-time 1 --settings library=" BODKIN_MOCKS
                                 "/openhaptics/libHD.so -o vendors.bodkin");
  EXPECT_THAT(vendors.errors, HasSubstr("kept below 1.5 N")) << vendors.text();
}

// The first hand moves to the epidural space and stays; the second one keeps pushing its plunger down.
TEST_F(PerformCommand, a_second_hand_on_the_plunger_feels_the_loss_of_resistance) {
  const Outcome outcome = bodkin(
      "--json -q perform patient simulated --settings \"speed_mm_s=12 wait_s=1\" --second simulated "
      "--second-settings \"speed_mm_s=1 depth_mm=30 tremor_mm=0.02 seed=7\" -o two.bodkin");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  const ::bodkin::session::Session session = ::bodkin::session::read_session(folder_ / "two.bodkin");
  ASSERT_TRUE(session.header.second.has_value());
  EXPECT_EQ(session.header.second->role, ::bodkin::session::SecondRole::plunger);
  EXPECT_EQ(json::parse(session.header.second->device).at("driver"), "simulated");
  ASSERT_GT(session.second.size(), 300u);
  // By the tip's place: the highest pressure in ligament, and the last one of the first stay in the epidural space.
  double in_ligament = 0.0, thumb = 0.0;
  for (const ::bodkin::session::SecondSample& sample : session.second) {
    const auto tick = static_cast<std::size_t>(std::lround(sample.time / session.header.dt));
    if (tick >= session.ticks.size()) break;
    if (session.ticks[tick].output.tissue == ::bodkin::anatomy::tissue::ligamentum_flavum) {
      in_ligament = std::max(in_ligament, sample.pressure);
      thumb = std::max(thumb, sample.force);
    }
  }
  double lowest_after = in_ligament;
  bool lost = false;
  for (const ::bodkin::session::SecondSample& sample : session.second) {
    const auto tick = static_cast<std::size_t>(std::lround(sample.time / session.header.dt));
    if (tick >= session.ticks.size()) break;
    const auto tissue = session.ticks[tick].output.tissue;
    lost = lost || tissue == ::bodkin::anatomy::tissue::epidural_fat ||
           tissue == ::bodkin::anatomy::tissue::cerebrospinal_fluid;
    if (lost) lowest_after = std::min(lowest_after, sample.pressure);
  }
  EXPECT_TRUE(lost);
  EXPECT_GT(in_ligament, 0.005);  // MPa
  EXPECT_GT(thumb, 1.0);          // N
  EXPECT_LT(lowest_after, 0.5 * in_ligament);
  EXPECT_THAT(bodkin("-q replay two.bodkin").output, HasSubstr("identical: "));

  ASSERT_EQ(bodkin("-q export two.bodkin --second plunger.csv").exit_code, 0);
  const std::string table = text_of("plunger.csv");
  EXPECT_EQ(lines_of(table), static_cast<std::ptrdiff_t>(session.second.size()) + 1);
  EXPECT_EQ(table.substr(0, 12), "time_s,x_mm,");
  ASSERT_EQ(bodkin("-q report two.bodkin -o two.html").exit_code, 0);
  EXPECT_THAT(text_of("two.html"), HasSubstr("The second hand: the plunger"));
}

TEST_F(PerformCommand, a_second_hand_holds_a_probe_and_its_fault_leaves_the_needle_alone) {
  const Outcome outcome = bodkin(
      "--json perform patient simulated --settings \"speed_mm_s=60 wait_s=0.5\" --second force_dimension "
      "--second-settings library=" BODKIN_MOCKS "/force_dimension/libdrd.so --second-as probe -o probe.bodkin");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  const ::bodkin::session::Session session = ::bodkin::session::read_session(folder_ / "probe.bodkin");
  EXPECT_EQ(session.header.second->role, ::bodkin::session::SecondRole::probe);
  ASSERT_GT(session.second.size(), 50u);
  EXPECT_NEAR((session.second.front().position - session.header.path.entry).x(), 60.0, 30.0) << "left is LPS +x";

  setenv("BODKIN_MOCK", "unplug@500", 1);
  const Outcome unplugged = bodkin(
      "perform patient simulated --settings \"speed_mm_s=60 wait_s=0.5\" --second force_dimension --second-settings "
      "library=" BODKIN_MOCKS "/force_dimension/libdrd.so -o unplugged.bodkin");
  unsetenv("BODKIN_MOCK");
  ASSERT_EQ(unplugged.exit_code, 0) << unplugged.text();
  EXPECT_THAT(unplugged.errors, HasSubstr("second hand: "));
  EXPECT_GT(deepest(::bodkin::session::read_session(folder_ / "unplugged.bodkin")), 30.0) << "the needle went on";
}

TEST_F(PerformCommand, a_second_device_that_cannot_be_is_one_sentence) {
  const std::vector<std::pair<std::string, std::string>> refused = {
      {"simulated --second-as probe", "--second-as is 'probe', but there is no second device"},
      {"simulated --second-settings a=1", "--second-settings is 'a=1', but there is no second device"},
      {"simulated --second simulated --second-as foot", "--second-as is 'foot'; expected plunger or probe"},
      {"simulated --second mouse", "--second is the mouse"},
      {"haption --second haption", "--second is 'haption', the device that holds the needle"},
      {"simulated --second abacus", "there is no driver 'abacus'"}};
  for (const auto& [words, sentence] : refused) {
    const Outcome outcome = bodkin("-q perform patient " + words + " -o refused.bodkin");
    EXPECT_EQ(outcome.exit_code, 2) << outcome.text();
    EXPECT_THAT(outcome.errors, HasSubstr(sentence));
    EXPECT_EQ(lines_of(outcome.errors), 1) << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "refused.bodkin"));
  }
  const Outcome missing = bodkin(
      "-q perform patient simulated --second force_dimension --second-settings library=/no/such.so -o "
      "refused.bodkin");
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_EQ(lines_of(missing.errors), 1) << missing.errors;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "refused.bodkin"));
}

}  // namespace
}  // namespace bodkin_test
