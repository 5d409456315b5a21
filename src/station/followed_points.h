#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/progress.h"
#include "fem/solid/contact_body.h"
#include "fem/solid/elastic_body.h"
#include "fem/solid/left_needle_forces.h"
#include "fem/solid/points_in_mesh.h"
#include "simulation/display_thread.h"

namespace bodkin::station {

// The displacements of points in a deformable body, for display: by the needle's forces, computed on a separate
// thread, and by the body's own motion, given by update().
class FollowedPoints {
 public:
  // `elastic`: the body's, with its whole factor; `path`: the planned one; `points`: LPS mm, at rest, one or more;
  // `left`: needles in the body, which hold the tissue. `whole`, for a needle that may enter anywhere: its effect off
  // the path is computed on demand (fem::GrowingField). `surface`: nodes that a probe may hold. Throws InputError
  // when the precomputed data do not fit into memory. `mesh` must outlive this object.
  FollowedPoints(const fem::ElasticBody& elastic, const anatomy::TetrahedralMesh& mesh,
                 const anatomy::NeedlePath& path, const std::vector<Vec3>& points, const Progress& progress,
                 const fem::LeftNeedleForces& left = {}, std::shared_ptr<const fem::ContactBody> whole = {},
                 std::span<const std::uint32_t> surface = {});

  // From now on other points, for a needle that may enter anywhere and has entered at `entry`; all at rest until
  // their first displacements are computed. No effect for a needle that stays near the path.
  void follow(const std::vector<Vec3>& points, const Vec3& entry);

  // The thread to which the tick passes its forces.
  const std::shared_ptr<simulation::DisplayThread>& display() const noexcept { return display_; }
  // The body's own motion: mm, 3 per node of the mesh; and the nodes that a probe holds.
  void update(std::span<const float> nodes, std::span<const std::uint32_t> held = {});
  // mm, x y z of every point, one after another; valid until the next call.
  std::span<const float> displacements();

 private:
  std::vector<std::uint32_t> nodes_held_near(const Vec3& entry) const;

  const anatomy::TetrahedralMesh& mesh_;
  fem::LeftNeedleForces left_;
  std::shared_ptr<const fem::ContactBody> whole_;  // null: the needle stays near the path
  std::vector<std::uint32_t> surface_;
  std::shared_ptr<simulation::DisplayThread> display_;
  std::vector<fem::PointInMesh> points_;
  std::vector<float> by_itself_, sum_;  // mm, of these points; empty before update()
};

}  // namespace bodkin::station
