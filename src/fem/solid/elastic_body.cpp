#include "fem/solid/elastic_body.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "fem/solid/mesh_place.h"
#include "fem/solid/mesh_soundness.h"

namespace bodkin::fem {

namespace {

void check_corridor(const BodyDescription& body) {
  std::vector<bool> taken(body.mesh.nodes.size(), false), fixed(body.mesh.nodes.size(), false);
  for (const std::uint32_t node : body.fixed) fixed[node] = true;
  std::size_t free = 0;
  for (const std::uint32_t node : body.corridor) {
    if (node >= body.mesh.nodes.size()) {
      throw InputError(fmt::format("node {} of the corridor is not in the mesh, whose nodes are 0 to {}", node,
                                   body.mesh.nodes.size() - 1));
    }
    if (taken[node]) {
      throw InputError(fmt::format("node {} of the corridor, at {}, is named twice; name each node once", node,
                                   place_of(body.mesh.nodes[node])));
    }
    taken[node] = true;
    if (!fixed[node]) ++free;
  }
  if (free == 0) {
    throw InputError(
        fmt::format("none of the {} nodes of the corridor can move, so that a needle would feel nothing; "
                    "lead the corridor through soft tissue",
                    body.corridor.size()));
  }
}

// For every node of the mesh.
std::vector<anatomy::TissueId> stiffest_tissues(const BodyDescription& body) {
  std::vector<anatomy::TissueId> tissues(body.mesh.nodes.size());
  std::vector<double> young(body.mesh.nodes.size(), 0.0);
  for (std::size_t element = 0; element < body.mesh.elements.size(); ++element) {
    const anatomy::TissueId tissue = body.mesh.tissues[element];
    const double stiffness = body.materials.find(tissue)->young;
    for (const std::uint32_t node : body.mesh.elements[element]) {
      if (stiffness <= young[node]) continue;
      young[node] = stiffness;
      tissues[node] = tissue;
    }
  }
  return tissues;
}

MultifrontalCholesky factorise(const BodyDescription& body, const BodyPlan& plan, const FactorOptions& options,
                               const Progress& progress) {
  try {
    return MultifrontalCholesky(plan.system.stiffness, plan.symbolic, options, progress);
  } catch (const NotPositiveDefinite& failure) {
    const std::uint32_t node = plan.system.mesh_node_of(failure.node);
    throw InputError(
        fmt::format("the part of the body around node {} at {} can move without resistance: it hangs by a "
                    "node or an edge alone, or is millions of times softer than what surrounds it; mesh it "
                    "so that it shares faces with the rest, or fix three of its nodes",
                    node, place_of(body.mesh.nodes[node])));
  }
}

}  // namespace

std::vector<std::string> check_body(const BodyDescription& body) {
  std::vector<std::string> warnings = check_mesh(body.mesh);
  for (std::string& warning : check_materials(body.mesh, body.materials)) warnings.push_back(std::move(warning));
  check_supports(body.mesh, body.fixed);
  return warnings;
}

BodyPlan plan_body(const BodyDescription& body, const Progress& progress, QuadraticEdges edges) {
  if (progress) progress("assembling the body", 0.0);
  BodyPlan plan;
  plan.system = assemble(body.mesh, body.materials, body.fixed, std::move(edges));
  if (progress) progress("ordering the body", 0.0);
  const std::vector<anatomy::TissueId> tissues = stiffest_tissues(body);
  std::vector<std::uint32_t> last;
  for (const std::uint32_t node : body.corridor) {
    if (plan.system.free_nodes[node] == ElasticSystem::fixed) continue;
    last.push_back(plan.system.free_nodes[node]);
    plan.corridor.mesh_nodes.push_back(node);
    plan.corridor.nodes.push_back(body.mesh.nodes[node]);
    plan.corridor.tissues.push_back(tissues[node]);
  }
  plan.symbolic = analyse(graph_of(plan.system.stiffness), last);
  return plan;
}

ElasticBody::ElasticBody(const BodyDescription& body, BodyPlan plan, const FactorOptions& options,
                         const Progress& progress)
    : plan_(std::move(plan)), factor_(factorise(body, plan_, options, progress)) {}

anatomy::CondensedBody ElasticBody::condensed() const {
  anatomy::CondensedBody body = plan_.corridor;
  body.compliance = factor_.last_compliance();
  return body;
}

Eigen::MatrixXd ElasticBody::on_all_nodes(const Eigen::MatrixXd& of_free_nodes) const {
  Eigen::MatrixXd all =
      Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(plan_.system.free_nodes.size()), of_free_nodes.cols());
  for (std::size_t i = 0; i < plan_.system.mesh_nodes.size(); ++i)
    all.middleRows<3>(3 * Eigen::Index{plan_.system.mesh_nodes[i]}) =
        of_free_nodes.middleRows<3>(3 * static_cast<Eigen::Index>(i));
  return all;
}

Eigen::MatrixXd ElasticBody::displacement(const Eigen::MatrixXd& forces) const {
  Eigen::MatrixXd on_free = Eigen::MatrixXd::Zero(3 * Eigen::Index{plan_.system.stiffness.nodes}, forces.cols());
  for (std::size_t i = 0; i < plan_.system.mesh_nodes.size(); ++i)
    on_free.middleRows<3>(3 * static_cast<Eigen::Index>(i)) =
        forces.middleRows<3>(3 * Eigen::Index{plan_.system.mesh_nodes[i]});
  return on_all_nodes(factor_.solve(on_free));
}

Eigen::MatrixXd ElasticBody::displacement_by_corridor(const Eigen::MatrixXd& forces) const {
  return on_all_nodes(factor_.respond(forces));
}

anatomy::CondensedBody condense(const BodyDescription& body, FactorOptions options, const Progress& progress,
                                const std::function<void(const std::string&)>& note) {
  for (const std::string& warning : check_body(body)) {
    if (note) note(warning);
  }
  check_corridor(body);
  options.keep_field = false;
  BodyPlan plan = plan_body(body, progress);
  if (note) {
    note(fmt::format("preparing a deformable body of {} nodes, {} of them in the corridor, takes {} MB",
                     body.mesh.nodes.size(), plan.corridor.nodes.size(), (plan.symbolic.bytes(false) >> 20U) + 1));
  }
  return ElasticBody(body, std::move(plan), options, progress).condensed();
}

}  // namespace bodkin::fem
