#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "anatomy/tetrahedral_mesh.h"
#include "fem/solid/elastic_material.h"
#include "fem/solid/packed_factor.h"
#include "fem/solid/points_in_mesh.h"

namespace bodkin::fem {

// Edges of a mesh on which displacements are quadratic. In an element with corners a and b and barycentric weights w,
// the edge between them adds 4 w_a w_b times a vector of its own to the linear displacement, as in a tetrahedron of
// second order (hierarchical shape functions; Zienkiewicz and Taylor 2000, volume 1, chapter 8). It adds nothing at
// the nodes.
//
// The equations number the free nodes first, then these edges.
class QuadraticEdges {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  QuadraticEdges() = default;
  // All edges of the elements that are `quadratic` (one per element), except those between two fixed nodes (`fixed`:
  // one per node), which do not move.
  QuadraticEdges(const anatomy::TetrahedralMesh& mesh, const std::vector<bool>& quadratic,
                 const std::vector<bool>& fixed);

  std::size_t size() const noexcept { return ends_.size(); }
  // The two nodes of the edge, the smaller first.
  const std::array<std::uint32_t, 2>& ends(std::size_t edge) const noexcept { return ends_[edge]; }
  // The number of the first edge in the equations.
  std::uint32_t first_unknown() const noexcept { return first_unknown_; }
  // The number in the equations of the edge between these nodes; none: its displacement is linear.
  std::uint32_t unknown(std::uint32_t a, std::uint32_t b) const noexcept;

 private:
  std::vector<std::array<std::uint32_t, 2>> ends_;  // ascending
  std::vector<std::uint32_t> start_;                // by node, plus one: first edge whose smaller node this is
  std::uint32_t first_unknown_ = 0;
};

// For each element: whether it belongs to a stiff skin. Linear tetrahedra are far too stiff in bending where a layer
// is only one or two of them thick; displacements in these elements have to be quadratic. A tissue is a stiff skin
// when it has free surface (faces of one element whose nodes are not all `fixed`) and, up to three elements below and
// about parallel, a border at least half as large with tissues at most half as stiff. An inner layer that only ends
// at the surface, with a border more than twice as large, is not one. Elements up to three below the surface belong
// to the skin. All tissues of the mesh must have a material.
std::vector<bool> elements_of_stiff_skin(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials,
                                         const std::vector<bool>& fixed);

// A point that moves by the mean of these points of a mesh. `free_nodes`: by node of the mesh, its number in the
// equations; fixed nodes carry nothing, and neither does a point that does not move with the mesh.
CarriedPoint carried_point(std::span<const PointInMesh> places, std::span<const std::uint32_t> free_nodes,
                           const QuadraticEdges& edges);

}  // namespace bodkin::fem
