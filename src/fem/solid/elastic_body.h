#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "anatomy/condensed_body.h"
#include "anatomy/tetrahedral_mesh.h"
#include "core/progress.h"
#include "fem/solid/elastic_assembly.h"
#include "fem/solid/multifrontal_cholesky.h"

namespace bodkin::fem {

// The inputs of a body: its mesh, the material of each tissue, and the fixed nodes. The corridor is the set of nodes
// to which it is condensed: those that `closest_node` can meet, or those whose forces a display uses. A body that
// keeps its factor for contact points (ContactBody) has none.
struct BodyDescription {
  anatomy::TetrahedralMesh mesh;
  ElasticMaterials materials;
  std::vector<std::uint32_t> fixed;     // nodes of the mesh
  std::vector<std::uint32_t> corridor;  // nodes of the mesh, each once; fixed nodes are left out
};

// Checks a whole body: its mesh, its materials, and its supports. Throws InputError, one sentence with place and
// remedy; returns warnings about a poor mesh, one sentence each.
std::vector<std::string> check_body(const BodyDescription& body);

// The equations of a body and the plan of their solution. States the required memory before it is allocated:
// plan.symbolic.bytes().
struct BodyPlan {
  ElasticSystem system;
  SymbolicFactor symbolic;
  anatomy::CondensedBody corridor;  // the free nodes of the corridor; its compliance is still empty
};

// The body must have passed check_body. `edges`: of its mesh, on which displacements are quadratic.
BodyPlan plan_body(const BodyDescription& body, const Progress& progress = {}, QuadraticEdges edges = {});

// A body whose equations are factorised: it provides its corridor's compliance and, if the whole factor was kept, the
// displacement of all its nodes under any forces.
class ElasticBody {
 public:
  // Throws InputError when the body does not fit into memory, or when a part of it is attached only by a node or an
  // edge, so that it can turn.
  ElasticBody(const BodyDescription& body, BodyPlan plan, const FactorOptions& options = {},
              const Progress& progress = {});

  // Number of nodes of the mesh.
  std::size_t mesh_nodes() const noexcept { return plan_.system.free_nodes.size(); }
  // The nodes of the corridor, by their index in the mesh.
  const std::vector<std::uint32_t>& corridor() const noexcept { return plan_.corridor.mesh_nodes; }
  // Needs the memory of one more compliance.
  anatomy::CondensedBody condensed() const;

  // mm, of every node of the mesh (3 rows each) under forces (N) on every node; forces on fixed nodes have no effect.
  Eigen::MatrixXd displacement(const Eigen::MatrixXd& forces) const;
  // As above, under forces only on the corridor's nodes, 3 rows each in the order of condensed(); about twice as
  // fast.
  Eigen::MatrixXd displacement_by_corridor(const Eigen::MatrixXd& forces) const;

  const ElasticSystem& system() const noexcept { return plan_.system; }
  const MultifrontalCholesky& factor() const noexcept { return factor_; }

 private:
  Eigen::MatrixXd on_all_nodes(const Eigen::MatrixXd& of_free_nodes) const;
  BodyPlan plan_;
  MultifrontalCholesky factor_;
};

// From the description to the condensed body, checked, with the least memory. Throws InputError also for a corridor
// that contains a node twice or one that is not in the mesh, and for one in which no node is free. `note` receives
// the warnings of the check, and the size of the body and the memory required, before that is allocated; it may be
// empty.
anatomy::CondensedBody condense(const BodyDescription& body, FactorOptions options = {},
                                const Progress& progress = {},
                                const std::function<void(const std::string&)>& note = {});

}  // namespace bodkin::fem
