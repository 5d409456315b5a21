// bodkin devices touch, and a session with a device that is registered to a mannequin.
#include <cstdlib>
#include <fstream>
#include <string>

#include "session/session_file.h"
#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string touched_device = " --settings library=" BODKIN_MOCKS "/force_dimension/libdrd.so";

class DevicesTouchCommand : public PatientCommand {
 protected:
  static Outcome touch(const std::string& more) {
    return bodkin("devices touch force_dimension -q --json --countdown 0 -o touched.csv " + more + touched_device);
  }
};

// The mock's hand turns the tool about a point 50 mm along its third axis, as in the hole of a mock table.
TEST_F(DevicesTouchCommand, finds_the_hole_in_which_the_needle_turns) {
  setenv("XDG_CONFIG_HOME", (folder_ / "config").c_str(), 1);
  const Outcome unknown = touch("--points hole,left,right");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.errors, HasSubstr("--steps tip,axis"));
  setenv("BODKIN_MOCK_HAND", "swivel", 1);
  const Outcome calibrated =
      bodkin("devices calibrate force_dimension -q --countdown 0 --seconds 3 --steps tip" + touched_device);
  EXPECT_EQ(calibrated.exit_code, 0) << calibrated.text();
  const Outcome outcome = touch("--points hole,left,right");
  unsetenv("BODKIN_MOCK_HAND");
  unsetenv("XDG_CONFIG_HOME");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  const json found = json::parse(outcome.output);
  ASSERT_EQ(found.at("points").size(), 3U);
  for (const json& point : found.at("points")) {
    EXPECT_LT(point.at("spread_mm").get<double>(), 0.5);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(point.at("place_mm")[axis].get<double>(), found.at("points")[0].at("place_mm")[axis].get<double>(),
                  0.5);
  }
  EXPECT_THAT(text_of("touched.csv"), HasSubstr("name,x,y,z\nhole,"));
}

TEST_F(DevicesTouchCommand, refuses_names_that_are_none_and_a_tip_that_moves) {
  for (const char* wrong : {"--points a,b", "--points a,b,b", "--points 'a,,b'"}) {
    const Outcome refused = touch(std::string(wrong) + " --no-calibration");
    EXPECT_EQ(refused.exit_code, 2) << wrong;
    EXPECT_THAT(refused.errors, HasSubstr("--points")) << wrong;
  }
  std::filesystem::remove(folder_ / "touched.csv");
  setenv("BODKIN_MOCK_HAND", "wander", 1);
  const Outcome moved = touch("--points a,b,c --no-calibration");
  unsetenv("BODKIN_MOCK_HAND");
  EXPECT_EQ(moved.exit_code, 2) << moved.text();
  EXPECT_THAT(moved.errors, HasSubstr("the tip moved by"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "touched.csv"));
}

// The simulated hand begins in the middle of its workspace: there the patient is at the registered place.
TEST_F(DevicesTouchCommand, the_needle_of_a_session_is_where_the_registration_says) {
  std::ofstream(folder_ / "placed.json") << R"({"fixed_from_moving":[-1,0,0,10, 0,0,1,120, 0,1,0,-20, 0,0,0,1],)"
                                         << R"("scale":1.0,"fre_rms_mm":0.3})";
  const std::string perform =
      "-q perform patient simulated --settings 'tremor_mm=0 tilt_deg=0 side_deg=0' --max-time 1 "
      "--overwrite -o on.bodkin ";
  const Outcome outcome = bodkin(perform + "--mannequin placed.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  const ::bodkin::session::Session session = ::bodkin::session::read_session(folder_ / "on.bodkin");
  ASSERT_FALSE(session.ticks.empty());
  EXPECT_LT((session.ticks.front().input.needle.translation() - ::bodkin::Vec3(10, 120, -20)).norm(), 1e-6);
  EXPECT_THAT(session.header.operator_settings, HasSubstr("patient_from_hand"));

  const Outcome hub = bodkin(perform + "--mannequin placed.json --hub");
  ASSERT_EQ(hub.exit_code, 0) << hub.text();
  const ::bodkin::session::Session at_hub = ::bodkin::session::read_session(folder_ / "on.bodkin");
  const ::bodkin::Pose& needle = at_hub.ticks.front().input.needle;
  const ::bodkin::Vec3 in_front = needle.translation() - ::bodkin::Vec3(10, 120, -20);
  EXPECT_GT(in_front.norm(), 50.0) << "the length of a spinal needle";
  EXPECT_LT((in_front - in_front.norm() * needle.linear().col(2)).norm(), 1e-6) << "along the needle";

  std::ofstream(folder_ / "wrong.json") << R"({"fixed_from_moving":[1,0,0]})";
  for (const auto& [options, words] : {std::pair{"--mannequin wrong.json", "not a rigid placement"},
                                       {"--mannequin none.json", "none.json"},
                                       {"--mannequin placed.json --scale 2", "leave out --scale"},
                                       {"--hub", "--hub needs --mannequin"}}) {
    const Outcome refused = bodkin(perform + options);
    EXPECT_EQ(refused.exit_code, 2) << options;
    EXPECT_THAT(refused.errors, HasSubstr(words)) << options;
  }
}

}  // namespace
}  // namespace bodkin_test
