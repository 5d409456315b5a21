#include "io/images/coding_error.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace bodkin::io {
namespace {

constexpr unsigned start_of_image = 0xD8, quantisation_tables = 0xDB, start_of_scan = 0xDA, frame_of_jpeg_ls = 0xF7;

unsigned byte_at(std::string_view bytes, std::size_t place) {
  return static_cast<unsigned char>(bytes[place]);
}

unsigned word_at(std::string_view bytes, std::size_t place) {
  return 256 * byte_at(bytes, place) + byte_at(bytes, place + 1);
}

// Of the first table of a DQT segment, whose steps are in zigzag order.
std::optional<CodingError> error_of_table(std::string_view segment) {
  static constexpr std::array<int, 64> zigzag = {0,  1,  8,  16, 9,  2,  3,  10, 17, 24, 32, 25, 18, 11, 4,  5,
                                                 12, 19, 26, 33, 40, 48, 41, 34, 27, 20, 13, 6,  7,  14, 21, 28,
                                                 35, 42, 49, 56, 57, 50, 43, 36, 29, 22, 15, 23, 30, 37, 44, 51,
                                                 58, 59, 52, 45, 38, 31, 39, 46, 53, 60, 61, 54, 47, 55, 62, 63};
  if (segment.empty()) return std::nullopt;
  const std::size_t width = byte_at(segment, 0) >= 16 ? 2 : 1;
  if (segment.size() < 1 + 64 * width) return std::nullopt;
  CodingError error;
  double squares = 0.0;
  for (std::size_t n = 0; n < zigzag.size(); ++n) {
    const double step = width == 2 ? word_at(segment, 1 + 2 * n) : byte_at(segment, 1 + n);
    const int u = zigzag[n] % 8, v = zigzag[n] / 8;
    const double scale = 0.25 * (u == 0 ? std::numbers::sqrt2 / 2 : 1.0) * (v == 0 ? std::numbers::sqrt2 / 2 : 1.0);
    error.largest += scale * step / 2;
    squares += step * step / 12;
  }
  error.largest += 0.5;  // rounding to whole numbers
  error.typical = std::sqrt(squares / 64 + 1.0 / 12);
  return error;
}

}  // namespace

std::optional<CodingError> coding_error(std::string_view coded) {
  if (coded.size() < 4 || byte_at(coded, 0) != 0xFF || byte_at(coded, 1) != start_of_image) return std::nullopt;
  bool jpeg_ls = false;
  std::optional<CodingError> error;
  for (std::size_t place = 2; place + 4 <= coded.size();) {
    if (byte_at(coded, place) != 0xFF) return std::nullopt;
    const unsigned marker = byte_at(coded, place + 1), length = word_at(coded, place + 2);
    if (length < 2 || place + 2 + length > coded.size()) return std::nullopt;
    const std::string_view segment = coded.substr(place + 4, length - 2);
    if (marker == frame_of_jpeg_ls) jpeg_ls = true;
    if (marker == quantisation_tables && !error) error = error_of_table(segment);
    if (marker == start_of_scan) {
      if (!jpeg_ls) return error;
      // Components, two bytes for each, then NEAR.
      const std::size_t near = segment.empty() ? 1 : 1 + 2 * byte_at(segment, 0);
      if (near >= segment.size() || byte_at(segment, near) == 0) return std::nullopt;
      const double limit = byte_at(segment, near);
      return CodingError{limit, std::sqrt(limit * (limit + 1) / 3)};
    }
    place += 2 + length;
  }
  return std::nullopt;
}

}  // namespace bodkin::io
