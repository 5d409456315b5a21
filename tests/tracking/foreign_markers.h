#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tracking/grey_image.h"
#include "tracking/marker_body.h"

namespace bodkin::tracking {

// Markers by the number of cells across their pattern: of other dictionaries of OpenCV (5, 6 or 7: the first six of
// DICT_5X5_50, DICT_6X6_50 and DICT_7X7_50), or of Bodkin's own, for comparison (4: 0 to 5). They lie in two rows of
// three on white sheets, upright and sharp, as on a printed page. Each has a black rim one cell wide. `width` and
// `height`: of the image, pixels, at least 400 x 300.
inline GreyImage foreign_markers(int cells, int width, int height) {
  static const std::vector<std::vector<std::string>> patterns = {
      {"1010001011011001010111100", "0000111000000011011100110", "1101011110000111011011101",
       "1000000111001010111110111", "1101011101011010100100100", "1110101000000100000101101"},
      {"000111100011110111011000001010100110", "000011101111101110100011100010010001",
       "000101011001000001111110101011001101", "110010010001101100110000011010011110",
       "110101100000011111010110111000010101", "110110001110100011100000111001101000"},
      {"1101110101011100011011001010010111001010000010101", "1110010000011011111100010011111001000000101010110",
       "1001111010101010001010111010110001011101001001111", "1010011001100111000001011011011111101001010011000",
       "1100011010111100011110110001001100110010010101100", "0101100010000000000101000010001101011001111011100"}};
  GreyImage picture(width, height);
  for (std::uint8_t& pixel : picture.pixels) pixel = 235;
  const int pixels = 100 / (cells + 2);  // of a cell
  for (int n = 0; n < 6; ++n) {
    std::string pattern;
    if (cells == marker_cells - 2) {
      for (int row = 1; row <= cells; ++row) {
        for (int column = 1; column <= cells; ++column)
          pattern +=
              marker_pattern(n).at(static_cast<std::size_t>(row)).at(static_cast<std::size_t>(column)) ? '1' : '0';
      }
    } else {
      pattern = patterns.at(static_cast<std::size_t>(cells) - 5).at(static_cast<std::size_t>(n));
    }
    const int left = 20 + n % 3 * 125, top = 20 + n / 3 * 125;
    for (int y = 0; y < pixels * (cells + 2); ++y) {
      for (int x = 0; x < pixels * (cells + 2); ++x) {
        const int row = y / pixels - 1, column = x / pixels - 1;
        const bool inside = row >= 0 && column >= 0 && row < cells && column < cells;
        const bool white = inside && pattern.at(static_cast<std::size_t>(row * cells + column)) == '1';
        picture.at(left + x, top + y) = white ? 235 : 20;
      }
    }
  }
  return picture;
}

}  // namespace bodkin::tracking
