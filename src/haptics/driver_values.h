#pragma once

#include "core/geometry.h"
#include "haptics/bodkin_driver.h"
#include "haptics/device.h"

namespace bodkin::haptics {

// Conversion between the structures of the C interface to drivers and ours. A driver's values are validated: numbers
// that are not finite, and flags and codes out of range, are never passed on. None of these functions allocates,
// except abilities_from.

// An unknown code becomes a vendor error.
DeviceFault fault_from(int result) noexcept;

DeviceAbilities abilities_from(const bodkin_abilities& abilities);

// Fills `state` in place. A pose that is not finite, farther than 10 m away, or whose matrix is not a rotation, is
// bad_data: the hand then keeps its last pose.
void read_state(const bodkin_state& from, DeviceState& state) noexcept;

// A wrench that is not finite becomes zero.
bodkin_command command_from(const Wrench& wrench) noexcept;

}  // namespace bodkin::haptics
