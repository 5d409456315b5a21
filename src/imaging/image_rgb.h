#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bodkin::imaging {

struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  bool operator==(const Rgb&) const = default;
};

// A colour in the format of tissue libraries, 0xRRGGBB.
constexpr Rgb rgb(std::uint32_t colour) {
  return {static_cast<std::uint8_t>(colour >> 16 & 0xFF), static_cast<std::uint8_t>(colour >> 8 & 0xFF),
          static_cast<std::uint8_t>(colour & 0xFF)};
}

// A colour image, rows from top to bottom.
struct ImageRgb {
  int width = 0;            // pixels
  int height = 0;           // pixels
  std::vector<Rgb> pixels;  // height x width, row by row

  ImageRgb() = default;
  ImageRgb(int columns, int rows)
      : width(columns), height(rows), pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

  Rgb& at(int column, int row) { return pixels[offset(column, row)]; }
  const Rgb& at(int column, int row) const { return pixels[offset(column, row)]; }

 private:
  std::size_t offset(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
};

}  // namespace bodkin::imaging
