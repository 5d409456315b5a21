#pragma once

// Needles that bend in a body of kelvin_body().
#include "tests/fem/needle_rig.h"
#include "tests/sanitized.h"

#include "fem/needle_beam.h"

namespace bodkin::checks {

using namespace bodkin::anatomy;
using namespace bodkin::fem;

inline constexpr double steel_24g = 877.94;  // N mm^2

inline NeedleBeam bending(double rigidity, NeedleHold hold = NeedleHold::clamped, double length = 90.0,
                          double cut_offset = 0.0) {
  return NeedleBeam({.rigidity = rigidity, .length = length, .hold = hold, .cut_offset = cut_offset});
}

inline NeedleRig bent_rig(const CondensedBody& body, const ContactTissues& tissues, const NeedleBeam& beam) {
  return {body, tissues, narrow_settings(), beam};
}

inline const CondensedBody& flesh() {
  static const CondensedBody body = kelvin_body(1, sanitized ? 16 : 41, 1.0, 0.05);
  return body;
}

}  // namespace bodkin::checks
