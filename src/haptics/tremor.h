#pragma once

#include <array>
#include <cstdint>

#include "core/geometry.h"

namespace bodkin::haptics {

// Physiological tremor: along each axis a sum of six sinusoids of equal size, their frequencies drawn from 8 to 12 Hz
// (the band of the physiological tremor of the hand, Elble and Koller 1990) and their phases from the whole circle.
// Nothing lies outside the band.
class Tremor {
 public:
  static constexpr double lowest = 8.0;    // Hz
  static constexpr double highest = 12.0;  // Hz

  // `size`: root mean square along each axis, in the unit of the result. `dt`: s.
  Tremor(double size, double dt, std::uint64_t seed);

  // The displacement one tick later.
  Vec3 next() noexcept;

 private:
  static constexpr std::size_t waves = 6;
  struct Wave {
    double x, y;          // the phasor
    double cosine, sine;  // its turn per tick
  };
  std::array<std::array<Wave, waves>, 3> axes_;
};

}  // namespace bodkin::haptics
