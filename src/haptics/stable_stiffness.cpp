#include "haptics/stable_stiffness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/repeatable.h"

namespace bodkin::haptics {

namespace {

constexpr int rim_lines = 72;

// mm/N, share of the axes' limits used by a spring of 1 N/mm along `line` (unit).
double share_of_axes(const Vec3& axis, const Vec3& line) noexcept {
  return line.cwiseAbs2().cwiseQuotient(axis).sum();
}

}  // namespace

double force_delay(const DeviceAbilities& device, double rate) noexcept {
  const double own = device.measured_delay.value_or(device.delay);
  return own + (device.owns_loop ? 0.0 : 1.0 / rate);
}

double StableStiffness::along(const Vec3& direction, double spread) const noexcept {
  if (!(weakest() > 0.0)) return 0.0;
  Eigen::Index least = 0;
  axis.minCoeff(&least);
  // The share is largest along the weakest axis; where that lies outside, on the rim of the cone.
  if (std::abs(direction[least]) >= repeatable::cos(spread)) return weakest();
  double largest = share_of_axes(axis, direction);
  if (spread > 0.0) {
    const Vec3 aside = direction.unitOrthogonal(), other = direction.cross(aside);
    for (int i = 0; i < rim_lines; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / rim_lines;
      const Vec3 line = repeatable::cos(spread) * direction +
                        repeatable::sin(spread) * (repeatable::cos(turn) * aside + repeatable::sin(turn) * other);
      largest = std::max(largest, share_of_axes(axis, line));
    }
  }
  return std::clamp(1.0 / largest, weakest(), axis.maxCoeff());  // exactly their own if all axes are equally stiff
}

StableStiffness stable_stiffness(const DeviceAbilities& device, double rate, const Vec3& friction) noexcept {
  StableStiffness found;
  found.published = device.stiffness;
  found.delay = force_delay(device, rate);
  const double then = 1.0 + 2.0 * device.delay * rate, now = 1.0 + 2.0 * found.delay * rate;
  found.by_delay = device.stiffness * std::min(1.0, then / now);
  for (int i = 0; i < 3; ++i) {
    found.by_encoder[i] = friction[i] > 0.0 && device.resolution > 0.0 ? 2.0 * friction[i] / device.resolution
                                                                       : std::numeric_limits<double>::infinity();
    found.axis[i] = std::min(found.by_delay, found.by_encoder[i]);
  }
  return found;
}

}  // namespace bodkin::haptics
