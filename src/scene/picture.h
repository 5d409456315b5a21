#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bodkin::scene {

// Opaque pixels 0xffRRGGBB, rows from the top, without gaps.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;  // width * height

  Picture() = default;
  Picture(int w, int h)
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), 0xFF000000U) {}
  std::uint32_t* row(int y) { return pixels.data() + static_cast<std::ptrdiff_t>(y) * width; }
  const std::uint32_t* row(int y) const { return pixels.data() + static_cast<std::ptrdiff_t>(y) * width; }
};

}  // namespace bodkin::scene
