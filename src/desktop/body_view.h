#pragma once

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "desktop/sdl_screen.h"
#include "station/pressed_patient.h"
#include <Eigen/Core>

#include "anatomy/case.h"
#include "core/progress.h"
#include "fem/solid/elastic_body.h"
#include "fem/solid/points_in_mesh.h"
#include "imaging/slice.h"
#include "simulation/display_thread.h"

namespace bodkin {

// The borders of the tissues in the plane of the planned path, as lines that move with the deformable body: skin that
// dimples and springs back while the needle goes in. Their displacement is found on a thread of its own, sixty times
// a second; drawing never waits for it.
class BodyView {
 public:
  // `elastic`: the body's, with its whole factor. Throws InputError when what is precomputed does not fit into
  // memory.
  BodyView(const Case& patient, const BodyDescription& body, const ElasticBody& elastic,
           const Progress& progress = {});
  // Of a body that moves by itself: what is drawn is its newest picture.
  BodyView(const Case& patient, const BodyDescription& body, std::shared_ptr<PressedPatient> pressed);

  // What the tick tells its forces to; none with a body that moves by itself.
  const std::shared_ptr<DisplayThread>& display() const noexcept { return display_; }

  // Into a square of the screen, `size` pixels wide.
  void draw(SdlScreen& screen, double x, double y, double size, const Pose& needle);

 private:
  std::vector<Vec3> find_borders(const Case& patient, const TetrahedralMesh& mesh);
  std::span<const float> displacements();

  SlicePlane plane_;
  std::vector<std::pair<Colour, std::vector<Vec3>>> borders_;  // by colour; two points a line, mm at rest
  std::shared_ptr<DisplayThread> display_;                     // knows all the points, in their order
  std::shared_ptr<PressedPatient> pressed_;                    // or this, with where the points lie in its mesh
  std::vector<PointInMesh> points_;
  std::vector<float> moved_;            // mm, of these points
  std::vector<Eigen::Vector2f> drawn_;  // of one colour, pixels
};

}  // namespace bodkin
