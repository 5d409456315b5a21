#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scene/breath_motion.h"
#include "scene/surfaces.h"

#include "core/geometry.h"

namespace bodkin::scene {

// The surfaces inside the patient that move with a deformable body: the triangles of tissues and organs near the
// needle's line. Bones and everything farther away stand still; in between, displacements fade out.
class InnerPatch {
 public:
  // Of one of the patient's surfaces.
  struct Part {
    std::size_t surface = 0;                                   // its index in PatientSurfaces::parts
    SceneMesh mesh;                                            // at present
    std::vector<SurfaceSection> sections;                      // of mesh.triangles
    std::vector<SurfaceSection> around;                        // of the same names, in still_triangles
    std::vector<std::array<std::int32_t, 3>> still_triangles;  // of the surface, not replaced by this part
    std::size_t first = 0;                                     // of its points in rest()
  };

  InnerPatch() = default;
  // About the line through `entry` along `direction` (unit), from `before` mm before it to `beyond` mm behind it.
  InnerPatch(const PatientSurfaces& surfaces, const Vec3& entry, const Vec3& direction);

  bool empty() const { return parts_.empty(); }
  const std::vector<Part>& parts() const { return parts_; }
  // The part of a surface; null: all of it stands still.
  const Part* part_of(std::size_t surface) const;
  // At rest, LPS mm: the points whose displacements are required.
  const std::vector<Vec3>& rest() const { return rest_; }

  // `displacements`: mm, x y z of every point of rest(); any other length: all at rest. Then everything moves with
  // `breath`.
  void deform(std::span<const float> displacements, const BreathMotion& breath = {});

  static constexpr double radius = 25.0, before = 10.0, beyond = 110.0;  // mm

 private:
  void turn_normals(Part& part) const;

  std::vector<Part> parts_;
  std::vector<Vec3> rest_;
  std::vector<Eigen::Vector3f> rest_normals_;
  std::vector<float> share_;  // fraction of a displacement followed by a point
};

}  // namespace bodkin::scene
