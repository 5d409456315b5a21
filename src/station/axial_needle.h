#pragma once

#include "core/geometry.h"

namespace bodkin::station {

// The needle of a device that renders no force, so that no tissue can hold it: once it is in tissue it moves along
// its own axis alone, about which it may turn; to redirect it, withdraw it. Above the skin it comes back to where the
// hand is at 50 mm/s and 0.5 rad/s, without a jump. step() is noexcept and allocates nothing.
class AxialNeedle {
 public:
  // `hand`: where the hand holds the needle (tip, third axis hub to tip); `in_tissue`: after the tick before; `dt`:
  // s. Returns where the needle is.
  Pose step(const Pose& hand, bool in_tissue, double dt) noexcept;

 private:
  bool seen_ = false;
  Pose needle_ = Pose::Identity();
  Pose last_hand_ = Pose::Identity();
};

}  // namespace bodkin::station
