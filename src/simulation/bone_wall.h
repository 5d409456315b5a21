#pragma once

#include <algorithm>
#include <array>

#include "anatomy/case.h"
#include "forces/events.h"

namespace bodkin {

// Bone before the tip of a needle in a deformable body, whose bone does not move and so has no nodes to push: a
// spring from where the tip met it, that never breaks.
class BoneWall {
 public:
  // `largest`: N/mm that the device has left for it.
  BoneWall(const Case& patient, double largest) {
    for (const TissueProperties& tissue : patient.library.tissues()) {
      if (tissue.layered.kind == LayeredKind::rigid)
        stiffness_[tissue.id] = std::min(tissue.layered.contact_stiffness, largest);
    }
  }

  // N along the line, positive pushes out. `depth`: mm of the tip along the line; `at`: its tissue.
  double step(double depth, TissueId at, TickEvents& events) noexcept {
    if (!met_ && stiffness_[at] > 0.0) {
      met_ = true;
      from_ = depth;
      bone_ = at;
      events.push({EventKind::bone_contact, at, depth, 0.0});
    }
    if (met_ && depth < from_) {
      met_ = false;
      events.push({EventKind::bone_left, bone_, depth, 0.0});
    }
    return met_ ? stiffness_[bone_] * (depth - from_) : 0.0;
  }
  bool met() const noexcept { return met_; }
  void reset() noexcept { met_ = false; }

 private:
  std::array<double, 256> stiffness_{};  // N/mm, by TissueId; 0 = no bone
  bool met_ = false;
  double from_ = 0.0;  // mm
  TissueId bone_ = tissue::air;
};

}  // namespace bodkin
