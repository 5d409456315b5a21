#include "fem/solid/points_in_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "core/repeatable.h"

namespace bodkin::fem {

namespace {

constexpr double inside = -1e-9;         // weight of a corner above which a point counts as inside
constexpr int most_cells_along = 256;    // of the grid, along an axis
constexpr double elements_a_cell = 2.0;  // about
constexpr double rounding = 1.0 + 1e-9;  // of squared distances, far above their error

using ElementNodes = std::array<std::uint32_t, 4>;
using CornerWeights = std::array<double, 4>;

CornerWeights weights_in(const anatomy::TetrahedralMesh& mesh, const ElementNodes& corners, const Vec3& point) {
  const Vec3& origin = mesh.nodes[corners[0]];
  Mat3 edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = mesh.nodes[corners[static_cast<std::size_t>(i) + 1]] - origin;
  const Vec3 shares = edges.inverse() * (point - origin);
  return {1.0 - shares.sum(), shares.x(), shares.y(), shares.z()};
}

// mm^2, squared distance of a point from the box around an element: no place in the element is closer.
double distance_to_box(const anatomy::TetrahedralMesh& mesh, const ElementNodes& corners, const Vec3& point) {
  Vec3 low = mesh.nodes[corners[0]], high = low;
  for (std::size_t i = 1; i < 4; ++i) {
    low = low.cwiseMin(mesh.nodes[corners[i]]);
    high = high.cwiseMax(mesh.nodes[corners[i]]);
  }
  return (low - point).cwiseMax(point - high).cwiseMax(0.0).squaredNorm();
}

// The point of a triangle closest to a given point, as weights (Ericson, Real-Time Collision Detection, 5.1.5).
std::array<double, 3> closest_in_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point) {
  const Vec3 ab = b - a, ac = c - a, ap = point - a, bp = point - b, cp = point - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
  if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
  if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
  const double over_ab = d1 * d4 - d3 * d2, over_ac = d5 * d2 - d1 * d6, over_bc = d3 * d6 - d5 * d4;
  if (over_ab <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {1.0 - d1 / (d1 - d3), d1 / (d1 - d3), 0.0};
  if (over_ac <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {1.0 - d2 / (d2 - d6), 0.0, d2 / (d2 - d6)};
  if (over_bc <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double share = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0.0, 1.0 - share, share};
  }
  const double whole = over_ab + over_ac + over_bc;
  return {over_bc / whole, over_ac / whole, over_ab / whole};
}

}  // namespace

// A regular grid over the mesh; every cell lists the elements whose boxes overlap it.
class PointFinder::Grid {
 public:
  explicit Grid(const anatomy::TetrahedralMesh& mesh) : mesh_(mesh) {
    low_ = high_ = mesh.nodes.front();
    for (const Vec3& node : mesh.nodes) {
      low_ = low_.cwiseMin(node);
      high_ = high_.cwiseMax(node);
    }
    const Vec3 extent = (high_ - low_).cwiseMax(1e-6);
    cell_ = repeatable::cbrt(extent.prod() * elements_a_cell / static_cast<double>(mesh.elements.size()));
    cell_ = std::max(cell_, extent.maxCoeff() / most_cells_along);
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      size_[static_cast<std::size_t>(axis)] = static_cast<int>(extent[axis] / cell_) + 1;
    first_.assign(
        static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) * static_cast<std::size_t>(size_[2]) +
            1,
        0);
    for (std::uint32_t e = 0; e < mesh.elements.size(); ++e)
      for_cells_of(e, [this](std::size_t cell) { ++first_[cell + 1]; });
    for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
    elements_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t e = 0; e < mesh.elements.size(); ++e)
      for_cells_of(e, [this, &next, e](std::size_t cell) { elements_[next[cell]++] = e; });
  }

  // Calls `look` with every element that may be within `reach` of the point; some more than once.
  template <typename Look>
  void near(const Vec3& point, double reach, Look&& look) const {
    for_cells_between(point.array() - reach, point.array() + reach, [&](std::size_t cell) {
      for (std::size_t at = first_[cell]; at < first_[cell + 1]; ++at) look(elements_[at]);
    });
  }

  PointInMesh closest_place(const Vec3& point, double reach) const;
  double cell() const noexcept { return cell_; }  // mm

 private:
  template <typename Visit>
  void for_cells_between(const Vec3& from, const Vec3& to, Visit&& visit) const {
    if ((to.array() < low_.array()).any() || (from.array() > high_.array()).any()) return;
    std::array<int, 3> begin{}, end{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<Eigen::Index>(axis);
      const double most = size_[axis] - 1;
      begin[axis] = static_cast<int>(std::clamp((from[at] - low_[at]) / cell_, 0.0, most));
      end[axis] = static_cast<int>(std::clamp((to[at] - low_[at]) / cell_, 0.0, most));
    }
    for (int k = begin[2]; k <= end[2]; ++k)
      for (int j = begin[1]; j <= end[1]; ++j)
        for (int i = begin[0]; i <= end[0]; ++i)
          visit((static_cast<std::size_t>(k) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(j)) *
                    static_cast<std::size_t>(size_[0]) +
                static_cast<std::size_t>(i));
  }

  template <typename Visit>
  void for_cells_of(std::uint32_t element, Visit&& visit) const {
    Vec3 low = mesh_.nodes[mesh_.elements[element][0]], high = low;
    for (const std::uint32_t node : mesh_.elements[element]) {
      low = low.cwiseMin(mesh_.nodes[node]);
      high = high.cwiseMax(mesh_.nodes[node]);
    }
    for_cells_between(low, high, visit);
  }

  const anatomy::TetrahedralMesh& mesh_;
  Vec3 low_, high_;
  double cell_ = 1.0;  // mm
  std::array<int, 3> size_{};
  std::vector<std::size_t> first_;       // by cell, into elements_; one more at the end
  std::vector<std::uint32_t> elements_;  // cell after cell
};

