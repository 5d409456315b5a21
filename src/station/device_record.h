#pragma once

#include <string>

#include "station/station_options.h"

#include "haptics/device.h"
#include "haptics/device_calibration.h"
#include "haptics/stable_stiffness.h"

namespace bodkin::station {

// The record of the needle's device in a session, JSON.
std::string device_record(const StationOptions& options, const haptics::DeviceAbilities& device,
                          const haptics::StableStiffness& stiffness, const haptics::DeviceCalibration& calibration);

// Whether its needle may move only along its own axis in tissue (AxialNeedle), because no motor holds it. Exceptions
// are the mouse, a simulated hand that tissue holds back; a recording, which must be reproduced; and a real needle
// over a mannequin, seen by a camera.
bool moves_along_its_axis(const DeviceChoice& choice, const haptics::DeviceAbilities& device);

}  // namespace bodkin::station
