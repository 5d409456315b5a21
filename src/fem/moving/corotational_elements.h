#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "anatomy/tetrahedral_mesh.h"
#include "core/simd.h"
#include "fem/moving/nearest_rotation.h"
#include "fem/solid/elastic_material.h"

namespace bodkin::fem {

// One column per node: x, y, z and a fourth number that is 0, so that a node fills a vector register.
using NodeVectors = Eigen::Matrix4Xd;

// The stiffness that an element adds between its corners a and b, in the frame of the patient,
//   K_ab = across g_a g_b^T + along g_b g_a^T + both (g_a . g_b) 1,
// in single precision: the matrix only determines the step, equilibrium is judged by the forces.
struct alignas(64) TurnedElement {
  std::array<std::array<float, 3>, 4> gradient;  // 1/mm, of the shape functions, turned with the element
  float across, along, both;                     // N mm: V lambda, V (mu - b / 2), V (mu + b / 2)
};

// The elements of a body under large deformations: linear in the strain that remains when an element's own rotation
// is removed. With F the deformation gradient, R = nearest_rotation(F), S = R^T F:
//
//   energy   V (mu |S - 1|^2 + lambda / 2 tr(S - 1)^2)
//   force    on corner a: -V P g_a,  P = R (2 mu (S - 1) + lambda tr(S - 1) 1)
//
// The force is exactly the gradient of the energy. A rotation of the whole body stores no energy, small displacements
// give the linear body, and an inverted or flat element has a finite force that restores it. (Mueller & Gross 2004;
// as an energy Chao et al. 2010, McAdams et al. 2011.) Without fibres: CorotationalBody refuses tissues with fibres.
class CorotationalElements {
 public:
  // The mesh must be valid (check_mesh) and its tissues have materials. At most 2^28 elements.
  CorotationalElements(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials);

  // Forces (N) of the elements on the nodes at these positions (mm), replacing the content of `forces`; returns the
  // energy, N mm. Positions that are not finite give an energy that is not finite. Never throws or allocates; the
  // same positions after the same calls give the same bits, and after other calls equal results up to rounding.
  double evaluate(const NodeVectors& places, NodeVectors& forces) noexcept;

  // Forgets all rotations: later results are as after construction, to the bit.
  void reset() noexcept;

  // By element of the mesh, at the positions of the last evaluate(). The stiffness is that of the rotated element and
  // b, the contribution of tension where the element rotates: rounded up, and never negative, so that the sum is
  // positive semidefinite and, except for elements stretched by half, not less than the exact one.
  const std::vector<TurnedElement>& turned() const noexcept { return turned_; }

  std::size_t count() const noexcept { return count_; }

 private:
  // Four elements; the missing ones of the last batch have no volume.
  struct Batch {
    std::array<std::array<std::uint32_t, lane_count>, 4> nodes;  // by corner
    LaneVector gradient[3];                                      // at rest, of corners 1 to 3
    Lanes lambda, mu;                                            // V lambda, V mu, N mm
    LaneQuaternion rotation;
  };
  static double evaluate_batch(Batch& batch, const double* places, double* forces, TurnedElement* turned) noexcept;
  static double evaluate_all(std::vector<Batch>& batches, const double* places, double* forces,
                             TurnedElement* turned) noexcept;

  std::size_t count_;
  std::vector<Batch> batches_;
  std::vector<TurnedElement> turned_;  // 4 per batch
};

}  // namespace bodkin::fem
