#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "anatomy/tetrahedral_mesh.h"

namespace bodkin {

// How well shaped a mesh is. A dihedral angle is the angle between two faces of an element, 6 an element; the regular
// tetrahedron's are 70.5 degrees. Very small or very large ones make the equations stiff where the tissue is not.
struct MeshQuality {
  std::size_t nodes = 0;
  std::size_t elements = 0;
  double smallest_angle = 0.0, largest_angle = 0.0;  // degrees
  std::size_t smallest_angle_element = 0;
  std::size_t poor_elements = 0;                                    // elements with an angle below 5 degrees
  std::array<std::size_t, 36> angles{};                             // how many fall into each 5 degrees, 0 to 180
  double volume = 0.0;                                              // mm^3, of all elements
  double smallest_volume = 0.0, largest_volume = 0.0;               // mm^3, of one element
  double shortest_edge = 0.0, mean_edge = 0.0, longest_edge = 0.0;  // mm; mean over elements and their 6 edges
  std::array<double, 256> tissue_volume{};                          // mm^3, by TissueId
  std::array<std::size_t, 256> tissue_elements{};                   // by TissueId
  std::array<std::size_t, 256> tissue_nodes{};  // by TissueId; a node on a border counts on both sides
  std::vector<std::string> warnings;            // one sentence each; empty when the mesh is good
};

// Checks a mesh on its own, before anything is computed with it. Throws InputError, with the element or node, its
// place and the remedy, when there are no elements, sizes disagree, an index is out of range, a coordinate is not
// finite, a node belongs to no element, or an element is inverted or flat (volume below 1e-6 h^3, h its mean edge). A
// mesh that passes but is poorly shaped comes with warnings.
MeshQuality check_mesh(const TetrahedralMesh& mesh);

// Checks that what is fixed holds the whole body. Throws InputError when nothing is fixed, when a fixed node is not
// in the mesh, or when a piece of the body, connected through its elements, can still move or turn as a whole because
// fewer than three of its nodes, or only nodes on one line, are fixed. The mesh must be sound.
void check_supports(const TetrahedralMesh& mesh, std::span<const std::uint32_t> fixed);

}  // namespace bodkin
