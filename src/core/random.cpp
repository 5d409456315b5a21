#include "core/random.h"

#include <cmath>
#include <numbers>

#include "core/repeatable.h"

namespace bodkin {

std::uint64_t Random::next() {
  const std::uint64_t value = mix64(state_);
  state_ += 0x9E3779B97F4A7C15ULL;
  return value;
}

double Random::uniform() {
  return static_cast<double>(next() >> 11) * 0x1.0p-53;
}

double Random::normal() {
  const double radius = std::sqrt(-2.0 * repeatable::log(1.0 - uniform()));  // 1 - u lies in (0, 1]
  return radius * repeatable::cos(2.0 * std::numbers::pi * uniform());
}

}  // namespace bodkin
