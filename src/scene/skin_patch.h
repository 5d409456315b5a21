#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/breath_motion.h"
#include "scene/mesh.h"

#include "core/geometry.h"

namespace bodkin::scene {

// Deformation of the skin by a needle at its entry.
struct SkinDent {
  Vec3 entry = Vec3::Zero();        // LPS mm, on the skin at rest
  Vec3 direction = -Vec3::UnitY();  // unit, into the body
  double depth = 0.0;               // mm, motion of the skin at the needle along `direction`; negative: outwards
};

// The skin about a point, cut out of its surface and divided finely enough to show a dent of a few mm: edges of 0.8
// mm at the point, unchanged ones at the border, 32 mm away.
//
// A dent moves each point by depth f(r) along the needle, r its distance from the needle's line. The surface of an
// elastic half-space sinks as 1 / r about a point load (Boussinesq); here f = 1 / sqrt(1 + (r / w)^2), which agrees
// with that away from the needle and is finite at it, times (1 - (d / R)^2)^2 with d the distance from the point at
// rest, which makes it end before the border of the patch. w = 3 mm. [D] At the needle f is 1: the bottom of the dent
// is at the depth of the force model.
class SkinPatch {
 public:
  SkinPatch() = default;
  // About the point where the line through `entry` along `direction` meets the skin; without one, nothing is cut.
  SkinPatch(const SceneMesh& skin, const Vec3& entry, const Vec3& direction);

  bool empty() const { return mesh_.empty(); }
  const Vec3& entry() const { return entry_; }
  // Triangles of the skin not replaced by the patch.
  const std::vector<std::array<std::int32_t, 3>>& around() const { return around_; }
  // The patch at present.
  const SceneMesh& mesh() const { return mesh_; }
  // At rest, LPS mm: the points whose displacements are required.
  const std::vector<Vec3>& rest() const { return rest_; }
  // The point moved to the needle's tip by the last dent: its index in mesh().points.
  std::size_t bottom() const { return bottom_; }

  // `displacements`: of a deformable body, mm, x y z of every point of rest(); or empty. A dent is added to them,
  // about the point nearest to its entry; depth 0 and no displacements are the skin at rest. All of it refers to the
  // patient after expiration, and then moves with `breath`.
  void deform(const SkinDent& dent, std::span<const float> displacements = {}, const BreathMotion& breath = {});

  static constexpr double radius = 32.0;     // mm
  static constexpr double dent_width = 3.0;  // mm

 private:
  std::size_t nearest_to(const Vec3& point) const;
  void find_reach(const Vec3& middle);
  void divide(const Vec3& middle);

  Vec3 entry_ = Vec3::Zero();
  SceneMesh mesh_;
  std::vector<Vec3> rest_;
  std::vector<Eigen::Vector3f> rest_normals_;
  std::vector<std::array<std::int32_t, 3>> around_;
  std::size_t bottom_ = 0;
  double reach_ = radius;  // mm from the bottom at rest, R
};

}  // namespace bodkin::scene
