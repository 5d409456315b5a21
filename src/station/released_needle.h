#pragma once

#include <optional>

#include "core/geometry.h"

namespace bodkin::station {

// A needle in tissue that nobody holds, frozen or clutched: it sticks to the tissue, and goes where that goes.
// noexcept and without allocation.
class ReleasedNeedle {
 public:
  // One tick. `is_released`: nobody holds it, and it is in tissue; `tip`: where it is; `of_tissue`: mm, by which the
  // tissue at it has moved. Returns mm by which it is to go on.
  Vec3 step(bool is_released, const Vec3& tip, const Vec3& of_tissue) noexcept {
    if (!is_released) {
      at_rest_.reset();
      return Vec3::Zero();
    }
    if (!at_rest_) at_rest_ = tip - of_tissue;
    return *at_rest_ + of_tissue - tip;
  }

 private:
  std::optional<Vec3> at_rest_;  // of its tip, were the tissue at rest; empty: a hand holds it
};

}  // namespace bodkin::station
