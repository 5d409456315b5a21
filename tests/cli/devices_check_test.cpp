#include <cstdlib>
#include <string>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

const std::string vendor = "--settings library=" BODKIN_STAND_INS "/force_dimension/libdrd.so";

// A trouble of the simulated device, for as long as this lives.
struct Trouble {
  explicit Trouble(const char* what) { setenv("BODKIN_STAND_IN", what, 1); }
  ~Trouble() { unsetenv("BODKIN_STAND_IN"); }
  Trouble(const Trouble&) = delete;
  Trouble& operator=(const Trouble&) = delete;
};

using DevicesCheckCommand = BodkinCommand;

TEST_F(DevicesCheckCommand, counts_rounds_and_asks_for_no_force) {
  const Outcome outcome = bodkin("devices check force_dimension --seconds 1 --json -q " + vendor);
  // On a busy machine the device is rightly called not ready: too many rounds are late.
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 3) << outcome.text();
  const json seen = json::parse(outcome.output);
  EXPECT_GT(seen.at("rounds").get<int>(), 10);
  EXPECT_EQ(seen.at("strongest_force_N"), 0.0);
  EXPECT_GT(seen.at("peak_force_N"), 0.0);
  EXPECT_EQ(seen.at("ready").get<bool>(), outcome.exit_code == 0);
  EXPECT_EQ(seen.contains("why_not"), outcome.exit_code == 3);
}

TEST_F(DevicesCheckCommand, says_which_fault_makes_a_device_unfit) {
  const Trouble unplugged("unplug@100");
  const Outcome outcome = bodkin("devices check force_dimension --seconds 2 -q " + vendor);
  EXPECT_EQ(outcome.exit_code, 3) << outcome.text();
  EXPECT_THAT(outcome.output, HasSubstr("not ready: "));
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
  const Outcome absent = bodkin("devices check force_dimension " + vendor);
  EXPECT_EQ(absent.exit_code, 1);
  EXPECT_EQ(lines_of(absent.errors), 1) << absent.errors;
}

}  // namespace
}  // namespace bodkin_test
