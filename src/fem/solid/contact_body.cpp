#include "fem/solid/contact_body.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "anatomy/mesh_parts.h"
#include "core/error.h"
#include "core/thread_pool.h"
#include "fem/solid/mesh_patch.h"
#include "fem/solid/tip_compliance.h"

namespace bodkin::fem {

namespace {

constexpr double reach = 5.0;  // mm outside the mesh, where its surface has been rounded off
constexpr std::size_t most_in_element = 2;
constexpr std::size_t points_at_once = 8;  // that share reading the factor
constexpr double shaft_radius = 0.5;       // mm: a ball as soft as 1 mm of a thin needle's shaft

BodyDescription without_corridor(const BodyDescription& body) {
  return {body.mesh, body.materials, body.fixed, {}};
}

struct Point {
  const NeedleStation* station;
  PointInMesh place;
};

}  // namespace

ContactBody::ContactBody(std::shared_ptr<const BodyDescription> body, const FactorOptions& options,
                         const Progress& progress)
    : body_(std::move(body)), fixed_(body_->mesh.nodes.size(), false), finder_(body_->mesh) {
  for (const std::uint32_t node : body_->fixed) fixed_[node] = true;
  const BodyDescription whole = without_corridor(*body_);
  FactorOptions kept = options;
  kept.keep_field = true;
  const ElasticBody elastic(whole, plan_body(whole, progress), kept, progress);
  free_nodes_ = elastic.system().free_nodes;
  factor_ = std::make_unique<const PackedFactor>(elastic.factor());
}

CarriedPoint ContactBody::carried(const PointInMesh& place) const {
  CarriedPoint point;
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const std::uint32_t free = free_nodes_[place.nodes[corner]];
    if (free != ElasticSystem::fixed && place.weights[corner] != 0.0)
      point.shares.push_back({free, place.weights[corner]});
  }
  return point;
}

anatomy::CondensedBody ContactBody::contact_points(std::span<const NeedleStation> stations, const Vec3& direction,
                                                   double tip_radius, int threads) const {
  std::vector<Point> points;
  std::map<std::uint32_t, std::size_t> in_element;
  for (const NeedleStation& station : stations) {
    const PointInMesh place = finder_.find(station.place, reach);
    if (!place.moves()) continue;
    std::size_t& there = in_element[place.element];
    if (!station.border && there >= most_in_element) continue;
    ++there;
    points.push_back({&station, place});
  }
  if (points.empty()) {
    throw InputError(
        "the needle's path meets no part of the mesh; lead it through the meshed part of the patient, or mesh the "
        "patient anew about this path");
  }
  ThreadPool pool(threads);
  const std::size_t count = points.size();
  std::vector<PointResponse> responses(count);
  std::vector<Mat3> gains(count);
  const std::size_t batches = (count + points_at_once - 1) / points_at_once;
  const auto disk_of = [&](const Point& point) { return TipDisk{point.station->place, direction, tip_radius}; };
  pool.run(batches, [&](std::size_t batch) {
    const std::size_t from = batch * points_at_once, to = std::min(count, from + points_at_once);
    std::vector<CarriedPoint> loads;
    for (std::size_t i = from; i < to; ++i) {
      CarriedPoint load;
      if (points[i].station->resists) {
        for (const auto& [node, weight] : shares_of(disk_of(points[i]), finder_, reach)) {
          const std::uint32_t free = free_nodes_[node];
          if (free != ElasticSystem::fixed) load.shares.push_back({free, weight});
        }
      } else {
        load = carried(points[i].place);
      }
      loads.push_back(std::move(load));
    }
    std::vector<PointResponse> found = factor_->respond(loads);
    std::move(found.begin(), found.end(), responses.begin() + static_cast<std::ptrdiff_t>(from));
  });
  pool.run(count, [&](std::size_t i) {
    const std::uint32_t element = points[i].place.element;
    const ElasticMaterial& material = *body_->materials.find(body_->mesh.tissues[element]);
    const double regular =
        shaft_gain(material, edge_of_volume(anatomy::element_volume(body_->mesh, element)), shaft_radius);
    gains[i] = points[i].station->resists
                   ? refinement_gain(body_->mesh, finder_, body_->materials, fixed_, disk_of(points[i]))
                   : Mat3(regular * Mat3::Identity());
    // A disk in held elements moves by nothing else.
    if (points[i].station->resists && responses[i].path.empty()) gains[i] += regular * Mat3::Identity();
  });
  anatomy::CondensedBody body;
  body.compliance.resize(3 * static_cast<Eigen::Index>(count), 3 * static_cast<Eigen::Index>(count));
  pool.run(count, [&](std::size_t j) {
    for (std::size_t i = 0; i <= j; ++i) {
      Mat3 between = compliance_between(responses[i], responses[j]);
      if (i == j) between += gains[i];
      const auto row = 3 * static_cast<Eigen::Index>(i), column = 3 * static_cast<Eigen::Index>(j);
      body.compliance.block<3, 3>(row, column) = between;
      body.compliance.block<3, 3>(column, row) = between.transpose();
    }
  });
  for (const Point& point : points) {
    body.nodes.push_back(point.station->place);
    body.tissues.push_back(point.station->tissue);
    body.in_mesh.push_back({point.place.nodes, point.place.weights});
  }
  return body;
}

}  // namespace bodkin::fem
