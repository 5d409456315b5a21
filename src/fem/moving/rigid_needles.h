#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "anatomy/needle_path.h"
#include "core/geometry.h"
#include "fem/moving/corotational_elements.h"

namespace bodkin::fem {

// Needles left in a body under large deformations. Each is straight and rigid, sticks to the tissue at the points of
// left_points(), now at x_i and s_i below its entry, and takes the pose of least energy:
//
//   energy   min over c and |a| = 1 of 1/2 sum k_i |x_i - c - s_i a|^2,   k_i = 1 / the gain of the point
//   force    on the tissue at point i: -k_i (x_i - c - s_i a)
//
// For small displacements these are the equations of BoundPoints, so that a body at rest and a moving one agree about
// their needles. The force is exactly the gradient of the energy, because the energy is stationary in the needle's
// pose. The second derivative of half a squared distance from anything is at most that of 1/2 |x|^2, so that k_i,
// shared among the nodes of the element, is no less than the stiffness.
class RigidNeedles {
 public:
  RigidNeedles() = default;
  // Throws InputError for a needle of zero length. A needle outside the mesh has no effect.
  RigidNeedles(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials,
               std::span<const anatomy::NeedlePath> needles);

  bool empty() const noexcept { return needles_.empty(); }
  // Adds the forces (N) on the nodes at these positions (mm), and returns the energy, N mm. Never throws or
  // allocates.
  double add_forces(const NodeVectors& places, NodeVectors& forces) const noexcept;
  // Adds an upper bound of the stiffness, N/mm, one number per node for all three of its directions.
  void add_stiffness(std::span<double> diagonal) const noexcept;

 private:
  struct Point {
    std::array<std::uint32_t, 4> nodes;
    std::array<double, 4> weights;
    double along;      // mm, s_i less its weighted mean
    double stiffness;  // N/mm
  };
  struct Needle {
    std::size_t first, last;  // of points_
    double stiffness;         // N/mm, of all of them
  };
  static Vec3 place_of(const Point& point, const NodeVectors& places) noexcept;

  std::vector<Point> points_;
  std::vector<Needle> needles_;
};

}  // namespace bodkin::fem
