#include "app/models/slice_tissue.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bodkin::app {

namespace {

constexpr double lattice_spacing = 8.0;     // mm; an edge of a mesh is about as long
constexpr int most_lattice_points = 1500;   // each costs memory for every node that the needle may push
constexpr double moves_with_needle = 30.0;  // mm about the path
constexpr double skin_step = 0.5;           // mm
constexpr double seen_in_slices = 0.05;     // mm
constexpr double worth_other_slices = 0.4;  // mm: three slices take some milliseconds

// The point itself, or the skin below a point in air; if the skin is far away, the point.
Vec3 tissue_below(const Vec3& point, const Vec3& inwards, double farthest, const anatomy::TissueVolume& tissues) {
  for (double way = 0.0; way <= farthest; way += skin_step) {
    Vec3 place = point + way * inwards;
    if (anatomy::nearest(tissues, place, anatomy::tissue::air) != anatomy::tissue::air) return place;
  }
  return point;
}

}  // namespace

std::vector<Vec3> SliceTissue::follow(std::vector<Vec3> others, const anatomy::NeedlePath& path,
                                      const anatomy::TissueVolume& tissues) {
  others_ = others.size();
  now_.reset();
  const Vec3 margin = Vec3::Constant(moves_with_needle);
  lattice_ =
      imaging::lattice_around({path.entry.cwiseMin(path.target) - margin, path.entry.cwiseMax(path.target) + margin},
                              lattice_spacing, most_lattice_points);
  borders_.clear();
  const auto [nx, ny, nz] = lattice_.size;
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i)
        borders_.push_back(i == 0 || j == 0 || k == 0 || i == nx - 1 || j == ny - 1 || k == nz - 1);
    }
  }
  const double farthest = std::sqrt(3.0) * lattice_.spacing;  // a point of each cell that has skin in it
  for (const Vec3& point : lattice_.points())
    others.push_back(tissue_below(point, path.direction(), farthest, tissues));
  return others;
}

std::span<const float> SliceTissue::of_others(std::span<const float> displacements) const {
  if (displacements.size() != 3 * (others_ + borders_.size())) return displacements;
  return displacements.first(3 * others_);
}

const std::shared_ptr<const imaging::TissueDisplacement>& SliceTissue::now(std::span<const float> displacements) {
  const std::span<const float> of_lattice = displacements.subspan(of_others(displacements).size());
  if (std::none_of(of_lattice.begin(), of_lattice.end(),
                   [](float part) { return std::abs(static_cast<double>(part)) > seen_in_slices; })) {
    now_.reset();
    return now_;
  }
  std::vector<float> moved(of_lattice.begin(), of_lattice.end());
  for (std::size_t point = 0; point < borders_.size(); ++point) {
    if (borders_[point]) std::fill_n(moved.begin() + static_cast<std::ptrdiff_t>(3 * point), 3, 0.0F);
  }
  auto made = std::make_shared<const imaging::TissueDisplacement>(lattice_, std::move(moved));
  if (now_ == nullptr || made->most_difference(*now_) > worth_other_slices) now_ = std::move(made);
  return now_;
}

}  // namespace bodkin::app
