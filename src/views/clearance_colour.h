#pragma once

#include <cstdint>

namespace bodkin::views {

inline constexpr float map_top = 7.0F;  // mm, end of the colour scale

// 0xRRGGBB of a clearance in mm: dark blue if blocked, through grey to yellow at map_top.
std::uint32_t clearance_colour(float clearance);

}  // namespace bodkin::views
