#pragma once

#include "core/geometry.h"

namespace bodkin::station {

// The needle of a device that renders no force, so that no tissue can hold it: in tissue it moves only along its own
// axis, about which it may turn; to redirect it, withdraw it. Above the skin it returns to the hand at 50 mm/s and
// 0.5 rad/s, without a jump. step() is noexcept and allocates nothing.
class AxialNeedle {
 public:
  // `hand`: pose of the needle in the hand (tip, third axis hub to tip); `in_tissue`: after the previous tick; `dt`:
  // s. Returns the pose of the needle.
  Pose step(const Pose& hand, bool in_tissue, double dt) noexcept;

 private:
  bool seen_ = false;
  Pose needle_ = Pose::Identity();
  Pose last_hand_ = Pose::Identity();
};

}  // namespace bodkin::station
