#include "haptics/plugin.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "haptics/device_port.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

using testing::HasSubstr;

const std::string example_folder = std::string(BODKIN_MOCKS) + "/plug_in";

std::string refusal(const std::string& name) {
  try {
    load_plugin(example_folder + "/" + name);
  } catch (const SystemError& error) {
    return error.what();
  }
  ADD_FAILURE() << name << " was loaded";
  return {};
}

TEST(Plugin, the_example_of_the_documentation_is_a_driver) {
  const bodkin_driver& driver = load_plugin(example_folder + "/example_driver.so");
  EXPECT_STREQ(driver.name, "example");
  const auto found = list_devices(driver, "");
  ASSERT_EQ(found.size(), 1u);
  DevicePort port(driver, found.front().identity, "");
  EXPECT_EQ(port.abilities().name, "Example");
  EXPECT_DOUBLE_EQ(port.abilities().peak_force, 3.0);
  port.start();
  DeviceState state;
  port.exchange({}, state);
  EXPECT_EQ(state.fault, DeviceFault::none);
  EXPECT_TRUE(state.hand.isApprox(Pose::Identity()));
  EXPECT_TRUE(state.velocity.array().isNaN().all());
  port.stop();
}

TEST(Plugin, a_refusal_of_the_example_arrives_in_its_own_words) {
  const bodkin_driver& driver = load_plugin(example_folder + "/example_driver.so");
  try {
    const DevicePort port(driver, "7", "");
    FAIL();
  } catch (const DeviceError& error) {
    EXPECT_EQ(error.fault(), DeviceFault::not_connected);
    EXPECT_STREQ(error.what(), "example: there is no device '7', expected 0");
  }
}

TEST(Plugin, of_another_version_is_refused_in_one_sentence) {
  EXPECT_THAT(refusal("other_version.so"), HasSubstr("speaks version 99 of the driver interface, Bodkin speaks 1"));
  EXPECT_THAT(refusal("silent.so"), HasSubstr("does not speak version 1"));
}

TEST(Plugin, that_leaves_functions_out_is_refused) {
  EXPECT_THAT(refusal("hollow.so"), HasSubstr("leaves out"));
}

TEST(Plugin, that_is_no_driver_is_refused) {
  EXPECT_THAT(refusal("no_entry.so"), HasSubstr("bodkin_driver_entry"));
  EXPECT_THAT(refusal("not_there.so"), HasSubstr("not_there.so"));
}

}  // namespace
}  // namespace bodkin
