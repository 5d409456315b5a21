#pragma once

#include <algorithm>

#include "anatomy/tissue.h"
#include "core/axial_motion.h"
#include "forces/events.h"

namespace bodkin::simulation {

// The loss of resistance by which the epidural space is found, detected independently of the force model: the tip has
// passed through the ligamentum flavum into the space behind it, and the force along the needle falls.
//
//   watch      from the first tick in a ligamentum flavum deeper than any before, while the tip is in it or at most
//              `reach` beyond the last of it
//   F_before   the highest force since then; while the needle rests or withdraws it falls with the force
//   lost       the tip is in the space, and F_before - F >= max(`least_drop`, `least_share` F_before)
//
// The drop is measured over the needle's travel and not over time, so that a puncture within one tick and one that
// fades over many are found at 1 mm/s as at 100 mm/s. Relaxation under a resting needle, or unloading by one that is
// withdrawn, is not a loss. A flavum that was passed is not watched again on the same line.
class LossOfResistance {
 public:
  // Forces closer than that cannot be distinguished by a hand: thresholds of 0.03 to 0.06 N (Dosher and Hannaford
  // 2005) and about 7 % (Jones 1989), with a margin for the estimate of the depth.
  static constexpr double least_drop = 0.1;   // N
  static constexpr double least_share = 0.1;  // of F_before
  // A tented ligament is punctured when the tip is already beyond its far side at rest; models tent by up to 8 mm.
  static constexpr double reach = 10.0;  // mm

  void begin() noexcept { *this = LossOfResistance(); }

  // One tick in contact: the tissue at the tip and the force along the line, N. Appends loss_of_resistance with the
  // tissue of the space and the drop, N.
  void step(const AxialMotion& motion, anatomy::TissueId tissue, double force, forces::TickEvents& events) noexcept {
    const bool in_flavum = tissue == anatomy::tissue::ligamentum_flavum;
    if (in_flavum && motion.depth > deepest_) {
      if (!watching_) before_ = 0.0;
      watching_ = true;
      flavum_end_ = motion.depth;
    }
    const bool advances = motion.depth > last_depth_;
    last_depth_ = motion.depth;
    deepest_ = std::max(deepest_, motion.depth);
    if (!watching_) return;
    if (motion.depth > flavum_end_ + reach) {
      watching_ = false;
      return;
    }
    const double drop = before_ - force;
    if (is_epidural_or_beyond(tissue) && advances && drop >= std::max(least_drop, least_share * before_)) {
      events.push({forces::EventKind::loss_of_resistance, tissue, motion.depth, drop});
      watching_ = false;
      return;
    }
    before_ = motion.stopped || motion.direction < 0 ? force : std::max(before_, force);
  }

 private:
  static constexpr bool is_epidural_or_beyond(anatomy::TissueId tissue) noexcept {
    return tissue == anatomy::tissue::epidural_fat || tissue == anatomy::tissue::dura ||
           tissue == anatomy::tissue::cerebrospinal_fluid || tissue == anatomy::tissue::nerve ||
           tissue == anatomy::tissue::spinal_cord;
  }

  bool watching_ = false;
  double before_ = 0.0;      // N
  double flavum_end_ = 0.0;  // mm, deepest position of the tip in the flavum
  double deepest_ = 0.0;     // mm
  double last_depth_ = 0.0;  // mm
};

}  // namespace bodkin::simulation
