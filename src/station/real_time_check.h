#pragma once

#include <functional>
#include <string>

#include "station/device_choice.h"
#include "station/station_observer.h"

#include "haptics/device.h"

namespace bodkin::station {

// N, largest force of a device while the system does not grant its servo priority over other programs.
inline constexpr double late_force = 1.5;

// Whether motors will act on a person's hand. A vendor's own loop counts too: our tick runs in it, and the system
// grants it the same as a thread of this program.
bool holds_a_hand(const DeviceChoice& choice, const haptics::DeviceAbilities& device);

// If the system refuses real-time priority or locked memory: one sentence that says what this means and how to get
// them. Otherwise empty. `allowed`: the user has accepted this, and the force is not capped.
std::string real_time_warning(bool allowed);

// Notifies the observer, and returns whether the force of a device held by a hand is to be capped. `whose`: prefix of
// the sentence.
bool is_kept_low(const DeviceChoice& choice, const haptics::DeviceAbilities& device, bool allow_late,
                 const char* whose, StationObserver& observer);

// N, largest force of the motors while a handle's weight and the delay are measured:
// CalibrationController::force_limit, or late_force if a hand is held and the system may delay the servo. Then `note`
// is called, unless it is empty.
double measuring_force(const DeviceChoice& choice, const haptics::DeviceAbilities& device, bool allow_late,
                       const std::function<void(const std::string& sentence)>& note);

}  // namespace bodkin::station
