#include "imaging/ultrasound/scatterers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.h"
#include "imaging/ultrasound/scan_kernel.h"

namespace bodkin::imaging {

namespace {

constexpr double unit = 64.0;  // root mean square of a scatterer's strength, as stored

std::uint32_t byte_of(double value) {
  const auto rounded = static_cast<std::int8_t>(std::lround(std::clamp(value, -127.0, 127.0)));
  return static_cast<std::uint8_t>(rounded);
}

Scatterers made() {
  Scatterers all;
  Random random(0x5CA77E25);
  all.cells.reserve(static_cast<std::size_t>(scan::cells) * scan::cells * scan::cells);
  for (int i = 0; i < scan::cells * scan::cells * scan::cells; ++i) {
    const double in_phase = random.normal() * unit / std::numbers::sqrt2;
    const double quadrature = random.normal() * unit / std::numbers::sqrt2;
    const auto chance = static_cast<std::uint32_t>(random.uniform() * 255.0);  // 0 to 254: density 255 has them all
    all.cells.push_back(byte_of(in_phase) | byte_of(quadrature) << 8 | chance << 16);
  }
  all.bundles.reserve(static_cast<std::size_t>(scan::bundles) * scan::bundles * scan::bundles);
  for (int i = 0; i < scan::bundles * scan::bundles * scan::bundles; ++i)
    all.bundles.push_back(static_cast<std::int8_t>(std::lround(random.uniform(-127.0, 127.0))));
  return all;
}

}  // namespace

const Scatterers& scatterers() {
  static const Scatterers all = made();
  return all;
}

}  // namespace bodkin::imaging
