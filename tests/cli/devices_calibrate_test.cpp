#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string vendor = " --settings library=" BODKIN_MOCKS "/force_dimension/libdrd.so";

// The behaviour of the hand on the simulated device, while this lives.
struct MockHandMotion {
  explicit MockHandMotion(const char* what) { setenv("BODKIN_MOCK_HAND", what, 1); }
  ~MockHandMotion() { unsetenv("BODKIN_MOCK_HAND"); }
  MockHandMotion(const MockHandMotion&) = delete;
  MockHandMotion& operator=(const MockHandMotion&) = delete;
};

class DevicesCalibrateCommand : public BodkinCommand {
 protected:
  void SetUp() override { std::filesystem::remove(folder_ / "kept.xml"); }

  static Outcome calibrate(const std::string& steps, const std::string& more = "") {
    return bodkin("devices calibrate force_dimension --file kept.xml --countdown 0 --seconds 3 -q --json --steps " +
                  steps + more + vendor);
  }
  static json calibrated(const std::string& steps) {
    const Outcome outcome = calibrate(steps);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.text();
    return outcome.exit_code == 0 ? json::parse(outcome.output) : json::object();
  }
};

TEST_F(DevicesCalibrateCommand, finds_the_box_that_the_hand_reaches) {
  const MockHandMotion wander("wander");
  const json found = calibrated("workspace");
  // 80 x 60 x 100 mm along the vendor's axes; its second axis is the operator's first.
  EXPECT_NEAR(found.at("reach_high_mm")[0].get<double>(), 30.0, 3.0);
  EXPECT_NEAR(found.at("reach_low_mm")[1].get<double>(), -40.0, 3.0);
  EXPECT_NEAR(found.at("reach_high_mm")[2].get<double>(), 50.0, 3.0);
}

TEST_F(DevicesCalibrateCommand, finds_the_tip_and_keeps_what_it_found_before) {
  {
    const MockHandMotion sweep("sweep");
    // To the device's right; the user's motion is straight away.
    EXPECT_NEAR(calibrated("mounting").at("mounting_deg").get<double>(), 90.0, 0.5);
  }
  const MockHandMotion swivel("swivel");
  const json found = calibrated("tip");
  const json& tip = found.at("tip_offset_mm");
  const double length = std::hypot(tip[0].get<double>(), tip[1].get<double>(), tip[2].get<double>());
  EXPECT_NEAR(length, 50.0, 0.05);
  EXPECT_LT(found.at("tip_residual_mm").get<double>(), 0.05);
  EXPECT_NEAR(found.at("mounting_deg").get<double>(), 90.0, 0.5) << "the step before is still there";

  const Outcome shown = bodkin("devices calibrate force_dimension --file kept.xml --show -q" + vendor);
  EXPECT_EQ(shown.exit_code, 0) << shown.text();
  EXPECT_THAT(shown.output, HasSubstr("turned by 90"));
  EXPECT_EQ(bodkin("devices calibrate force_dimension --file kept.xml --forget -q" + vendor).exit_code, 0);
  const Outcome gone = bodkin("devices calibrate force_dimension --file kept.xml --show -q" + vendor);
  EXPECT_EQ(gone.exit_code, 2);
  EXPECT_THAT(gone.errors, HasSubstr("holds no calibration of sigma.7"));
  EXPECT_EQ(lines_of(gone.errors), 1) << gone.errors;
}

TEST_F(DevicesCalibrateCommand, weighs_a_handle_that_nobody_holds) {
  const MockHandMotion nothing("gone");
  const json found = calibrated("weight");
  EXPECT_NEAR(found.at("weight_N").get<double>(), 0.6, 0.06);
  EXPECT_LT(found.at("friction_N").get<double>(), 0.1);
}

