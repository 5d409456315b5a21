#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace bodkin::report {

// The points of a line that are enough to draw it: indices, in order, the first and last among them. No point that is
// left out lies further than `tolerance` from the line through the others (Douglas and Peucker 1973).
std::vector<std::size_t> corners_of(const std::vector<std::array<double, 2>>& line, double tolerance);

}  // namespace bodkin::report
