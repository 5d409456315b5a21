#include "anatomy/generic_device.h"

#include <array>

namespace bodkin::anatomy {
namespace {

struct Step {
  int gauge;                // of the thinnest needle that it supports
  double peak, continuous;  // N
  double stiffness;         // N/mm
};

// Thickest first. Thinner needles have the unnamed default device.
constexpr std::array<Step, 2> for_thick_needles = {{{17, 20.0, 7.0, 2.0}, {19, 12.0, 4.0, 2.0}}};

}  // namespace

DeviceLimits generic_device(const Needle& needle, Mechanics mechanics) {
  DeviceLimits device;
  if (mechanics == Mechanics::tables) return device;
  for (const Step& step : for_thick_needles) {
    if (needle.outer_diameter < gauge_size(step.gauge)->outer_diameter) continue;
    device.peak_force = step.peak;
    device.continuous_force = step.continuous;
    device.stiffness = step.stiffness;
    break;
  }
  return device;
}

}  // namespace bodkin::anatomy
