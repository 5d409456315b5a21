#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "desktop/sdl_screen.h"
#include <Eigen/Core>

#include "anatomy/case.h"
#include "anatomy/tetrahedral_mesh.h"
#include "imaging/slice.h"

namespace bodkin::desktop {

// The borders of the tissues in the plane of the planned path, as lines that move with the deformable body: skin that
// dimples and springs back while the needle goes in.
class BodyView {
 public:
  BodyView(const anatomy::Case& patient, const anatomy::TetrahedralMesh& mesh);

  // LPS mm at rest: the ends of the lines, whose displacements draw() needs.
  const std::vector<Vec3>& points() const noexcept { return points_; }

  // Into a square of the screen, `size` pixels wide. `displacements`: mm, x y z of every point in turn.
  void draw(SdlScreen& screen, double x, double y, double size, const Pose& needle,
            std::span<const float> displacements);

 private:
  imaging::SlicePlane plane_;
  std::vector<std::pair<Colour, std::size_t>> borders_;  // colour and number of points, two a line
  std::vector<Vec3> points_;                             // of all borders in turn
  std::vector<Eigen::Vector2f> drawn_;                   // of one colour, pixels
};

}  // namespace bodkin::desktop
