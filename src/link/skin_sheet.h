#pragma once

#include <array>
#include <span>
#include <vector>

#include "anatomy/case.h"
#include "core/geometry.h"

namespace bodkin::link {

// The skin about the planned entry as a sheet of points and triangles, for clients that draw its deformation: 25 x 25
// points, 3 mm apart across the planned path. Empty if there is no plan, or no skin in front of it.
class SkinSheet {
 public:
  SkinSheet() = default;
  explicit SkinSheet(const anatomy::Case& patient);

  bool empty() const noexcept { return rest_.empty(); }
  // LPS mm, of the patient at rest.
  const std::vector<Vec3>& rest() const noexcept { return rest_; }
  const std::vector<std::array<int, 3>>& triangles() const noexcept { return triangles_; }

  // The points as displaced by a needle: by `dimple` mm along `needle`, most where its line crosses the skin
  // (station::dimple_share); and by `displacements` of a deformable body, x y z (mm) of each point, which already
  // contain the needle's effect. Ignored unless there are three per point.
  std::vector<Vec3> moved(const Pose& needle, double dimple, std::span<const float> displacements) const;

  // The displacements of other points near the skin, mm, x y z of each: bilinear between the points of this sheet,
  // which are now at `moved`; zero beyond its border and more than 5 mm from it. All zero when `moved` has another
  // size than rest().
  std::vector<float> displacements_at(std::span<const Vec3> points, std::span<const Vec3> moved) const;

 private:
  Vec3 middle_ = Vec3::Zero(), right_ = Vec3::UnitX(), up_ = Vec3::UnitY();
  std::vector<int> index_;  // of each place of the lattice in rest(); -1: no skin
  std::vector<Vec3> rest_;
  std::vector<std::array<int, 3>> triangles_;
};

}  // namespace bodkin::link
