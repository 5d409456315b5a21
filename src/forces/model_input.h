#pragma once

#include <cmath>
#include <string_view>

#include "core/axial_motion.h"
#include "core/settings_check.h"

namespace bodkin {

// What every force model does with its settings and its input before it trusts them.

// Throws InputError, naming model, setting, value, unit and the allowed range, unless low <= value <= high. NaN is
// always refused.
void check_setting(std::string_view model, std::string_view setting, std::string_view unit, double value, double low,
                   double high);

// Motions beyond these are no needle in a hand: a sensor or a driver failed. A model answers them with zero force, a
// `fault` event and an unchanged state.
inline constexpr double farthest_depth = 1e4;  // mm
inline constexpr double fastest_motion = 1e6;  // mm/s

// False for NaN, infinities and motions beyond the limits above.
inline bool usable(const AxialMotion& motion) noexcept {
  return std::abs(motion.depth) <= farthest_depth && std::abs(motion.velocity) <= fastest_motion;
}

}  // namespace bodkin
