#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "anatomy/tissue.h"
#include "core/axial_motion.h"
#include "core/settings_check.h"

namespace bodkin::forces {

// Validation of settings and input that every force model does.

// Throws InputError naming model, tissue and parameter unless the property of every tissue is valid.
template <typename Property>
void check_tissues(const anatomy::TissueLibrary& library, Property anatomy::TissueProperties::*property,
                   std::string_view model) {
  for (const anatomy::TissueProperties& tissue : library.tissues())
    check(tissue.*property, std::string(model) + ", tissue '" + tissue.name + "'");
}

// Larger motions than these do not come from a needle in a hand: a sensor or a driver failed. A model responds with
// zero force, a `fault` event and an unchanged state.
inline constexpr double farthest_depth = 1e4;  // mm
inline constexpr double fastest_motion = 1e6;  // mm/s

// False for NaN, infinities and motions beyond the limits above.
inline bool usable(const AxialMotion& motion) noexcept {
  return std::abs(motion.depth) <= farthest_depth && std::abs(motion.velocity) <= fastest_motion;
}

}  // namespace bodkin::forces
