#include "haptics/tremor.h"

#include <cmath>
#include <numbers>

#include "core/random.h"
#include "core/repeatable.h"

namespace bodkin::haptics {

Tremor::Tremor(double size, double dt, std::uint64_t seed) : axes_{} {
  Random random(seed);
  const double amplitude = size * std::sqrt(2.0 / waves);
  for (auto& axis : axes_) {
    for (Wave& wave : axis) {
      const double turn = 2.0 * std::numbers::pi * random.uniform(lowest, highest) * dt;
      const double phase = random.uniform(0.0, 2.0 * std::numbers::pi);
      wave = {amplitude * repeatable::cos(phase), amplitude * repeatable::sin(phase), repeatable::cos(turn),
              repeatable::sin(turn)};
    }
  }
}

Vec3 Tremor::next() noexcept {
  Vec3 sum = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    for (Wave& wave : axes_[static_cast<std::size_t>(axis)]) {
      const double x = wave.cosine * wave.x - wave.sine * wave.y;
      wave.y = wave.sine * wave.x + wave.cosine * wave.y;
      wave.x = x;
      sum[axis] += x;
    }
  }
  return sum;
}

}  // namespace bodkin::haptics
