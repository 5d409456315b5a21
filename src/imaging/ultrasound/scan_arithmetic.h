#pragma once

#include <cstdint>

// What the sources of the inner loops share. Everything has internal linkage, for each of them is compiled once for
// every processor path.

#define BODKIN_JOIN_(a, b) a##b
#define BODKIN_JOIN(a, b) BODKIN_JOIN_(a, b)

namespace bodkin::scan {

static inline float bounded(float x, float low, float high) noexcept {
  const float above = low > x ? low : x;
  return high < above ? high : above;
}

static inline float float_of(std::uint32_t bits) noexcept {
  return __builtin_bit_cast(float, bits);
}

}  // namespace bodkin::scan
