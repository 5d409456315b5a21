#pragma once

#include "anatomy/tissue.h"
#include "anatomy/volume.h"
#include "core/geometry.h"

namespace bodkin::simulation {

// Detects the tick in which a needle's tip enters the body, and stores the line on which it did: entry point p0 and
// direction u0, frozen until release() (Heng et al. 2004, section 6.3).
class NeedleContact {
 public:
  // A new tick while the needle is free. `tissue`: at the tip. Returns true when contact begins: the tip moved from
  // air into tissue along its axis. The entry point is found between the two ticks by bisection on the tissues. A
  // needle whose first pose is inside the body touches it there as soon as it advances.
  bool touches(const Vec3& tip, const Vec3& axis, anatomy::TissueId tissue,
               const anatomy::TissueVolume& tissues) noexcept;
  // A new tick while the line is frozen.
  void follow(const Vec3& tip, anatomy::TissueId tissue) noexcept;
  // Frees the needle again.
  void release() noexcept { held_ = false; }
  void reset() noexcept { *this = NeedleContact(); }

  bool held() const noexcept { return held_; }
  const Vec3& entry() const noexcept { return entry_; }
  const Vec3& direction() const noexcept { return direction_; }
  // mm of the tip along the frozen line.
  double depth(const Vec3& tip) const noexcept { return (tip - entry_).dot(direction_); }

 private:
  bool held_ = false;
  bool seen_ = false;  // there was an earlier tick
  bool was_in_air_ = true;
  Vec3 last_tip_ = Vec3::Zero();
  Vec3 entry_ = Vec3::Zero();
  Vec3 direction_ = Vec3::UnitZ();
};

}  // namespace bodkin::simulation
