#include <string>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "training/session_file.h"

namespace bodkin_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

using PerformCommand = PatientCommand;

const std::string device = "force_dimension --settings library=" BODKIN_STAND_INS "/force_dimension/libdrd.so ";

TEST_F(PerformCommand, records_a_hand_on_a_device_and_the_recording_replays_to_the_bit) {
  const Outcome outcome = bodkin("--json -q perform patient " + device + "--max-time 2 -o hand.bodkin");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  const json said = json::parse(outcome.output);
  EXPECT_EQ(said.at("operator"), "hand");
  const ::bodkin::Session session = ::bodkin::read_session(folder_ / "hand.bodkin");
  EXPECT_TRUE(session.finished);
  EXPECT_GT(session.ticks.size(), 10u);
  // The models were made for the device that was held, and the recording says so.
  ASSERT_TRUE(session.header.device.has_value());
  EXPECT_NE(session.header.device->profile, "generic");
  EXPECT_EQ(json::parse(session.header.operator_settings).at("driver"), "force_dimension");
  const Outcome replay = bodkin("-q replay hand.bodkin");
  EXPECT_EQ(replay.exit_code, 0) << replay.text();
  EXPECT_THAT(replay.output, HasSubstr("identical: "));
}

TEST_F(PerformCommand, scales_are_recorded_and_the_hand_begins_above_the_skin) {
  const Outcome outcome =
      bodkin("--json -q perform patient " + device + "--max-time 1 --scale 2 --force-scale 0.5 -o scaled.bodkin");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  const ::bodkin::Session session = ::bodkin::read_session(folder_ / "scaled.bodkin");
  const json settings = json::parse(session.header.operator_settings);
  EXPECT_EQ(settings.at("scale"), 2.0);
  EXPECT_EQ(settings.at("force_scale"), 0.5);
  // The patient lies prone, so above the skin is behind it (LPS y).
  const ::bodkin::Vec3 tip = session.ticks.front().input.needle.translation();
  EXPECT_NEAR((tip - session.header.path.entry).y(), 30.0, 10.0) << tip.transpose();
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

}  // namespace
}  // namespace bodkin_test