TEST_F(DevicesCalibrateCommand, measures_how_late_a_force_comes_to_a_hand_that_holds_it_loosely) {
  const MockHandMotion loose("loose");
  Outcome outcome;
  // On a busy machine the pulses may be too uneven to measure; the command then reports it.
  for (int attempt = 0; attempt < 5 && outcome.exit_code != 0; ++attempt) outcome = calibrate("delay");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text();
  // The mock's motors follow a command within some 2 ms, and it has no other delay.
  EXPECT_LT(json::parse(outcome.output).at("delay_s").get<double>(), 0.006);
}

TEST_F(DevicesCalibrateCommand, without_real_time_the_force_that_weighs_is_kept_low_and_a_note_says_so) {
  const LittleLockedMemory little;
  const MockHandMotion nothing("gone");
  const std::string weigh =
      "devices calibrate force_dimension --file kept.xml --countdown 0 --seconds 3 --steps weight" + vendor;
  EXPECT_THAT(bodkin(weigh).errors, HasSubstr("kept below 1.5 N; --allow-late lifts that limit"));
  const Outcome allowed = bodkin(weigh + " --allow-late");
  EXPECT_THAT(allowed.errors, HasSubstr("other programs can hold up the force"));
  EXPECT_THAT(allowed.errors, Not(HasSubstr("kept below 1.5 N")));
  // Steps that need no force arm none.
  const MockHandMotion wander("wander");
  const Outcome no_force = bodkin(
      "devices calibrate force_dimension --file kept.xml --countdown 0 --seconds 3 --steps workspace" + vendor);
  EXPECT_THAT(no_force.errors, Not(HasSubstr("other programs can hold up the force")));
}

TEST_F(DevicesCalibrateCommand, a_hand_that_does_something_else_is_told_so_and_nothing_is_kept) {
  const auto refused = [](const std::string& steps) {
    const Outcome outcome = calibrate(steps);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.text();
    EXPECT_EQ(lines_of(outcome.errors), 1) << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "kept.xml"));
    return outcome.errors;
  };
  EXPECT_THAT(refused("workspace"), HasSubstr("every corner"));
  EXPECT_THAT(refused("tip"), HasSubstr("swivel it wider"));
  EXPECT_THAT(refused("mounting"), HasSubstr("straight away from you"));
  EXPECT_THAT(refused("weight"), HasSubstr("the handle"));
  EXPECT_THAT(refused("colour"),
              HasSubstr("'colour' is not a step, expected workspace, mounting, tip, axis, weight"));
}

TEST_F(DevicesCalibrateCommand, a_damaged_file_is_refused_and_left_alone) {
  write("kept.xml", "<calibrations version=\"1\"><device/></calibrations>");
  const Outcome outcome = calibrate("axis");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("kept.xml"));
  EXPECT_EQ(text_of("kept.xml"), "<calibrations version=\"1\"><device/></calibrations>");
}

TEST_F(DevicesCalibrateCommand, a_signal_ends_it_and_nothing_is_kept) {
  const std::string begin = "'" BODKIN_BUILD "/bin/bodkin' devices ";
  for (const auto& [signal, code] : {std::pair{"INT", 130}, {"HUP", 129}, {"TERM", 143}}) {
    for (const std::string command :
         {"calibrate force_dimension --file kept.xml --countdown 0 --seconds 60 --steps workspace",
          "check force_dimension --protocol kept.xml --seconds 60"}) {
      // A step has begun once its instruction appears. The previous one is gone when the script looks.
      write("end.sh", ": > end.log\n" + begin + command + vendor + " > end.log 2>&1 &\nfor wait in $(seq 600); do " +
                          "grep -q 'ove the handle\\|eave the handle' end.log && break; sleep 0.1; done\nkill -" +
                          std::string(signal) + " $!\nwait $!\n");
      const std::string line = "cd '" + folder_.string() + "' && bash end.sh";
      const int status = std::system(line.c_str());
      EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, code) << command << text_of("end.log");
      EXPECT_THAT(text_of("end.log"), HasSubstr("was interrupted"));
      EXPECT_FALSE(std::filesystem::exists(folder_ / "kept.xml"));
    }
  }
}

}  // namespace
}  // namespace bodkin_test
