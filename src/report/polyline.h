#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace bodkin::report {

// The points of a line that suffice to draw it: indices, in order, including the first and the last. No omitted point
// lies farther than `tolerance` from the line through the others (Douglas and Peucker 1973).
std::vector<std::size_t> corners_of(const std::vector<std::array<double, 2>>& line, double tolerance);

}  // namespace bodkin::report
