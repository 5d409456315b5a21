#pragma once

#include <algorithm>
#include <array>

#include "anatomy/case.h"
#include "forces/events.h"

namespace bodkin::simulation {

// Bone in front of the tip of a needle in a deformable body, whose bone does not move and so has no nodes to push: a
// spring from the point where the tip met it, that never breaks. The needle in the body stays there, at the bone's
// surface, so that the device renders one stiffness at a time.
class BoneWall {
 public:
  // At most as stiff as the patient's device renders.
  explicit BoneWall(const anatomy::Case& patient) {
    for (const anatomy::TissueProperties& tissue : patient.library.tissues()) {
      if (tissue.layered.kind == anatomy::LayeredKind::rigid)
        stiffness_[tissue.id] = std::min(tissue.layered.contact_stiffness, patient.description.device.stiffness);
    }
  }

  // N along the line, positive pushes out. `depth`: mm of the tip along the line; `at`: its tissue. The surface stays
  // where the tip met it until the tip is in front of it and out of the bone.
  double step(double depth, anatomy::TissueId at, forces::TickEvents& events) noexcept {
    if (!met_ && stiffness_[at] > 0.0) {
      met_ = true;
      from_ = depth;
      bone_ = at;
      events.push({forces::EventKind::bone_contact, at, depth, 0.0});
    }
    if (met_ && depth < from_ && stiffness_[at] == 0.0) {
      met_ = false;
      events.push({forces::EventKind::bone_left, bone_, depth, 0.0});
    }
    behind_ = met_ ? std::max(depth - from_, 0.0) : 0.0;
    return stiffness_[bone_] * behind_;
  }
  // mm that the hand's tip is behind the bone's surface.
  double behind() const noexcept { return behind_; }
  bool met() const noexcept { return met_; }
  void reset() noexcept {
    met_ = false;
    behind_ = 0.0;
  }

 private:
  std::array<double, 256> stiffness_{};  // N/mm, by TissueId; 0 = no bone
  bool met_ = false;
  double from_ = 0.0, behind_ = 0.0;  // mm
  anatomy::TissueId bone_ = anatomy::tissue::air;
};

}  // namespace bodkin::simulation
