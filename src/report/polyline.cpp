#include "report/polyline.h"

#include <cmath>
#include <utility>

namespace bodkin::report {

namespace {

using Point = std::array<double, 2>;

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

// Distance of a point from the segment between two others.
double distance(const Point& point, const Point& from, const Point& to) {
  const double length = distance(from, to);
  if (length == 0.0) return distance(point, from);
  const double dx = to[0] - from[0], dy = to[1] - from[1];
  const double along = ((point[0] - from[0]) * dx + (point[1] - from[1]) * dy) / length;
  if (along < 0.0) return distance(point, from);
  if (along > length) return distance(point, to);
  return std::abs((point[0] - from[0]) * dy - (point[1] - from[1]) * dx) / length;
}

}  // namespace

std::vector<std::size_t> corners_of(const std::vector<Point>& line, double tolerance) {
  std::vector<bool> keep(line.size(), line.size() < 3);
  std::vector<std::pair<std::size_t, std::size_t>> open;
  if (line.size() > 2) {
    keep.front() = keep.back() = true;
    open.emplace_back(0, line.size() - 1);
  }
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double farthest = tolerance;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = distance(line[i], line[first], line[last]);
      if (off <= farthest) continue;
      farthest = off;
      at = i;
    }
    if (at == first) continue;
    keep[at] = true;
    open.emplace_back(first, at);
    open.emplace_back(at, last);
  }
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (keep[i]) kept.push_back(i);
  }
  return kept;
}

}  // namespace bodkin::report
