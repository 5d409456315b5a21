#pragma once

#include <optional>
#include <string_view>

namespace bodkin::io {

// How far a lossy code may have moved values, in stored units (HU where the slope is 1).
struct CodingError {
  double largest = 0.0;  // no value is further off; 0 = the code sets no limit
  double typical = 0.0;  // root mean square over an image that uses all of the code's steps; 0 = not known
};

// What one coded image says of its own loss; nothing for a lossless code, and for one whose loss it does not state.
//   JPEG-LS (ISO 14495-1)   NEAR in the header of the scan: the largest error
//   JPEG (ISO 10918-1)      quantisation tables: each coefficient is off by at most half of its step, and evenly
//                           within it; the transform is orthonormal but for its scale
// JPEG 2000 cuts its bits off where the file was to end, so nothing in it bounds the error.
std::optional<CodingError> coding_error(std::string_view coded);

}  // namespace bodkin::io
