#include "haptics/drivers/haply_inventory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/drivers/driver_adapter.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(HaplyVersion, is_read_from_what_the_service_tells) {
  const HaplyVersion version = parse_haply_version(
      R"({"project_version":"3.5.1","git_tag":"v9.9","project_name":"haply-inverse-service","git_hash":"abc"})");
  EXPECT_EQ(version.major, 3);
  EXPECT_EQ(version.minor, 5);
  EXPECT_EQ(version.text, "3.5.1");
  EXPECT_EQ(parse_haply_version(R"({"git_tag":"v4.10-rc1"})").minor, 10);
  EXPECT_EQ(parse_haply_version(R"({"project_version":"3"})").major, 3);
}

TEST(HaplyVersion, of_something_else_is_refused) {
  for (const char* body :
       {"", "<html>", "[]", "{}", R"({"project_version":35})", R"({"project_version":"new"})",
        R"({"project_version":"3.5","project_name":"printer"})", R"({"project_version":"99999999999999999999"})"}) {
    EXPECT_THROW(parse_haply_version(body), DriverFailure) << body;
  }
  try {
    parse_haply_version(R"({"project_version":"3.5","project_name":"printer"})");
  } catch (const DriverFailure& failure) {
    EXPECT_THAT(failure.what(), HasSubstr("'printer'"));
  }
}

TEST(HaplyInventory, names_devices_and_grips) {
  const HaplyInventory inventory = parse_haply_inventory(R"({"session_id":3,"inverse3":[
      {"device_id":"04BA","config":{"type":"inverse3x","basis":{"permutation":"XYZ"}},"status":{"calibrated":true}},
      {"device_id":"0001","status":{"calibrated":false}},{"device_id":"bad \"one\""},{"device_id":7},{},null],
      "verse_grip":[{"device_id":"9"}],"wireless_verse_grip":[{"device_id":"61576"}]})");
  ASSERT_EQ(inventory.devices.size(), 2u);
  EXPECT_EQ(inventory.devices[0].identity, "04BA");
  EXPECT_EQ(inventory.devices[0].model, "Inverse3x");
  EXPECT_TRUE(inventory.devices[0].calibrated);
  EXPECT_EQ(inventory.devices[0].moved, "");
  EXPECT_EQ(inventory.devices[1].model, "Inverse3");
  EXPECT_FALSE(inventory.devices[1].calibrated);
  EXPECT_THAT(inventory.grips, ElementsAre("9", "61576"));
}

TEST(HaplyInventory, may_be_empty) {
  for (const char* text :
       {"{}", R"({"inverse3":[]})", R"({"inverse3":null,"verse_grip":5})", R"({"inverse3":"x"})"}) {
    const HaplyInventory inventory = parse_haply_inventory(text);
    EXPECT_TRUE(inventory.devices.empty() && inventory.grips.empty()) << text;
  }
}

TEST(HaplyInventory, tells_of_axes_that_are_not_the_vendors) {
  const auto moved = [](const std::string& rest) {
    return parse_haply_inventory(R"({"inverse3":[{"device_id":"1",)" + rest + "}]}").devices.at(0).moved;
  };
  EXPECT_EQ(moved(R"("config":{"basis":{"permutation":"XZY"}})"), "the basis XZY");
  EXPECT_EQ(moved(R"("state":{"transform":{"position":{"x":0,"y":0,"z":0},"rotation":{"w":1,"x":0,"y":0,"z":0},
                                           "scale":{"x":1,"y":1,"z":1}}})"),
            "");
  EXPECT_NE(moved(R"("state":{"transform":{"position":{"x":0.01}}})"), "");
  EXPECT_NE(moved(R"("state":{"transform":{"rotation":{"w":0,"z":1}}})"), "");
  EXPECT_NE(moved(R"("state":{"transform":{"scale":{"y":2}}})"), "");
}

TEST(HaplyInventory, that_is_none_is_refused) {
  for (const char* text : {"", "[]", "{", "7", "{\"inverse3\":[}"}) {
    EXPECT_THROW(parse_haply_inventory(text), DriverFailure) << text;
  }
}

}  // namespace
}  // namespace bodkin
