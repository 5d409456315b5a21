#pragma once

#include "core/geometry.h"
#include "haptics/bodkin_driver.h"
#include "haptics/device.h"

namespace bodkin::haptics {

// Between the structures of the C interface to drivers and our own. What a driver says is not believed: numbers that
// are not finite, flags and codes out of range never come through. None of these allocates, save abilities_from.

// A code that we do not know is a vendor error.
DeviceFault fault_from(int result) noexcept;

DeviceAbilities abilities_from(const bodkin_abilities& abilities);

// Fills `state` in place. A pose that is not finite, farther than 10 m away, or whose matrix is not a rotation, is
// bad_data: the hand then stays where it was.
void read_state(const bodkin_state& from, DeviceState& state) noexcept;

// A wrench that is not finite commands nothing.
bodkin_command command_from(const Wrench& wrench) noexcept;

}  // namespace bodkin::haptics
