#pragma once

#include <cstdint>

namespace bodkin::scene {

// `over` mixed over `under`, 0xRRGGBB; opacity 0 to 1, in steps of 1/256.
inline std::uint32_t blend(std::uint32_t under, std::uint32_t over, float opacity) {
  const auto weight = static_cast<std::uint32_t>(opacity * 256.0F + 0.5F);
  const std::uint32_t rest = 256U - weight;
  const std::uint32_t red_blue = ((under & 0xFF00FFU) * rest + (over & 0xFF00FFU) * weight) >> 8U;
  const std::uint32_t green = ((under & 0x00FF00U) * rest + (over & 0x00FF00U) * weight) >> 8U;
  return (red_blue & 0xFF00FFU) | (green & 0x00FF00U);
}

}  // namespace bodkin::scene
