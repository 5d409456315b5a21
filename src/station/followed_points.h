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

// The displacements of points in a deformable body, for display: by the needle's forces, computed on a thread of its
// own, and by what the body does by itself, which update() tells.
class FollowedPoints {
 public:
  // `elastic`: the body's, with its whole factor; `path`: the planned one; `points`: LPS mm, at rest, one or more;
  // `left`: needles in the body, which hold the tissue. `whole`, of a needle that goes anywhere: what it does away
  // from the path is computed when it is there (fem::GrowingField). `surface`: nodes that a probe may hold.
  // Throws InputError when what is precomputed does not fit into memory. `mesh` must outlive this.
  FollowedPoints(const fem::ElasticBody& elastic, const anatomy::TetrahedralMesh& mesh,
                 const anatomy::NeedlePath& path, const std::vector<Vec3>& points, const Progress& progress,
                 const fem::LeftNeedleForces& left = {}, std::shared_ptr<const fem::ContactBody> whole = {},
                 std::span<const std::uint32_t> surface = {});

  // Other points from now on, of a needle that goes anywhere and has entered at `entry`; all at rest until the first
  // of their displacements are computed. Of a needle that does not, nothing happens.
  void follow(const std::vector<Vec3>& points, const Vec3& entry);

  // The thread that the tick gives its forces to.
  const std::shared_ptr<simulation::DisplayThread>& display() const noexcept { return display_; }
  // How the body moves by itself: mm, 3 per node of the mesh; and the nodes that a probe holds.
  void update(std::span<const float> nodes, std::span<const std::uint32_t> held = {});
  // mm, x y z of every point in turn; valid until the next call.
  std::span<const float> displacements();

 private:
  std::vector<std::uint32_t> nodes_held_near(const Vec3& entry) const;

  const anatomy::TetrahedralMesh& mesh_;
  fem::LeftNeedleForces left_;
  std::shared_ptr<const fem::ContactBody> whole_;  // null: the needle stays near the path
  std::vector<std::uint32_t> surface_;
  std::shared_ptr<simulation::DisplayThread> display_;
  std::vector<fem::PointInMesh> points_;
  std::vector<float> by_itself_, sum_;  // mm, of these points; empty until update()
};

}  // namespace bodkin::station
