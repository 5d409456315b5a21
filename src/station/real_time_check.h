#pragma once

#include <functional>
#include <string>

#include "station/device_choice.h"
#include "station/station_observer.h"

#include "haptics/device.h"

namespace bodkin::station {

// N that a device may give at most while the system does not run its servo ahead of other programs.
inline constexpr double late_force = 1.5;

// Whether a person's hand is to be held by motors. A vendor's own loop counts, too: our tick runs in it, and what the
// system grants a thread of this program it grants the vendor's in it.
bool holds_a_hand(const DeviceChoice& choice, const haptics::DeviceAbilities& device);

// Where the system grants no real-time priority or does not lock memory: one sentence that says what this means and
// how to get them. Empty where it does. `allowed`: the user has said that he knows, and no cap is put on the force.
std::string real_time_warning(bool allowed);

// Tells the observer, and says whether the force of a device that holds a hand is to be kept low. `whose`: put before
// the sentence.
bool is_kept_low(const DeviceChoice& choice, const haptics::DeviceAbilities& device, bool allow_late,
                 const char* whose, StationObserver& observer);

// N that the motors may give at most while a device is weighed and its delay measured:
// CalibrationController::force_limit, or late_force where a hand is held and the system may hold up the servo. Then
// `note` is told, unless it is empty.
double measuring_force(const DeviceChoice& choice, const haptics::DeviceAbilities& device, bool allow_late,
                       const std::function<void(const std::string& sentence)>& note);

}  // namespace bodkin::station
