#include <cstdlib>
#include <string>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

const std::string check_vendor = "--settings library=" BODKIN_MOCKS "/force_dimension/libdrd.so";

// A fault of the simulated device, while this lives.
struct Trouble {
  explicit Trouble(const char* what) { setenv("BODKIN_MOCK", what, 1); }
  ~Trouble() { unsetenv("BODKIN_MOCK"); }
  Trouble(const Trouble&) = delete;
  Trouble& operator=(const Trouble&) = delete;
};

using DevicesCheckCommand = BodkinCommand;

TEST_F(DevicesCheckCommand, counts_rounds_and_asks_for_no_force) {
  const Outcome outcome = bodkin("devices check force_dimension --seconds 1 --json -q " + check_vendor);
  // On a busy machine the device is rightly reported not ready: too many rounds are late.
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 3) << outcome.text();
  const json seen = json::parse(outcome.output);
  EXPECT_GT(seen.at("rounds").get<int>(), 10);
  EXPECT_EQ(seen.at("strongest_force_N"), 0.0);
  EXPECT_GT(seen.at("peak_force_N"), 0.0);
  EXPECT_EQ(seen.at("ready").get<bool>(), outcome.exit_code == 0);
  EXPECT_EQ(seen.contains("why_not"), outcome.exit_code == 3);
}

TEST_F(DevicesCheckCommand, drives_a_service_in_another_program) {
  // The service ends with its standard input, which the shell's pipe holds open for as long as the check may take.
  const std::string port = (folder_ / "port").string();
  const std::string line = "sleep 6 | '" BODKIN_MOCKS "/haply/haply_service' > '" + port +
                           "' & for wait in $(seq 50); do test -s '" + port + "' && break; sleep 0.1; done";
  ASSERT_EQ(std::system(line.c_str()), 0);
  const Outcome outcome = bodkin("devices check haply --seconds 1 --json -q --settings port=" +
                                 std::to_string(std::stoi(text_of("port"))));
  const json seen = json::parse(outcome.output);
  EXPECT_EQ(seen.at("name"), "Inverse3");
  EXPECT_GT(seen.at("rounds").get<int>(), 10);
  EXPECT_EQ(seen.at("strongest_force_N"), 0.0);
}

TEST_F(DevicesCheckCommand, says_which_fault_makes_a_device_unfit) {
  const Trouble unplugged("unplug@100");
  const Outcome outcome = bodkin("devices check force_dimension --seconds 2 -q " + check_vendor);
  EXPECT_EQ(outcome.exit_code, 3) << outcome.text();
  EXPECT_THAT(outcome.output, HasSubstr("not ready: "));
}

TEST_F(DevicesCheckCommand, takes_a_simulated_hand) {
  const Outcome outcome = bodkin("devices check simulated --seconds 1 --json -q");
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 3) << outcome.text();
  EXPECT_EQ(json::parse(outcome.output).at("name"), "simulated hand");
}

// A hand that goes along the vendor's second axis, 80 mm to the operator's right.
TEST_F(DevicesCheckCommand, leads_through_the_protocol_and_writes_what_it_saw) {
  setenv("BODKIN_MOCK_HAND", "sweep", 1);
  const Outcome outcome =
      bodkin("devices check force_dimension --protocol seen.json --without-force --seconds 0.5 " + check_vendor);
  unsetenv("BODKIN_MOCK_HAND");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text();
  EXPECT_THAT(outcome.output, HasSubstr("away: Move it 5 cm or more straight away from you"));
  EXPECT_THAT(outcome.output, HasSubstr("seen.json"));
  const json seen = json::parse(text_of("seen.json"));
  EXPECT_EQ(seen.at("driver"), "force_dimension");
  EXPECT_EQ(seen.at("device").at("name"), "sigma.7");
  EXPECT_FALSE(seen.contains("force"));
  ASSERT_GE(seen.at("steps").size(), 8U);
  bool asked_away = false;
  for (const json& step : seen.at("steps")) {
    EXPECT_EQ(step.at("strongest_force_N"), 0.0) << step;
    EXPECT_GT(step.at("rounds").get<int>(), 0) << step;
    if (step.at("step") != "away") continue;
    asked_away = true;
    EXPECT_NE(step.at("against"), "") << "this hand goes nowhere that it is asked to";
  }
  EXPECT_TRUE(asked_away);
}

TEST_F(DevicesCheckCommand, the_protocol_pushes_a_hand_gently_and_keeps_the_force_low_without_real_time) {
  const LittleLockedMemory little;
  setenv("BODKIN_MOCK_HAND", "loose", 1);
  const Outcome outcome =
      bodkin("devices check force_dimension --protocol weighed.json --seconds 0.4 " + check_vendor);
  unsetenv("BODKIN_MOCK_HAND");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text();
  EXPECT_THAT(outcome.errors, HasSubstr("kept below 1.5 N"));
  const json seen = json::parse(text_of("weighed.json"));
  const json& force = seen.at("force");
  // A missing result, as on a machine that delays the loop, is a sentence.
  EXPECT_TRUE(force.contains("weight_N") || force.contains("weight_against"));
  EXPECT_TRUE(force.contains("delay_s") || force.contains("delay_against"));
}

TEST_F(DevicesCheckCommand, the_protocol_keeps_what_the_device_says_against_it) {
  const Trouble unplugged("unplug@300");
  const Outcome outcome =
      bodkin("devices check force_dimension --protocol seen.json --without-force --seconds 0.3 -q " + check_vendor);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text();
  std::size_t faults = 0;
  const json seen = json::parse(text_of("seen.json"));
  for (const json& step : seen.at("steps")) faults += step.at("faults").size();
  EXPECT_GT(faults, 0U);
}

TEST_F(DevicesCheckCommand, of_what_is_not_there_is_one_sentence) {
  const Outcome missing = bodkin("devices check force_dimension --settings library=/no/such/libdrd.so");
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_THAT(missing.errors, HasSubstr("/no/such/libdrd.so"));
  EXPECT_EQ(lines_of(missing.errors), 1) << missing.errors;

  const Outcome unknown = bodkin("devices check phantom");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.errors, HasSubstr("there is no driver 'phantom'; expected "));
  EXPECT_EQ(lines_of(unknown.errors), 1) << unknown.errors;

  const Trouble nothing("no_device");
  const Outcome absent = bodkin("devices check force_dimension " + check_vendor);
  EXPECT_EQ(absent.exit_code, 1);
  EXPECT_EQ(lines_of(absent.errors), 1) << absent.errors;
}

}  // namespace
}  // namespace bodkin_test
