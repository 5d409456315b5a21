#include <string>

#include "tests/cli/bodkin_command.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace bodkin_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

const std::string vendor = "--settings library=" BODKIN_STAND_INS "/force_dimension/libdrd.so";
const std::string plug_in = BODKIN_STAND_INS "/plug_in/example_driver.so";

using DevicesListCommand = BodkinCommand;

TEST_F(DevicesListCommand, says_of_every_driver_what_it_finds_or_lacks) {
  const Outcome outcome = bodkin("devices list");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text();
  for (const char* driver : {"openhaptics", "force_dimension", "haption", "spacemouse"}) {
    EXPECT_THAT(outcome.output, HasSubstr(driver));
  }
  const json found = json::parse(bodkin("devices list --json -q").output);
  EXPECT_GE(found.size(), 4u);
  for (const json& driver : found) {
    EXPECT_TRUE(driver.contains("fault") || driver.contains("devices")) << driver;
    if (driver.contains("fault")) {
      EXPECT_FALSE(driver.at("sentence").get<std::string>().empty()) << driver;
    }
  }
}

TEST_F(DevicesListCommand, finds_the_devices_of_one_driver) {
  const json found = json::parse(bodkin("devices list --json -q --driver force_dimension " + vendor).output);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_FALSE(found[0].at("devices").empty()) << found;
  const auto device = found[0].at("devices")[0].at("device").get<std::string>();
  EXPECT_EQ(device.rfind("force_dimension:", 0), 0u) << device;
}

TEST_F(DevicesListCommand, takes_a_driver_of_ones_own) {
  const json found = json::parse(bodkin("devices list --json -q --driver " + plug_in).output);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found[0].at("devices").empty()) << found;
}

}  // namespace
}  // namespace bodkin_test
