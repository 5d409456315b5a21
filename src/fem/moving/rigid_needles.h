#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "anatomy/needle_path.h"
#include "core/geometry.h"
#include "fem/moving/corotational_elements.h"

namespace bodkin::fem {

// Needles that were left in a body which moves far. Each is straight and rigid, sticks to the tissue at the points of
// left_points(), x_i now and s_i below its entry, and is where it stores the least energy:
//
//   energy   min over c and |a| = 1 of 1/2 sum k_i |x_i - c - s_i a|^2,   k_i = 1 / the gain of the point
//   force    on the tissue at point i: -k_i (x_i - c - s_i a)
//
// For small displacements these are the equations of BoundPoints, so that a body at rest and one that moves know the
// same needles. The force is exactly the gradient of the energy, for where the needle is the energy is stationary.
// Half the square of a distance from anything is nowhere more bent than 1/2 |x|^2, so that k_i, shared among the
// nodes of the element, is no less than the stiffness.
class RigidNeedles {
 public:
  RigidNeedles() = default;
  // Throws InputError for a needle without length. One that is outside the mesh does nothing.
  RigidNeedles(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials,
               std::span<const anatomy::NeedlePath> needles);

  bool empty() const noexcept { return needles_.empty(); }
  // Adds the forces (N) on the nodes at these places (mm), and returns the energy, N mm. Never throws or allocates.
  double add_forces(const NodeVectors& places, NodeVectors& forces) const noexcept;
  // Adds what is no less than the stiffness, N/mm, one number a node for all three of its directions.
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
