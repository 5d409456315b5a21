#include "simulation/needle_contact.h"

namespace bodkin::simulation {

namespace {

constexpr int bisections = 24;  // a step of 1 m is then known to 0.1 um

Vec3 surface_between(Vec3 outside, Vec3 inside, const anatomy::TissueVolume& tissues) noexcept {
  for (int step = 0; step < bisections; ++step) {
    const Vec3 middle = 0.5 * (outside + inside);
    (anatomy::nearest<anatomy::TissueId>(tissues, middle, anatomy::tissue::air) == anatomy::tissue::air ? outside
                                                                                                        : inside) =
        middle;
  }
  return inside;
}

}  // namespace

void NeedleContact::follow(const Vec3& tip, anatomy::TissueId tissue) noexcept {
  last_tip_ = tip;
  was_in_air_ = tissue == anatomy::tissue::air;
  seen_ = true;
}

bool NeedleContact::touches(const Vec3& tip, const Vec3& axis, anatomy::TissueId tissue,
                            const anatomy::TissueVolume& tissues) noexcept {
  if (tissue != anatomy::tissue::air && seen_) {
    const Vec3 entry = was_in_air_ ? surface_between(last_tip_, tip, tissues) : last_tip_;
    // A tip that slides into the body sideways or backwards makes contact only once it advances.
    if ((tip - entry).dot(axis) > 0.0) {
      held_ = true;
      entry_ = entry;
      direction_ = axis;
    }
  }
  follow(tip, tissue);
  return held_;
}

}  // namespace bodkin::simulation
