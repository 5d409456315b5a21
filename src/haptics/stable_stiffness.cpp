#include "haptics/stable_stiffness.h"

#include <algorithm>
#include <limits>

namespace bodkin::haptics {

double force_delay(const DeviceAbilities& device, double rate) noexcept {
  const double own = device.measured_delay.value_or(device.delay);
  return own + (device.owns_loop ? 0.0 : 1.0 / rate);
}

StableStiffness stable_stiffness(const DeviceAbilities& device, double rate, double friction) noexcept {
  StableStiffness found;
  found.published = device.stiffness;
  found.delay = force_delay(device, rate);
  const double then = 1.0 + 2.0 * device.delay * rate, now = 1.0 + 2.0 * found.delay * rate;
  found.by_delay = device.stiffness * std::min(1.0, then / now);
  found.by_encoder = friction > 0.0 && device.resolution > 0.0 ? 2.0 * friction / device.resolution
                                                               : std::numeric_limits<double>::infinity();
  found.stiffness = std::min(found.by_delay, found.by_encoder);
  return found;
}

}  // namespace bodkin::haptics
