#pragma once

#include <cstdint>

namespace bodkin::views {

inline constexpr float map_top = 7.0F;  // mm, where the colours end

// 0xRRGGBB of a clearance in mm: dark blue for what is blocked, over grey to yellow at map_top.
std::uint32_t clearance_colour(float clearance);

}  // namespace bodkin::views
