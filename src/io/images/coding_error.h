#pragma once

#include <optional>
#include <string_view>

namespace bodkin::io {

// The largest change of values by a lossy code, in stored units (HU where the slope is 1).
struct CodingError {
  double largest = 0.0;  // upper bound of the change of a value; 0 = not bounded
  double typical = 0.0;  // root mean square over an image that uses all of the code's steps; 0 = unknown
};

// The loss stated by one coded image; empty for a lossless code, and for one that does not state it.
//   JPEG-LS (ISO 14495-1)   NEAR in the header of the scan: the largest error
//   JPEG (ISO 10918-1)      quantisation tables: each coefficient is off by at most half of its step, and evenly
//                           within it; the transform is orthonormal but for its scale
// JPEG 2000 truncates its bit stream at the file's size, so nothing in it bounds the error.
std::optional<CodingError> coding_error(std::string_view coded);

}  // namespace bodkin::io
