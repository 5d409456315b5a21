#pragma once

#include <memory>
#include <span>
#include <vector>

#include "fem/solid/elastic_body.h"
#include "fem/solid/points_in_mesh.h"
#include "imaging/slice.h"
#include "imaging/ultrasound/ultrasound.h"

namespace bodkin::station {

// The plane of a probe's frame at this pose, pixel by pixel, at rest.
imaging::SlicePlane plane_of_frame(const imaging::UltrasoundFrame& frame, const Pose& probe);

// mm, x y z of each point, from the displacements of the nodes of its mesh: linear within every element.
void move_points(std::span<const fem::PointInMesh> points, std::span<const float> nodes, std::vector<float>& moved);

// The displacement of the tissue in a plane, from that of the nodes of its mesh: linear within every element. The
// plane may differ in every image.
class SliceField {
 public:
  explicit SliceField(std::shared_ptr<const fem::BodyDescription> body);

  // mm, x y z of each point of `grid` (a plane whose pixels are the points, LPS mm at rest); the next call overwrites
  // them. `nodes`: mm, of every node of the mesh. A grid that differs from the last one is first located in the mesh,
  // which takes some microseconds per point.
  std::span<const float> displacements(const imaging::SlicePlane& grid, std::span<const float> nodes);

 private:
  std::shared_ptr<const fem::BodyDescription> body_;
  fem::PointFinder finder_;
  imaging::SlicePlane grid_;  // the grid of places_
  std::vector<fem::PointInMesh> places_;
  std::vector<float> moved_;
};

}  // namespace bodkin::station
