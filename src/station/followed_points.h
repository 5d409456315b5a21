#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/progress.h"
#include "fem/solid/elastic_body.h"
#include "fem/solid/points_in_mesh.h"
#include "simulation/display_thread.h"

namespace bodkin::station {

// The displacements of points in a deformable body, for display: by the needle's forces, computed on a thread of its
// own, and by what the body does by itself, which update() tells.
class FollowedPoints {
 public:
  // `elastic`: the body's, with its whole factor; `path`: of the corridor; `points`: LPS mm, at rest, one or more.
  // Throws InputError when what is precomputed does not fit into memory.
  FollowedPoints(const fem::ElasticBody& elastic, const anatomy::TetrahedralMesh& mesh,
                 const anatomy::NeedlePath& path, const std::vector<Vec3>& points, const Progress& progress);

  // The thread that the tick gives its forces to.
  const std::shared_ptr<simulation::DisplayThread>& display() const noexcept { return display_; }
  // How the body moves by itself: mm, 3 per node of the mesh.
  void update(std::span<const float> nodes);
  // mm, x y z of every point in turn; valid until the next call.
  std::span<const float> displacements();

 private:
  std::shared_ptr<simulation::DisplayThread> display_;
  std::vector<fem::PointInMesh> points_;
  std::vector<float> by_itself_, sum_;  // mm, of these points; empty until update()
};

}  // namespace bodkin::station
