#pragma once

#include <memory>
#include <span>
#include <vector>

#include "fem/solid/elastic_body.h"
#include "fem/solid/points_in_mesh.h"
#include "imaging/slice.h"
#include "imaging/ultrasound/ultrasound.h"

namespace bodkin::station {

// The plane that a frame of a probe at this pose shows, pixel by pixel, at rest.
imaging::SlicePlane plane_of_frame(const imaging::UltrasoundFrame& frame, const Pose& probe);

// mm, x y z of each point in turn, from how the nodes of its mesh have moved: linear within every element.
void move_points(std::span<const fem::PointInMesh> points, std::span<const float> nodes, std::vector<float>& moved);

// How tissue in a plane has moved, from how the nodes of its mesh have: linear within every element. The plane may be
// another one in every picture.
class SliceField {
 public:
  explicit SliceField(std::shared_ptr<const fem::BodyDescription> body);

  // mm, x y z of each point of `grid` (a plane whose pixels are the points, LPS mm at rest) in turn, which the next
  // call overwrites. `nodes`: mm, of every node of the mesh. Another grid than the last one is found in the mesh
  // first, which takes some microseconds a point.
  std::span<const float> displacements(const imaging::SlicePlane& grid, std::span<const float> nodes);

 private:
  std::shared_ptr<const fem::BodyDescription> body_;
  fem::PointFinder finder_;
  imaging::SlicePlane grid_;  // where places_ are
  std::vector<fem::PointInMesh> places_;
  std::vector<float> moved_;
};

}  // namespace bodkin::station
