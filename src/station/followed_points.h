#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/progress.h"
#include "fem/solid/elastic_body.h"
#include "fem/solid/points_in_mesh.h"
#include "simulation/display_thread.h"

namespace bodkin::station {

// The displacements of points in a deformable body, for display: of a static body from the needle's forces, on a
// thread of its own; of a moving one from the displacements of its nodes.
class FollowedPoints {
 public:
  // In a static body. `elastic`: the body's, with its whole factor; `path`: of the corridor; `points`: LPS mm, at
  // rest, one or more. Throws InputError when what is precomputed does not fit into memory.
  FollowedPoints(const fem::ElasticBody& elastic, const anatomy::TetrahedralMesh& mesh,
                 const anatomy::NeedlePath& path, const std::vector<Vec3>& points, const Progress& progress);
  // In a moving body.
  FollowedPoints(const anatomy::TetrahedralMesh& mesh, const std::vector<Vec3>& points);

  // The thread that the tick gives its forces to; null for a moving body.
  const std::shared_ptr<simulation::DisplayThread>& display() const noexcept { return display_; }
  // Of a moving body: mm, 3 per node of the mesh.
  void update(std::span<const float> nodes) noexcept;
  // mm, x y z of every point in turn; valid until the next call of either function.
  std::span<const float> displacements() noexcept;

 private:
  std::shared_ptr<simulation::DisplayThread> display_;
  std::vector<fem::PointInMesh> points_;  // in a moving body
  std::vector<float> moved_;              // mm, of these points
};

}  // namespace bodkin::station
