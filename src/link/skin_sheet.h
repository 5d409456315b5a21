#pragma once

#include <array>
#include <span>
#include <vector>

#include "anatomy/case.h"
#include "core/geometry.h"

namespace bodkin::link {

// The skin about the planned entry as a sheet of points and triangles, for clients that draw how it deforms: 25 x 25
// points, 3 mm apart across the planned path. Where there is no plan, or no skin before it, it is empty.
class SkinSheet {
 public:
  SkinSheet() = default;
  explicit SkinSheet(const anatomy::Case& patient);

  bool empty() const noexcept { return rest_.empty(); }
  // LPS mm, of the patient at rest.
  const std::vector<Vec3>& rest() const noexcept { return rest_; }
  const std::vector<std::array<int, 3>>& triangles() const noexcept { return triangles_; }

  // The points as a needle moves them: by `dimple` mm along `needle`, most where its line goes through the skin
  // (station::dimple_share); and by `displacements` of a deformable body, x y z (mm) of each point in turn, which
  // already hold what the needle does. Other numbers of them than three a point are ignored.
  std::vector<Vec3> moved(const Pose& needle, double dimple, std::span<const float> displacements) const;

  // How far other points near the skin have moved, mm, x y z of each in turn: bilinear between the points of this
  // sheet, which are now at `moved`; zero beyond its border and more than 5 mm from it. All zero when there are not
  // as many as in rest().
  std::vector<float> displacements_at(std::span<const Vec3> points, std::span<const Vec3> moved) const;

 private:
  Vec3 middle_ = Vec3::Zero(), right_ = Vec3::UnitX(), up_ = Vec3::UnitY();
  std::vector<int> index_;  // of each place of the lattice in rest(); -1: there is no skin
  std::vector<Vec3> rest_;
  std::vector<std::array<int, 3>> triangles_;
};

}  // namespace bodkin::link
