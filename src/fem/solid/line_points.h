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
#include "fem/solid/needle_stations.h"
#include "fem/solid/tip_compliance.h"

namespace bodkin::fem {

// The contact points of one needle's line in a body, computed group by group from the entry on. The line may be led
// on in another direction: keep_first() what the needle has reached, add() what lies ahead of it now.
class LinePoints {
 public:
  // `body` and `bound` (of this body, with what it does) must outlive this. `tip_radius`: mm, above 0. `threads`
  // share the work (0: as many as the machine has cores); any number of them gives the same bits.
  LinePoints(const ContactBody& body, double tip_radius, const BoundPoints& bound, int threads = 1);

  // Adds a point for each of these stations of a line along the unit vector `direction`, in their order; nothing is
  // computed. Left out are stations farther than 5 mm from the mesh, and the third and further ones without a border
  // in one element.
  void add(std::span<const NeedleStation> stations, const Vec3& direction);
  // Removes the points behind the first `count`.
  void keep_first(std::size_t count);
  std::size_t size() const noexcept { return points_.size(); }
  // That the needle is in behind this point.
  anatomy::TissueId tissue(std::size_t i) const noexcept { return points_[i].station.tissue; }

  // Computes the points up to `to`, where point(i) is known for all before `from`; for one that the line was led on
  // from its displacements are enough, and are computed here when they are missing.
  void compute(std::size_t from, std::size_t to);
  // Computes the points from `from` on in groups, the first alone and the largest of 8. `next` hears each one, and
  // says whether to go on.
  void stream(std::size_t from, const std::function<bool(const ContactPoint&)>& next);
  // What is bound is other than it was: computes all points anew, as far as that changes them.
  void bind_again();
  // One that has been computed.
  ContactPoint point(std::size_t i) const;

 private:
  struct Point {
    NeedleStation station;
    Vec3 direction;
    PointInMesh place;
  };

  TipDisk disk_of(const Point& point) const { return {point.station.place, point.direction, tip_radius_}; }
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
  std::vector<std::optional<Mat3>> gains_;  // mm/N, what the mesh lacks at each point; nothing: not computed
  std::vector<std::vector<Mat3>> between_;  // of each point with those before it, and itself; empty: not computed
};

}  // namespace bodkin::fem
