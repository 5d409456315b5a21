#include "haptics/device_profiles.h"

#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::haptics;
namespace {

DeviceProfile pen() {
  DeviceProfile profile;
  profile.name = "Pen";
  profile.other_names = {"PEN 2"};
  const auto set = [&profile](DeviceQuantity quantity, double value) {
    profile.values[static_cast<std::size_t>(quantity)].value = value;
  };
  set(DeviceQuantity::peak_force, 3.0);
  set(DeviceQuantity::continuous_force, 1.0);
  set(DeviceQuantity::stiffness, 0.7);
  set(DeviceQuantity::workspace_x, 160.0);
  set(DeviceQuantity::workspace_y, 70.0);
  set(DeviceQuantity::workspace_z, 120.0);
  return profile;
}

TEST(DeviceProfiles, are_found_by_any_name_in_any_case) {
  const std::vector<DeviceProfile> profiles = {DeviceProfile{.name = "Arm"}, pen()};
  EXPECT_EQ(find_profile(profiles, "pen"), &profiles[1]);
  EXPECT_EQ(find_profile(profiles, "pen 2"), &profiles[1]);
  EXPECT_EQ(find_profile(profiles, "Pen 3"), nullptr);
  EXPECT_EQ(find_profile(profiles, "Pe"), nullptr);
}

TEST(DeviceProfiles, become_abilities_with_the_workspace_about_its_middle) {
  const DeviceAbilities abilities = abilities_of(pen());
  EXPECT_EQ(abilities.name, "Pen");
  EXPECT_EQ(abilities.peak_force, 3.0);
  EXPECT_EQ(abilities.stiffness, 0.7);
  EXPECT_EQ(abilities.peak_torque, 0.0);
  EXPECT_EQ(abilities.workspace_low, Vec3(-80.0, -35.0, -60.0));
  EXPECT_EQ(abilities.workspace_high, Vec3(80.0, 35.0, 60.0));
}

TEST(DeviceProfiles, fill_in_only_what_the_device_has_not_told) {
  DeviceAbilities told;
  told.peak_force = 0.8;
  told.workspace_high = Vec3(1.0, 2.0, 3.0);
  complete(told, pen());
  EXPECT_EQ(told.peak_force, 0.8);
  EXPECT_EQ(told.continuous_force, 0.8) << "not above the device's own peak";
  EXPECT_EQ(told.workspace_high, Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(told.stiffness, 0.7);
}

}  // namespace
}  // namespace bodkin
