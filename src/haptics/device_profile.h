#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bodkin::haptics {

// A number that a device is known for. 0 where nothing is known.
enum class DeviceQuantity : std::uint8_t {
  peak_force,        // N
  continuous_force,  // N
  peak_torque,       // N mm
  stiffness,         // N/mm that it renders stably
  damping,           // N s/mm
  resolution,        // mm
  workspace_x,       // mm, side of the usable box: to the operator's right,
  workspace_y,       // away from the operator,
  workspace_z,       // up
  friction,          // N, to be overcome at the handle
  inertia            // kg, apparent at the handle
};
inline constexpr std::size_t device_quantities = 11;

// How far a number can be relied on.
enum class Provenance : std::uint8_t {
  unknown,    // no number was found
  paper,      // printed in a publication
  looked_up,  // read in a stored copy of the source
  recalled,   // from memory of the source, to be checked
  derived     // computed from such a number
};

// One number with where it comes from.
struct ProfileValue {
  double value = 0.0;
  Provenance provenance = Provenance::unknown;
  std::string source;
  std::string remark;
};

// What is known of a model of device beforehand; what the device itself reports counts more.
struct DeviceProfile {
  std::string name;                      // "Touch"
  std::vector<std::string> other_names;  // what its driver may call it: "PHANTOM Omni"
  std::array<ProfileValue, device_quantities> values;

  const ProfileValue& of(DeviceQuantity quantity) const { return values[static_cast<std::size_t>(quantity)]; }
};

}  // namespace bodkin::haptics
