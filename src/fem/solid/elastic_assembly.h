#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "anatomy/tetrahedral_mesh.h"
#include "fem/solid/block_matrix.h"
#include "fem/solid/elastic_material.h"
#include "fem/solid/quadratic_edges.h"

namespace bodkin::fem {

// The equations of a body at rest, stiffness * displacement = force, over the free nodes followed by the edges on
// which displacements are quadratic.
struct ElasticSystem {
  static constexpr std::uint32_t fixed = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> mesh_nodes;  // the free nodes, ascending, by their index in the mesh
  std::vector<std::uint32_t> free_nodes;  // for each node of the mesh its position in `mesh_nodes`, or `fixed`
  QuadraticEdges edges;
  BlockMatrix stiffness;  // N/mm

  // The node of the mesh to which this unknown belongs; for an edge one of its ends.
  std::uint32_t mesh_node_of(std::size_t unknown) const noexcept {
    return unknown < mesh_nodes.size() ? mesh_nodes[unknown] : edges.ends(unknown - mesh_nodes.size())[0];
  }
};

// Assembles the stiffness of a valid mesh (check_mesh) whose tissues all have a material. `fixed_nodes` do not move;
// each must be in the mesh, and may be given more than once. `edges`: of this mesh with these nodes fixed. Throws
// InputError when no node is free.
ElasticSystem assemble(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials,
                       std::span<const std::uint32_t> fixed_nodes, QuadraticEdges edges = {});

// The force (N) that holds every node of the mesh, fixed or free, at a displacement (mm): element by element, without
// the assembled matrix. 3 values (x, y, z) per node.
Eigen::VectorXd elastic_forces(const anatomy::TetrahedralMesh& mesh, const ElasticMaterials& materials,
                               const Eigen::VectorXd& displacement);

// Nodes to fix, ascending, each once: those of every element of one of the tissues (bone) ...
std::vector<std::uint32_t> nodes_of_tissues(const anatomy::TetrahedralMesh& mesh,
                                            std::span<const anatomy::TissueId> tissues);
// ... and those on or beyond the plane through `point`, on the side to which `normal` points (the far side of a body
// that lies on a table).
std::vector<std::uint32_t> nodes_beyond(const anatomy::TetrahedralMesh& mesh, const Vec3& point, const Vec3& normal);

}  // namespace bodkin::fem
