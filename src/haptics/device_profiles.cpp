#include "haptics/device_profiles.h"

#include <algorithm>
#include <cctype>

namespace bodkin::haptics {

namespace {

bool same_name(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

const DeviceProfile* find_profile(const std::vector<DeviceProfile>& profiles, std::string_view model) {
  for (const DeviceProfile& profile : profiles) {
    if (same_name(profile.name, model)) return &profile;
    for (const std::string& name : profile.other_names) {
      if (same_name(name, model)) return &profile;
    }
  }
  return nullptr;
}

DeviceAbilities abilities_of(const DeviceProfile& profile) {
  DeviceAbilities abilities;
  abilities.name = profile.name;
  complete(abilities, profile);
  return abilities;
}

void complete(DeviceAbilities& abilities, const DeviceProfile& profile) {
  const auto fill = [&profile](double& value, DeviceQuantity quantity) {
    if (value == 0.0) value = profile.of(quantity).value;
  };
  fill(abilities.peak_force, DeviceQuantity::peak_force);
  fill(abilities.continuous_force, DeviceQuantity::continuous_force);
  fill(abilities.peak_torque, DeviceQuantity::peak_torque);
  fill(abilities.stiffness, DeviceQuantity::stiffness);
  fill(abilities.damping, DeviceQuantity::damping);
  fill(abilities.resolution, DeviceQuantity::resolution);
  abilities.continuous_force = std::min(abilities.continuous_force, abilities.peak_force);
  const Vec3 box(profile.of(DeviceQuantity::workspace_x).value, profile.of(DeviceQuantity::workspace_y).value,
                 profile.of(DeviceQuantity::workspace_z).value);
  if (abilities.workspace_low.isZero(0.0) && abilities.workspace_high.isZero(0.0) && box.minCoeff() > 0.0) {
    abilities.workspace_low = -0.5 * box;
    abilities.workspace_high = 0.5 * box;
  }
}

}  // namespace bodkin::haptics
