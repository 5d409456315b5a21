#include "station/real_time_check.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "haptics/calibration_controller.h"
#include "haptics/deadline_clock.h"

namespace bodkin::station {

bool holds_a_hand(const DeviceChoice& choice, const haptics::DeviceAbilities& device) {
  const bool is_played = choice.is_simulated() || choice.is_recorded() || choice.is_mouse();
  return device.peak_force > 0.0 && !is_played;
}

std::string real_time_warning(bool allowed) {
  const std::vector<std::string> refused = haptics::real_time_refusals();
  if (refused.empty()) return {};
  return fmt::format(
      "other programs can hold up the force, which then comes late and can shake the hand{} ({})",
      allowed ? "" : fmt::format(", so it is kept below {:g} N; --allow-late lifts that limit", late_force),
      fmt::join(refused, "; "));
}

bool is_kept_low(const DeviceChoice& choice, const haptics::DeviceAbilities& device, bool allow_late,
                 const char* whose, StationObserver& observer) {
  const std::string warning = holds_a_hand(choice, device) ? real_time_warning(allow_late) : "";
  if (!warning.empty()) observer.note(whose + warning);
  return !warning.empty() && !allow_late;
}

double measuring_force(const DeviceChoice& choice, const haptics::DeviceAbilities& device, bool allow_late,
                       const std::function<void(const std::string& sentence)>& note) {
  const std::string warning = holds_a_hand(choice, device) ? real_time_warning(allow_late) : "";
  if (!warning.empty() && note) note(warning);
  const double usual = haptics::CalibrationController::force_limit;
  return warning.empty() || allow_late ? usual : std::min(usual, late_force);
}

}  // namespace bodkin::station
