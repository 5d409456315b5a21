#include "fem/solid/contact_body.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "core/thread_pool.h"
#include "fem/solid/left_points.h"
#include "fem/solid/tip_compliance.h"

namespace bodkin::fem {

namespace {

constexpr double reach = 5.0;  // mm outside the mesh, where its surface has been rounded off
constexpr std::size_t most_in_element = 2;
constexpr std::size_t points_at_once = 8;  // that share reading the factor

BodyDescription without_corridor(const BodyDescription& body) {
  return {body.mesh, body.materials, body.fixed, {}};
}

}  // namespace

ContactBody::ContactBody(std::shared_ptr<const BodyDescription> body, const FactorOptions& options,
                         const Progress& progress)
    : body_(std::move(body)), fixed_(body_->mesh.nodes.size(), false), finder_(body_->mesh) {
  for (const std::uint32_t node : body_->fixed) fixed_[node] = true;
  const BodyDescription whole = without_corridor(*body_);
  BodyPlan plan = plan_body(whole, progress);
  free_nodes_ = plan.system.free_nodes;
  const auto packed = std::make_shared<PackedFactor>(plan.symbolic);
  // Each panel goes straight to where it is kept: the factor is in memory once.
  FactorOptions once = options;
  once.keep_field = false;
  once.finished = [&packed](std::size_t supernode, const double* panel, ThreadPool& pool) {
    packed->take(supernode, panel, pool);
  };
  once.taken_elsewhere = packed->bytes();
  const ElasticBody elastic(whole, std::move(plan), once, progress);
  factor_ = packed;
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

// The points of one line, computed group by group from the entry on.
class ContactBody::Points {
 public:
  Points(const ContactBody& body, std::span<const NeedleStation> stations, const Vec3& direction, double tip_radius,
         int threads, const BoundPoints& bound)
      : body_(body), bound_(bound), direction_(direction), tip_radius_(tip_radius), pool_(threads) {
    std::map<std::uint32_t, std::size_t> in_element;
    for (const NeedleStation& station : stations) {
      const PointInMesh place = body.finder_.find(station.place, reach);
      if (!place.moves()) continue;
      std::size_t& there = in_element[place.element];
      if (!station.border && there >= most_in_element) continue;
      ++there;
      points_.push_back({&station, place});
    }
    responses_.resize(points_.size());
    shares_.resize(points_.size());
    between_.resize(points_.size());
  }

  std::size_t size() const noexcept { return points_.size(); }

  // Points `from` to `to`; those before `from` have been computed.
  void compute(std::size_t from, std::size_t to) {
    pool_.run((to - from + points_at_once - 1) / points_at_once, [&](std::size_t batch) {
      const std::size_t first = from + batch * points_at_once, last = std::min(to, first + points_at_once);
      std::vector<CarriedPoint> loads;
      for (std::size_t i = first; i < last; ++i) loads.push_back(load_of(points_[i]));
      std::vector<PointResponse> found = body_.factor_->respond(loads);
      std::move(found.begin(), found.end(), responses_.begin() + static_cast<std::ptrdiff_t>(first));
      if (bound_.empty()) return;
      for (std::size_t i = first; i < last; ++i) shares_[i] = bound_.shares({&responses_[i], 1});
    });
    pool_.run(to - from, [&](std::size_t which) {
      const std::size_t j = from + which;
      between_[j].resize(j + 1);
      for (std::size_t i = 0; i <= j; ++i) {
        between_[j][i] = compliance_between(responses_[i], responses_[j]);
        if (!bound_.empty()) between_[j][i] -= bound_.taken(shares_[i], 0, shares_[j], 0);
      }
      between_[j][j] += gain_of(j);
    });
  }

  ContactPoint point(std::size_t i) const {
    const Point& here = points_[i];
    return {here.station->place, here.station->tissue, {here.place.nodes, here.place.weights}, between_[i]};
  }

 private:
  struct Point {
    const NeedleStation* station;
    PointInMesh place;
  };

  TipDisk disk_of(const Point& point) const { return {point.station->place, direction_, tip_radius_}; }

  CarriedPoint load_of(const Point& point) const {
    if (!point.station->resists) return body_.carried(point.place);
    CarriedPoint load;
    for (const auto& [node, weight] : shares_of(disk_of(point), body_.finder_, reach)) {
      const std::uint32_t free = body_.free_nodes_[node];
      if (free != ElasticSystem::fixed) load.shares.push_back({free, weight});
    }
    return load;
  }

  // mm/N, what the mesh lacks at a point.
  Mat3 gain_of(std::size_t i) const {
    const BodyDescription& body = *body_.body_;
    Mat3 regular = shaft_gain_in(body.mesh, body.materials, points_[i].place.element);
    if (!points_[i].station->resists) return regular;
    const Mat3 gain = refinement_gain(body.mesh, body_.finder_, body.materials, body_.fixed_, disk_of(points_[i]));
    // A disk in held elements moves by nothing else.
    return responses_[i].path.empty() ? Mat3(gain + regular) : gain;
  }

  const ContactBody& body_;
  const BoundPoints& bound_;
  Vec3 direction_;
  double tip_radius_;
  ThreadPool pool_;
  std::vector<Point> points_;
  std::vector<PointResponse> responses_;
  std::vector<Eigen::MatrixXd> shares_;     // BoundPoints::shares() of each
  std::vector<std::vector<Mat3>> between_;  // of each point with those before it, and itself
};

anatomy::CondensedBody ContactBody::contact_points(std::span<const NeedleStation> stations, const Vec3& direction,
                                                   double tip_radius, int threads, const BoundPoints& bound) const {
  Points points(*this, stations, direction, tip_radius, threads, bound);
  if (points.size() == 0) {
    throw InputError(
        "the needle's path meets no part of the mesh; lead it through the meshed part of the patient, or mesh the "
        "patient anew about this path");
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

void ContactBody::stream(std::span<const NeedleStation> stations, const Vec3& direction, double tip_radius,
                         const std::function<bool(const ContactPoint&)>& next, const BoundPoints& bound) const {
  Points points(*this, stations, direction, tip_radius, 1, bound);
  std::size_t group = 1;
  for (std::size_t from = 0; from < points.size(); from += group, group = std::min(2 * group, points_at_once)) {
    const std::size_t to = std::min(points.size(), from + group);
    points.compute(from, to);
    for (std::size_t i = from; i < to; ++i) {
      if (!next(points.point(i))) return;
    }
  }
}

}  // namespace bodkin::fem
