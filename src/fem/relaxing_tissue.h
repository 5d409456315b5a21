#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "anatomy/force_settings.h"
#include "core/geometry.h"
#include "fem/shaft_compliance.h"

namespace bodkin::fem {

// Stress relaxation of the tissue along a needle: a linear viscoelastic body whose elastic answer S (ShaftCompliance)
// fades with the same Prony series everywhere. At each contact point the elastic force e is what would hold the
// tissue where it is without relaxation, and f is what does hold it:
//
//   u = S e,   f = e - sum q_k,   q_k' = (g_k e - q_k) / tau_k
//
// so that S f = u - S h with h = sum q_k: to the constraints h is a motion that the tissue makes by itself, moved().
// q_k is exact for an e that is constant over a tick, that of the tick before. A point from which the needle was
// withdrawn goes on relaxing without a force, and so do the other points by what it had moved them.
//
// In the frame of the insertion, 3 numbers for each point: along, across, across. The points are those of the
// compliance, in its order. Nothing is allocated, thrown or locked but by the constructor.
class RelaxingTissue {
 public:
  // No terms: nothing relaxes, and all functions return at once. `spring`: mm/N, of a spring that S contains for the
  // sum of all forces, and that does not relax. Throws InputError for shares or times out of range.
  RelaxingTissue(std::span<const anatomy::PronyTerm> terms, double dt, std::size_t most_points, double spring = 0.0);

  bool relaxes() const noexcept { return !shares_.empty(); }
  // Forgets all.
  void clear() noexcept;
  // A tick later. `forces`: f of the tick before, N.
  void step(const ShaftCompliance& compliance, std::span<const double> forces) noexcept;
  // After a point was added to the compliance, and before the last one is removed from it.
  void added(const ShaftCompliance& compliance) noexcept;
  void removing_last(const ShaftCompliance& compliance) noexcept;
  // Forgets what the points beyond those of the compliance had, because others will come in their place.
  void drop_removed() noexcept;
  // The points have another compliance from now on.
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
  std::size_t stride_;                           // numbers of a term, 3 for each point, and some to spare
  std::vector<double> shares_, decays_;          // by term: g_k; exp(-dt / tau_k)
  std::vector<double> parts_;                    // by term, q_k, N
  std::vector<double> by_removed_;               // by term, mm: S q_k of the points that were removed
  std::vector<double> faded_, moved_, removed_;  // h, N; S h, mm; its part of the points that were removed, mm
  std::size_t points_ = 0, touched_ = 0;         // of the compliance; the most that there were
};

}  // namespace bodkin::fem
