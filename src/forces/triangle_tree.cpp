#include "forces/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace bodkin::forces {
namespace {

constexpr std::uint32_t leaf_size = 4;
constexpr std::size_t deepest = 48;  // boxes waiting at once; halving 2^31 triangles needs 30
constexpr double behind = 1e-9;      // mm
constexpr double least_way = 1e-13;  // mm into a plane, more than the rounding of coordinates of a metre
constexpr double overlap = 1e-7;     // mm
constexpr double box_margin = 1e-5;  // mm, more than all others together

float below(double x) {
  return std::nextafter(static_cast<float>(x - box_margin), -std::numeric_limits<float>::infinity());
}
float above(double x) {
  return std::nextafter(static_cast<float>(x + box_margin), std::numeric_limits<float>::infinity());
}

}  // namespace

TriangleTree::TriangleTree(const anatomy::Surface& surface) {
  std::vector<Box> bounds;
  std::vector<Side> sides;
  const auto count = static_cast<std::uint32_t>(surface.triangles().size());
  for (std::uint32_t t = 0; t < count; ++t) {
    std::array<Vec3, 3> corner;
    Box box{};
    for (std::size_t i = 0; i < 3; ++i) {
      corner[i] = surface.vertices()[static_cast<std::size_t>(surface.triangles()[t][i])];
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      box.low[axis] = below(std::min({corner[0][a], corner[1][a], corner[2][a]}));
      box.high[axis] = above(std::max({corner[0][a], corner[1][a], corner[2][a]}));
    }
    Side side;
    side.normal = surface.normal(t);
    side.level = side.normal.dot(corner[0]);
    side.triangle = static_cast<std::int32_t>(t);
    for (std::size_t i = 0; i < 3; ++i) {
      side.edge[i] = (corner[(i + 1) % 3] - corner[i]).cross(side.normal).normalized();
      side.edge_level[i] = side.edge[i].dot(corner[i]);
    }
    bounds.push_back(box);
    sides.push_back(side);
  }
  if (count == 0) return;
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  split(order, bounds, 0, count);
  sides_.reserve(count);
  for (const std::uint32_t t : order) sides_.push_back(sides[t]);
}

// Halves the triangles along the longest edge of the box of their centres, until they fit into a leaf.
void TriangleTree::split(std::vector<std::uint32_t>& order, const std::vector<Box>& bounds, std::uint32_t first,
                         std::uint32_t last) {
  Box all = bounds[order[first]];
  const auto middle = [&](std::uint32_t t, std::size_t axis) { return bounds[t].low[axis] + bounds[t].high[axis]; };
  std::array<float, 3> least, most;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    least[axis] = most[axis] = middle(order[first], axis);
    for (std::uint32_t i = first + 1; i < last; ++i) {
      all.low[axis] = std::min(all.low[axis], bounds[order[i]].low[axis]);
      all.high[axis] = std::max(all.high[axis], bounds[order[i]].high[axis]);
      least[axis] = std::min(least[axis], middle(order[i], axis));
      most[axis] = std::max(most[axis], middle(order[i], axis));
    }
  }
  const std::size_t self = boxes_.size();
  all.first = first;
  all.count = last - first;
  boxes_.push_back(all);
  if (all.count <= leaf_size) return;
  std::size_t axis = 0;
  for (std::size_t other = 1; other < 3; ++other) {
    if (most[other] - least[other] > most[axis] - least[axis]) axis = other;
  }
  const std::uint32_t half = first + (last - first) / 2;
  std::nth_element(order.begin() + first, order.begin() + half, order.begin() + last,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const float left = middle(a, axis), right = middle(b, axis);
                     return left != right ? left < right : a < b;
                   });
  split(order, bounds, first, half);
  boxes_[self].count = 0;
  boxes_[self].first = static_cast<std::uint32_t>(boxes_.size());
  split(order, bounds, half, last);
}

void TriangleTree::meet(const Side& side, const Vec3& start, const Vec3& ray, SurfaceHit& best) const noexcept {
  const double drop = -side.normal.dot(ray);                  // towards the inside
  const double height = side.normal.dot(start) - side.level;  // over the plane
  if (!(drop > least_way && height >= -behind && drop > height)) return;
  const double part = std::max(height, 0.0) / drop;
  if (part > best.part || (part == best.part && side.triangle > best.triangle && best.triangle >= 0)) return;
  const Vec3 place = start + part * ray;
  // The flatter the angle at which a plane is met, the less accurate is the place.
  const double reach = overlap + 1e-12 * ray.norm() / drop;
  for (std::size_t i = 0; i < 3; ++i) {
    if (side.edge[i].dot(place) - side.edge_level[i] > reach) return;
  }
  best = {part, side.normal, side.triangle};
}

SurfaceHit TriangleTree::first_entry(const Vec3& start, const Vec3& ray) const noexcept {
  SurfaceHit best;
  best.part = 1.0;
  if (boxes_.empty() || !start.allFinite() || !ray.allFinite()) return best;
  std::array<double, 3> inverse;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double along = ray[static_cast<Eigen::Index>(axis)];
    inverse[axis] = std::abs(along) > 1e-200 ? 1.0 / along : 1e200;  // finite, so that no product is 0 times infinity
  }
  // Fraction of the segment at which it enters the box; more than 1 if it misses the box.
  const auto entry = [&](const Box& box) {
    double from = 0.0, to = best.part;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double origin = start[static_cast<Eigen::Index>(axis)];
      const double one = (static_cast<double>(box.low[axis]) - origin) * inverse[axis];
      const double two = (static_cast<double>(box.high[axis]) - origin) * inverse[axis];
      from = std::max(from, std::min(one, two));
      to = std::min(to, std::max(one, two));
    }
    return from <= to ? from : 2.0;
  };
  std::array<std::uint32_t, deepest> waiting;
  std::array<double, deepest> entries;
  std::size_t depth = 0;
  std::uint32_t at = 0;
  if (entry(boxes_[0]) > 1.0) return best;
  while (true) {
    const Box& box = boxes_[at];
    if (box.count > 0) {
      for (std::uint32_t i = box.first; i < box.first + box.count; ++i) meet(sides_[i], start, ray, best);
    } else {
      std::uint32_t near = at + 1, far = box.first;
      double to_near = entry(boxes_[near]), to_far = entry(boxes_[far]);
      if (to_far < to_near) {
        std::swap(near, far);
        std::swap(to_near, to_far);
      }
      if (to_far <= 1.0) {
        waiting[depth] = far;
        entries[depth++] = to_far;
      }
      if (to_near <= 1.0) {
        at = near;
        continue;
      }
    }
    do {
      if (depth == 0) return best;
      at = waiting[--depth];
    } while (entries[depth] > best.part);
  }
}

}  // namespace bodkin::forces
