#include "views/clearance_colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace bodkin::views {

std::uint32_t clearance_colour(float clearance) {
  struct Stop {
    float at;
    std::array<float, 3> colour;
  };
  // Readable with any colour vision: from dark to bright, blue to yellow.
  constexpr std::array<Stop, 4> stops = {Stop{0.0F, {30.0F, 44.0F, 92.0F}}, Stop{0.34F, {92.0F, 98.0F, 120.0F}},
                                         Stop{0.67F, {176.0F, 160.0F, 92.0F}}, Stop{1.0F, {247.0F, 214.0F, 62.0F}}};
  const float share = std::clamp(clearance / map_top, 0.0F, 1.0F);
  std::size_t i = 1;
  while (i + 1 < stops.size() && share > stops[i].at) ++i;
  const float t = (share - stops[i - 1].at) / (stops[i].at - stops[i - 1].at);
  std::uint32_t colour = 0;
  for (std::size_t part = 0; part < 3; ++part) {
    const float value = stops[i - 1].colour[part] + t * (stops[i].colour[part] - stops[i - 1].colour[part]);
    colour = (colour << 8U) | static_cast<std::uint32_t>(std::lround(value));
  }
  return colour;
}

}  // namespace bodkin::views
