#include "fem/solid/contact_body.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "fem/solid/left_points.h"
#include "fem/solid/line_points.h"

namespace bodkin::fem {

namespace {

BodyDescription without_corridor(const BodyDescription& body) {
  return {body.mesh, body.materials, body.fixed, {}};
}

std::vector<bool> fixed_nodes(const BodyDescription& body) {
  std::vector<bool> fixed(body.mesh.nodes.size(), false);
  for (const std::uint32_t node : body.fixed) fixed[node] = true;
  return fixed;
}

}  // namespace

ContactBody::ContactBody(std::shared_ptr<const BodyDescription> body, PackedFactor factor)
    : body_(std::move(body)),
      fixed_(fixed_nodes(*body_)),
      stiff_skin_(elements_of_stiff_skin(body_->mesh, body_->materials, fixed_)),
      edges_(body_->mesh, stiff_skin_, fixed_),
      factor_(std::make_shared<const PackedFactor>(std::move(factor))),
      finder_(body_->mesh) {
  std::uint32_t free = 0;
  for (const bool fixed : fixed_) free_nodes_.push_back(fixed ? ElasticSystem::fixed : free++);
  free += static_cast<std::uint32_t>(edges_.size());
  if (free != factor_->nodes()) {
    throw InputError(fmt::format("the factor is of {} nodes and edges that can move, but the body has {} of them",
                                 factor_->nodes(), free));
  }
}

ContactBody::ContactBody(std::shared_ptr<const BodyDescription> body, const FactorOptions& options,
                         const Progress& progress)
    : body_(std::move(body)),
      fixed_(fixed_nodes(*body_)),
      stiff_skin_(elements_of_stiff_skin(body_->mesh, body_->materials, fixed_)),
      edges_(body_->mesh, stiff_skin_, fixed_),
      finder_(body_->mesh) {
  const BodyDescription whole = without_corridor(*body_);
  BodyPlan plan = plan_body(whole, progress, edges_);
  free_nodes_ = plan.system.free_nodes;
  const auto packed = std::make_shared<PackedFactor>(plan.symbolic);
  // Each panel is written directly to its final place: the factor is in memory only once.
  FactorOptions once = options;
  once.keep_field = false;
  once.finished = [&packed](std::size_t supernode, const double* panel, ThreadPool& pool) {
    packed->take(supernode, panel, pool);
  };
  once.used_elsewhere = packed->bytes();
  const ElasticBody elastic(whole, std::move(plan), once, progress);
  factor_ = packed;
}

CarriedPoint ContactBody::carried(const PointInMesh& place) const {
  return carried_point({&place, 1}, free_nodes_, {});
}

Eigen::MatrixXd ContactBody::displacements(std::span<const CarriedPoint> points,
                                           std::span<const std::uint32_t> nodes) const {
  std::vector<std::uint32_t> free;
  for (const std::uint32_t node : nodes)
    if (!fixed_[node]) free.push_back(free_nodes_[node]);
  const Eigen::MatrixXd moved = factor_->displacements(factor_->respond(points), free);
  Eigen::MatrixXd found = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(3 * nodes.size()), moved.cols());
  Eigen::Index from = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (fixed_[nodes[i]]) continue;
    found.middleRows<3>(static_cast<Eigen::Index>(3 * i)) = moved.middleRows<3>(from);
    from += 3;
  }
  return found;
}

BoundPoints ContactBody::bind(std::span<const anatomy::NeedlePath> left, std::span<const std::uint32_t> held) const {
  std::vector<BoundPoints::Group> groups;
  const auto respond = [this](BoundPoints::Group& group, const std::vector<CarriedPoint>& loads) {
    for (std::size_t from = 0; from < loads.size(); from += points_at_once) {
      const std::size_t count = std::min(points_at_once, loads.size() - from);
      std::vector<PointResponse> found = factor_->respond({loads.data() + from, count});
      std::move(found.begin(), found.end(), std::back_inserter(group.responses));
    }
  };
  for (const anatomy::NeedlePath& needle : left) {
    BoundPoints::Group group;
    group.is_free = true;
    std::vector<CarriedPoint> loads;
    for (const LeftPoint& point : left_points(body_->mesh, finder_, body_->materials, needle)) {
      loads.push_back(carried(point.in_mesh));
      group.places.push_back(point.place);
      group.gains.push_back(point.gain);
    }
    respond(group, loads);
    groups.push_back(std::move(group));
  }
  BoundPoints::Group nodes;
  std::vector<CarriedPoint> loads;
  for (const std::uint32_t node : held) {
    if (node >= body_->mesh.nodes.size()) {
      throw InputError(fmt::format("node {} is held but not in the mesh, whose nodes are 0 to {}", node,
                                   body_->mesh.nodes.size() - 1));
    }
    if (fixed_[node]) continue;
    loads.push_back({{{free_nodes_[node], 1.0}}});
    nodes.places.push_back(body_->mesh.nodes[node]);
    nodes.gains.push_back(Mat3::Zero());
  }
  respond(nodes, loads);
  groups.push_back(std::move(nodes));
  return BoundPoints(std::move(groups));
}

anatomy::CondensedBody ContactBody::contact_points(std::span<const ContactSite> sites, const Vec3& direction,
                                                   double tip_radius, int threads, const BoundPoints& bound) const {
  LinePoints points(*this, tip_radius, bound, threads);
  points.add(sites, direction);
  if (points.size() == 0) {
    throw InputError(
        "the needle's path meets no part of the mesh; lead it through the meshed part of the patient, or mesh the "
        "patient again around this path");
  }
  points.compute(0, points.size());
  anatomy::CondensedBody body;
  const auto size = static_cast<Eigen::Index>(3 * points.size());
  body.compliance.resize(size, size);
  for (std::size_t j = 0; j < points.size(); ++j) {
    const ContactPoint point = points.point(j);
    body.nodes.push_back(point.place);
    body.tissues.push_back(point.tissue);
    body.in_mesh.push_back(point.in_mesh);
    for (std::size_t i = 0; i <= j; ++i) {
      const auto row = static_cast<Eigen::Index>(3 * i), column = static_cast<Eigen::Index>(3 * j);
      body.compliance.block<3, 3>(row, column) = point.between[i];
      body.compliance.block<3, 3>(column, row) = point.between[i].transpose();
    }
  }
  return body;
}

}  // namespace bodkin::fem
