#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "anatomy/force_settings.h"
#include "core/geometry.h"
#include "fem/shaft_compliance.h"

namespace bodkin::fem {

// Stress relaxation of the tissue along a needle: a linear viscoelastic body whose elastic response S
// (ShaftCompliance) relaxes with the same Prony series everywhere. At each contact point the elastic force e is the
// one that would hold the tissue in place without relaxation, and f the one that does:
//
//   u = S e,   f = e - sum q_k,   q_k' = (g_k e - q_k) / tau_k
//
// so that S f = u - S h with h = sum q_k: for the constraints h is a motion of the tissue itself, moved(). q_k is
// exact for an e that is constant over a tick; e of the previous tick is used. A point from which the needle was
// withdrawn continues to relax without a force, and so does its effect on the other points.
//
// In the frame of the insertion, 3 numbers for each point: along, across, across. The points are those of the
// compliance, in its order. Only the constructor allocates or throws; nothing locks.
class RelaxingTissue {
 public:
  // Without terms nothing relaxes, and all functions return at once. `spring`: mm/N, of a spring that S contains for
  // the sum of all forces, and that does not relax. Throws InputError for shares or times out of range.
  RelaxingTissue(std::span<const anatomy::PronyTerm> terms, double dt, std::size_t most_points, double spring = 0.0);

  bool relaxes() const noexcept { return !shares_.empty(); }
  // Forgets all state.
  void clear() noexcept;
  // Advances by a tick. `forces`: f of the previous tick, N.
  void step(const ShaftCompliance& compliance, std::span<const double> forces) noexcept;
  // To be called after a point was added to the compliance, and before the last one is removed from it.
  void added(const ShaftCompliance& compliance) noexcept;
  void removing_last(const ShaftCompliance& compliance) noexcept;
  // Forgets the state of points beyond those of the compliance, because others will replace them.
  void drop_removed() noexcept;
  // From now on the points have another compliance.
  void exchange(const ShaftCompliance& compliance) noexcept;

  // mm, S h at a point of the compliance.
  Vec3 moved(std::size_t point) const noexcept {
    return relaxes() ? Vec3(Eigen::Map<const Vec3>(moved_.data() + 3 * point)) : Vec3(Vec3::Zero());
  }
  // N, e - f = h at a point of the compliance.
  Vec3 faded(std::size_t point) const noexcept {
    return relaxes() ? Vec3(Eigen::Map<const Vec3>(faded_.data() + 3 * point)) : Vec3(Vec3::Zero());
  }
  // N mm, stored at the points of the compliance; `forces`: f of this tick. Quadratic in their number.
  double stored_energy(const ShaftCompliance& compliance, std::span<const double> forces) const noexcept;

 private:
  void find_moved(const ShaftCompliance& compliance) noexcept;
  double between(const ShaftCompliance& compliance, std::size_t one, std::size_t other) const noexcept;

  double spring_;
  std::size_t stride_;                           // numbers per term, 3 for each point, and some spare
  std::vector<double> shares_, decays_;          // by term: g_k; exp(-dt / tau_k)
  std::vector<double> parts_;                    // by term, q_k, N
  std::vector<double> by_removed_;               // by term, mm: S q_k of the points that were removed
  std::vector<double> faded_, moved_, removed_;  // h, N; S h, mm; its part of the points that were removed, mm
  std::size_t points_ = 0, touched_ = 0;         // of the compliance; the most so far
};

}  // namespace bodkin::fem
