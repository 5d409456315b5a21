#include "fem/needle_beam.h"

#include <algorithm>
#include <cmath>

#include "core/settings_check.h"

namespace bodkin::fem {

namespace {

constexpr double freest_hub = 1e11;  // 1/(N mm): a pinned hub turns by 1 rad for 1e-11 N mm

}  // namespace

NeedleBeam::NeedleBeam(const NeedleBeamSettings& settings)
    : settings_(settings),
      compliance_(1.0 / settings.rigidity),
      turning_(settings.hold == anatomy::NeedleHold::pinned ? freest_hub : 0.0) {
  constexpr auto origin = "needle beam";
  if (!std::isinf(settings.rigidity) || settings.rigidity < 0.0)
    check_range(origin, "bending stiffness", settings.rigidity, {0.1, 1e9}, "N mm^2");
  check_range(origin, "length", settings.length, {5.0, 500.0}, "mm");
  check_range(origin, "offset of the cut", settings.cut_offset,
              declaration_of(&anatomy::NeedleBendingSettings::cut_offset).range, "mm");
}

double NeedleBeam::flexibility(double a, double b) const noexcept {
  const double n = std::min(a, b), m = std::max(a, b);
  return compliance_ / 6.0 * n * n * (3.0 * m - n);
}

ShaftRoot NeedleBeam::root(double depth) const noexcept {
  ShaftRoot here;
  const double a = here.outside = std::clamp(settings_.length - depth, 0.0, settings_.length);
  // A cantilever: [a^3/3, a^2/2; a^2/2, a] / (E I), and a hub that turns: [a; 1] [a; 1]^T turning.
  const double slope = std::sqrt(a * compliance_), hub = std::sqrt(turning_);
  here.root << 0.5 * a * slope, a * slope / std::sqrt(12.0), a * hub, slope, 0.0, hub;
  return here;
}

double NeedleBeam::push_back(const ShaftRoot& root, double force, double moment, double turn) const noexcept {
  if (root.outside <= 0.0 || root.outside >= settings_.length) return 0.0;
  return 0.5 * compliance_ * moment * moment - force * turn;
}

}  // namespace bodkin::fem
