#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/thread_pool.h"
#include "fem/contact_line.h"
#include "fem/solid/bound_points.h"
#include "fem/solid/contact_body.h"
#include "fem/solid/contact_sites.h"
#include "fem/solid/tip_compliance.h"

namespace bodkin::fem {

// The contact points of one needle's line in a body, computed group by group from the entry. The line may continue in
// another direction: keep_first() keeps the points that the needle has reached, add() adds those ahead of it.
class LinePoints {
 public:
  // `body` and `bound` (bound points of this body) must outlive this. `tip_radius`: mm, above 0. `threads` share the
  // work (0: one per core); any number of them gives the same bits.
  LinePoints(const ContactBody& body, double tip_radius, const BoundPoints& bound, int threads = 1);

  // Adds a point for each of these sites of a line along the unit vector `direction`, in their order; nothing is
  // computed. Left out are sites farther than 5 mm from the mesh, and the third and later ones without a border in
  // one element.
  void add(std::span<const ContactSite> sites, const Vec3& direction);
  // Removes the points behind the first `count`.
  void keep_first(std::size_t count);
  std::size_t size() const noexcept { return points_.size(); }
  // The tissue of the needle behind this point.
  anatomy::TissueId tissue(std::size_t i) const noexcept { return points_[i].site.tissue; }

  // Computes the points up to `to`; point(i) must be known for all before `from`. For a point before a change of
  // direction the displacements suffice; missing ones are computed here.
  void compute(std::size_t from, std::size_t to);
  // Computes the points from `from` on in groups, the first of one point and the largest of 8. `next` receives each
  // point, and returns whether to continue.
  void stream(std::size_t from, const std::function<bool(const ContactPoint&)>& next);
  // The bound points have changed: recomputes all points, as far as that affects them.
  void bind_again();
  // A point that has been computed.
  ContactPoint point(std::size_t i) const;

 private:
  struct Point {
    ContactSite site;
    Vec3 direction;
    PointInMesh place;
  };

  TipDisk disk_of(const Point& point) const { return {point.site.place, point.direction, tip_radius_}; }
  CarriedPoint load_of(const Point& point) const;
  Mat3 gain_of(std::size_t i) const;
  void respond(std::size_t to);
  void share(std::size_t to);

  const ContactBody& body_;
  const BoundPoints& bound_;
  double tip_radius_;
  ThreadPool pool_;
  std::vector<Point> points_;
  std::vector<PointResponse> responses_;    // of the first points
  std::vector<Eigen::MatrixXd> shares_;     // BoundPoints::shares() of the first of them
  std::vector<std::optional<Mat3>> gains_;  // mm/N, compliance that the mesh lacks at each point; empty: not computed
  std::vector<std::vector<Mat3>> between_;  // of each point with those before it, and itself; empty: not computed
};

}  // namespace bodkin::fem
