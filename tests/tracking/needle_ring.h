#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/geometry.h"
#include "imaging/image_rgb.h"

namespace bodkin::tracking {

// The centre of the ring around a needle's tip, pixels: where most of a circle of 6 pixels radius is white or red and
// differs from the same image drawn without the needle. Searched within 40 pixels of `near`.
inline Eigen::Vector2d needle_ring(const imaging::ImageRgb& with, const imaging::ImageRgb& without,
                                   const Eigen::Vector2d& near) {
  constexpr int samples = 60, reach = 40;  // of the circle; pixels
  constexpr double radius = 6.0;
  const auto on_ring = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= with.width || y >= with.height) return false;
    const imaging::Rgb &drawn = with.at(x, y), &before = without.at(x, y);
    const bool differs =
        std::abs(drawn.red - before.red) + std::abs(drawn.green - before.green) + std::abs(drawn.blue - before.blue) >
        20;
    const bool white = std::min({drawn.red, drawn.green, drawn.blue}) > 170;
    return differs && (white || (drawn.red > 200 && drawn.green < 140));
  };
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int best = 0, count = 0;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const double at_x = std::round(near.x()) + x, at_y = std::round(near.y()) + y;
      int found = 0;
      for (int n = 0; n < samples; ++n) {
        const double angle = 6.283185307179586 * n / samples;
        found += on_ring(static_cast<int>(std::round(at_x + radius * std::cos(angle))),
                         static_cast<int>(std::round(at_y + radius * std::sin(angle))))
                     ? 1
                     : 0;
      }
      if (found > best) {
        best = found;
        count = 0;
        sum.setZero();
      }
      if (found < best) continue;
      sum += Eigen::Vector2d(at_x, at_y);
      ++count;
    }
  }
  return sum / std::max(count, 1);
}

}  // namespace bodkin::tracking
