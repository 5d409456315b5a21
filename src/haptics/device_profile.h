#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bodkin::haptics {

// A known quantity of a device. 0: unknown.
enum class DeviceQuantity : std::uint8_t {
  peak_force,        // N
  continuous_force,  // N
  peak_torque,       // N mm
  stiffness,         // N/mm, rendered stably
  damping,           // N s/mm
  resolution,        // mm
  workspace_x,       // mm, side of the usable box: to the operator's right,
  workspace_y,       // away from the operator,
  workspace_z,       // up
  friction,          // N, to be overcome at the handle
  inertia            // kg, apparent at the handle
};
inline constexpr std::size_t device_quantities = 11;

// How reliable a number is.
enum class Provenance : std::uint8_t {
  unknown,    // no number was found
  paper,      // printed in a publication
  looked_up,  // read in a stored copy of the source
  recalled,   // from memory of the source, to be checked
  derived     // computed from such a number
};

// One number with its source.
struct ProfileValue {
  double value = 0.0;
  Provenance provenance = Provenance::unknown;
  std::string source;
  std::string remark;
};

// Prior knowledge of a model of device; values that the device itself reports take precedence.
struct DeviceProfile {
  std::string name;                      // "Touch"
  std::vector<std::string> other_names;  // used by its driver: "PHANTOM Omni"
  std::array<ProfileValue, device_quantities> values;

  const ProfileValue& of(DeviceQuantity quantity) const { return values[static_cast<std::size_t>(quantity)]; }
};

}  // namespace bodkin::haptics
