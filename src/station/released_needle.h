#pragma once

#include <optional>

#include "core/geometry.h"

namespace bodkin::station {

// A needle in tissue that no hand holds, frozen or clutched: it sticks to the tissue and moves with it. noexcept and
// without allocation.
class ReleasedNeedle {
 public:
  // Its motion in a tick: of its tip by `by` (mm, LPS), of its axes by `turn` about the tip.
  struct Step {
    Vec3 by = Vec3::Zero();
    Mat3 turn = Mat3::Identity();
  };
  // One tick. `is_released`: no hand holds it, and it is in tissue; `needle`: its pose; `of_tissue`: the motion of
  // the tissue there, from rest.
  Step step(bool is_released, const Pose& needle, const Pose& of_tissue) noexcept {
    if (!is_released) {
      at_rest_.reset();
      return {};
    }
    if (!at_rest_) at_rest_ = of_tissue.inverse(Eigen::Isometry) * needle;
    const Pose goal = of_tissue * *at_rest_;
    // A quaternion between: errors of the needle's axes, which come back in the next tick, would double in each.
    const Eigen::Quaterniond turn(Mat3(goal.linear() * needle.linear().transpose()));
    return {goal.translation() - needle.translation(), turn.normalized().toRotationMatrix()};
  }

 private:
  std::optional<Pose> at_rest_;  // its pose in tissue at rest; empty: a hand holds it
};

}  // namespace bodkin::station
