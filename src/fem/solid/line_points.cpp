#include "fem/solid/line_points.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "fem/solid/left_points.h"

namespace bodkin::fem {

namespace {

constexpr double reach = 5.0;  // mm outside the mesh, whose surface has been rounded off
constexpr std::ptrdiff_t most_in_element = 2;

}  // namespace

LinePoints::LinePoints(const ContactBody& body, double tip_radius, const BoundPoints& bound, int threads)
    : body_(body), bound_(bound), tip_radius_(tip_radius), pool_(threads) {}

void LinePoints::add(std::span<const ContactSite> sites, const Vec3& direction) {
  for (const ContactSite& site : sites) {
    const PointInMesh place = body_.finder_.find(site.place, reach);
    if (!place.moves()) continue;
    const auto there =
        std::ranges::count(points_, place.element, [](const Point& point) { return point.place.element; });
    if (!site.border && there >= most_in_element) continue;
    points_.push_back({site, direction, place});
  }
  between_.resize(points_.size());
  gains_.resize(points_.size());
}

void LinePoints::keep_first(std::size_t count) {
  if (count >= points_.size()) return;
  points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(count), points_.end());
  between_.resize(count);
  gains_.resize(count);
  if (responses_.size() <= count) return;
  responses_.erase(responses_.begin() + static_cast<std::ptrdiff_t>(count), responses_.end());
  shares_.resize(std::min(shares_.size(), count));
}

// The missing displacements of the whole body by forces on the points up to `to`.
void LinePoints::respond(std::size_t to) {
  const std::size_t from = responses_.size();
  if (from >= to) return;
  responses_.resize(to);
  pool_.run((to - from + ContactBody::points_at_once - 1) / ContactBody::points_at_once, [&](std::size_t batch) {
    const std::size_t first = from + batch * ContactBody::points_at_once,
                      last = std::min(to, first + ContactBody::points_at_once);
    std::vector<CarriedPoint> loads;
    for (std::size_t i = first; i < last; ++i) loads.push_back(load_of(points_[i]));
    std::vector<PointResponse> found = body_.factor_->respond(loads);
    std::move(found.begin(), found.end(), responses_.begin() + static_cast<std::ptrdiff_t>(first));
  });
}

void LinePoints::share(std::size_t to) {
  const std::size_t from = shares_.size();
  if (from >= to) return;
  shares_.resize(to);
  if (bound_.empty()) return;
  pool_.run(to - from, [&](std::size_t i) { shares_[from + i] = bound_.shares({&responses_[from + i], 1}); });
}

void LinePoints::compute(std::size_t from, std::size_t to) {
  respond(to);
  share(to);
  pool_.run(to - from, [&](std::size_t which) {
    const std::size_t j = from + which;
    between_[j].resize(j + 1);
    for (std::size_t i = 0; i <= j; ++i) {
      between_[j][i] = compliance_between(responses_[i], responses_[j]);
      if (!bound_.empty()) between_[j][i] -= bound_.taken(shares_[i], 0, shares_[j], 0);
    }
    if (!gains_[j]) gains_[j] = gain_of(j);
    between_[j][j] += *gains_[j];
  });
}

void LinePoints::bind_again() {
  shares_.clear();
  compute(0, size());
}

void LinePoints::stream(std::size_t from, const std::function<bool(const ContactPoint&)>& next) {
  std::size_t group = 1;
  for (; from < size(); from += group, group = std::min(2 * group, ContactBody::points_at_once)) {
    const std::size_t to = std::min(size(), from + group);
    compute(from, to);
    for (std::size_t i = from; i < to; ++i) {
      if (!next(point(i))) return;
    }
  }
}

ContactPoint LinePoints::point(std::size_t i) const {
  const Point& here = points_[i];
  ContactPoint made{here.site.place, here.site.tissue, {here.place.nodes, here.place.weights}, between_[i], {}};
  if (!bound_.empty()) made.on_held = bound_.on_held(shares_[i], 0);
  return made;
}

CarriedPoint LinePoints::load_of(const Point& point) const {
  if (!point.site.resists) return body_.carried(point.place);
  return carried_point(places_of(disk_of(point), body_.finder_, reach), body_.free_nodes_, body_.edges_);
}

// mm/N, the compliance that the mesh lacks at a point.
Mat3 LinePoints::gain_of(std::size_t i) const {
  const BodyDescription& body = *body_.body_;
  Mat3 regular = shaft_gain_in(body.mesh, body.materials, points_[i].place.element);
  if (!points_[i].site.resists) return regular;
  const Mat3 gain = refinement_gain({body.mesh, body_.fixed_, body_.stiff_skin_}, body_.finder_, body.materials,
                                    disk_of(points_[i]));
  // A disk in held elements has no other compliance.
  return responses_[i].path.empty() ? Mat3(gain + regular) : gain;
}

}  // namespace bodkin::fem