// The closest place in the closest element, for a point outside all elements.
PointInMesh PointFinder::Grid::closest_place(const Vec3& point, double reach) const {
  PointInMesh found;
  double closest = reach * reach;
  near(point, reach, [&](std::uint32_t element) {
    const ElementNodes& corners = mesh_.elements[element];
    if (distance_to_box(mesh_, corners, point) > closest * rounding) return;
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      std::array<std::size_t, 3> face{};
      for (std::size_t i = 0; i < 3; ++i) face[i] = (left_out + 1 + i) % 4;
      const Vec3 &a = mesh_.nodes[corners[face[0]]], &b = mesh_.nodes[corners[face[1]]],
                 &c = mesh_.nodes[corners[face[2]]];
      const std::array<double, 3> shares = closest_in_triangle(a, b, c, point);
      const double away = (shares[0] * a + shares[1] * b + shares[2] * c - point).squaredNorm();
      if (away >= closest) continue;
      closest = away;
      found.nodes = corners;
      found.element = element;
      found.weights = {};
      for (std::size_t i = 0; i < 3; ++i) found.weights[face[i]] = shares[i];
    }
  });
  return found;
}

PointFinder::PointFinder(const anatomy::TetrahedralMesh& mesh)
    : mesh_(mesh), grid_(mesh.elements.empty() ? nullptr : std::make_unique<const Grid>(mesh)) {}

PointFinder::~PointFinder() = default;

PointInMesh PointFinder::find(const Vec3& point, double reach) const {
  PointInMesh found;
  if (grid_ == nullptr) return found;
  bool met = false;
  grid_->near(point, 0.0, [&](std::uint32_t element) {
    if (met) return;
    const CornerWeights weights = weights_in(mesh_, mesh_.elements[element], point);
    if (*std::min_element(weights.begin(), weights.end()) < inside) return;
    met = true;
    found = {mesh_.elements[element], weights, element};
  });
  if (met) return found;
  // Most outside points lie close to the surface, where few elements need checking.
  for (double within = grid_->cell(); within < reach && !found.moves(); within *= 2.0)
    found = grid_->closest_place(point, within);
  return found.moves() ? found : grid_->closest_place(point, reach);
}

std::vector<PointInMesh> find_points(const anatomy::TetrahedralMesh& mesh, std::span<const Vec3> points,
                                     double reach) {
  const PointFinder finder(mesh);
  std::vector<PointInMesh> found;
  found.reserve(points.size());
  for (const Vec3& point : points) found.push_back(finder.find(point, reach));
  return found;
}

}  // namespace bodkin::fem
