#pragma once

#include <string_view>
#include <vector>

#include "haptics/device.h"
#include "haptics/device_profile.h"

namespace bodkin::haptics {

// The profile of a model by its name or another name of it, ignoring case; null if there is none.
const DeviceProfile* find_profile(const std::vector<DeviceProfile>& profiles, std::string_view model);

// The abilities of a device, as far as its profile states them. The workspace is the box about its middle.
DeviceAbilities abilities_of(const DeviceProfile& profile);

// Fills in values that the device itself did not report (0) from its profile. A continuous force is lowered to the
// device's own peak.
void complete(DeviceAbilities& abilities, const DeviceProfile& profile);

}  // namespace bodkin::haptics
