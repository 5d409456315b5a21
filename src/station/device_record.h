#pragma once

#include <string>

#include "station/station_options.h"

#include "haptics/device.h"
#include "haptics/device_calibration.h"
#include "haptics/stable_stiffness.h"

namespace bodkin::station {

// What a session keeps of the device that held the needle, JSON.
std::string device_record(const StationOptions& options, const haptics::DeviceAbilities& device,
                          const haptics::StableStiffness& stiffness, const haptics::DeviceCalibration& calibration);

// Whether its needle is to move along its own axis alone once it is in tissue (AxialNeedle): no motor of the device
// holds it. The mouse is a hand of its own that tissue holds back, a recording is to come back as it was, and a real
// needle over a mannequin, which a camera sees, is where it is.
bool moves_along_its_axis(const DeviceChoice& choice, const haptics::DeviceAbilities& device);

}  // namespace bodkin::station
