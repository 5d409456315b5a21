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

// One column a node: x y z and a fourth number that is 0, so that a node is a whole vector of the processor.
using NodeVectors = Eigen::Matrix4Xd;

// What an element adds to the stiffness between its corners a and b, in the frame of the patient,
//   K_ab = across g_a g_b^T + along g_b g_a^T + both (g_a . g_b) 1,
// in single precision: the matrix only says where to go next, the forces say when one is there.
struct alignas(64) TurnedElement {
  std::array<std::array<float, 3>, 4> gradient;  // 1/mm, of the shape functions, turned with the element
  float across, along, both;                     // N mm: V lambda, V (mu - b / 2), V (mu + b / 2)
};

// The elements of a body that moves far: linear in the strain that is left when an element's own rotation is taken
// out. With F the deformation gradient, R = nearest_rotation(F), S = R^T F:
//
//   energy   V (mu |S - 1|^2 + lambda / 2 tr(S - 1)^2)
//   force    on corner a: -V P g_a,  P = R (2 mu (S - 1) + lambda tr(S - 1) 1)
//
// The force is exactly the gradient of the energy. A rotation of the whole costs nothing, small displacements give
// the linear body, and an inverted or flat element has a finite force that drives it back. (Mueller & Gross 2004;
// as an energy Chao et al. 2010, McAdams et al. 2011.) Without fibres: CorotationalBody refuses a tissue that
// has them.
class CorotationalElements {
 public:
  // The mesh must be sound (check_mesh) and its tissues have materials. At most 2^28 elements.
  CorotationalElements(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials);

  // Forces (N) of the elements on the nodes at these places (mm), replacing what is in `forces`; returns the energy,
  // N mm. Places that are not finite give an energy that is not. Never throws or allocates; the same places after the
  // same calls give the same bits, and after other calls the same but for rounding.
  double evaluate(const NodeVectors& places, NodeVectors& forces) noexcept;

  // Forgets all rotations: what follows is as after construction, to the bit.
  void reset() noexcept;

  // By element of the mesh, at the places of the last evaluate(). The stiffness is that of the turned element and b,
  // what tension adds to it where its corners turn: rounded up, and never negative, so that the whole is positive
  // semidefinite and, but for elements blown up by half, not less than the exact one.
  const std::vector<TurnedElement>& turned() const noexcept { return turned_; }

  std::size_t count() const noexcept { return count_; }

 private:
  // Four elements; what is missing from the last four has no volume.
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
  std::vector<TurnedElement> turned_;  // 4 a batch
};

}  // namespace bodkin::fem
