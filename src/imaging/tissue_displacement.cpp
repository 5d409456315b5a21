#include "imaging/tissue_displacement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "imaging/rest_place.h"

namespace bodkin::imaging {

std::vector<Vec3> PointLattice::points() const {
  std::vector<Vec3> all;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) all.emplace_back(corner + spacing * Vec3(i, j, k));
  return all;
}

PointLattice lattice_around(const PatientBox& box, double spacing, int most) {
  constexpr double wider = 1.05;
  PointLattice lattice;
  const Vec3 extent = box.high - box.low;
  for (lattice.spacing = spacing;; lattice.spacing *= wider) {
    double points = 1.0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double cells = std::max(1.0, std::ceil(extent[axis] / lattice.spacing));
      points *= cells + 1.0;
      lattice.size[static_cast<std::size_t>(axis)] = static_cast<int>(cells) + 1;
    }
    if (points <= std::max(most, 8)) break;
  }
  const Vec3 cells(lattice.size[0] - 1, lattice.size[1] - 1, lattice.size[2] - 1);
  lattice.corner = 0.5 * (box.low + box.high) - 0.5 * lattice.spacing * cells;
  return lattice;
}

TissueDisplacement::TissueDisplacement(const PointLattice& lattice, std::vector<float> displacements)
    : lattice_(lattice), displacements_(std::move(displacements)) {}

Vec3 TissueDisplacement::of(const Vec3& rest) const {
  const Vec3 at = (rest - lattice_.corner) / lattice_.spacing;
  std::array<std::size_t, 3> first{};
  std::array<float, 3> share{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double bounded = std::clamp(at[static_cast<Eigen::Index>(axis)], 0.0, lattice_.size[axis] - 1.0);
    const int cell = std::min(static_cast<int>(bounded), lattice_.size[axis] - 2);
    first[axis] = static_cast<std::size_t>(cell);
    share[axis] = static_cast<float>(bounded - cell);
  }
  const std::size_t row = 3 * static_cast<std::size_t>(lattice_.size[0]);
  const std::size_t layer = row * static_cast<std::size_t>(lattice_.size[1]);
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const std::size_t i = corner & 1U, j = corner >> 1U & 1U, k = corner >> 2U;
    const float weight = (i == 1 ? share[0] : 1.0F - share[0]) * (j == 1 ? share[1] : 1.0F - share[1]) *
                         (k == 1 ? share[2] : 1.0F - share[2]);
    sum += weight * Eigen::Map<const Eigen::Vector3f>(displacements_.data() + 3 * (first[0] + i) +
                                                      row * (first[1] + j) + layer * (first[2] + k));
  }
  return sum.cast<double>();
}

Vec3 TissueDisplacement::at_rest(const Vec3& place) const {
  return rest_place(place, [this](const Vec3& at) { return of(at); });
}

RestOffsets TissueDisplacement::rest_offsets() const {
  RestOffsets made{lattice_, {}};
  made.offsets.reserve(displacements_.size());
  for (const Vec3& point : lattice_.points()) {
    const Vec3 offset = at_rest(point) - point;
    for (const double part : offset) made.offsets.push_back(static_cast<float>(part));
  }
  return made;
}

TissueDisplacement TissueDisplacement::plus(const TissueDisplacement& other) const {
  std::vector<float> sum = displacements_;
  std::size_t next = 0;
  for (const Vec3& point : lattice_.points()) {
    for (const double part : other.of(point)) sum[next++] += static_cast<float>(part);
  }
  return {lattice_, std::move(sum)};
}

double TissueDisplacement::most_difference(const TissueDisplacement& other) const {
  if (lattice_.corner != other.lattice_.corner || lattice_.spacing != other.lattice_.spacing ||
      lattice_.size != other.lattice_.size)
    return std::numeric_limits<double>::infinity();
  float most = 0.0F;
  for (std::size_t i = 0; i < displacements_.size(); ++i)
    most = std::max(most, std::abs(displacements_[i] - other.displacements_[i]));
  return static_cast<double>(most);
}

Slice cut_moved(const SlicePlane& plane, const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues,
                const TissueDisplacement& moved) {
  Slice slice;
  slice.plane = plane;
  for (int row = 0; row < plane.height; ++row) {
    for (int column = 0; column < plane.width; ++column) {
      const Vec3 rest = moved.at_rest(plane.point(column, row));
      slice.hounsfield.push_back(
          static_cast<float>(anatomy::linear(ct, rest, std::numeric_limits<double>::quiet_NaN())));
      slice.tissues.push_back(anatomy::nearest(tissues, rest, Slice::outside));
    }
  }
  return slice;
}

}  // namespace bodkin::imaging
