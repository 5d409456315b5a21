#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/random.h"

namespace bodkin {

// A hand that goes to and fro about zero, no swing as wide or as long as the one before: widths vary by `spread` of
// themselves (standard deviation), lengths by half of that.
class UnevenSwing {
 public:
  // Hz, mm from the middle.
  UnevenSwing(double hertz, double wide, double spread, std::uint64_t seed)
      : random_(seed), hertz_(hertz), wide_(wide), spread_(spread) {
    turn();
  }

  // mm after another `dt` s.
  double step(double dt) {
    time_ += dt;
    if (time_ >= length_) {
      const double over = time_ - length_;
      turn();
      time_ = over;
    }
    return from_ + (to_ - from_) * 0.5 * (1.0 - std::cos(std::numbers::pi * time_ / length_));
  }

 private:
  void turn() {
    from_ = to_;
    up_ = !up_;
    to_ = (up_ ? 1.0 : -1.0) * wide_ * std::max(0.2, 1.0 + spread_ * random_.normal());
    length_ = 0.5 / hertz_ * std::max(0.5, 1.0 + 0.5 * spread_ * random_.normal());
    time_ = 0.0;
  }

  Random random_;
  double hertz_, wide_, spread_;
  double from_ = 0.0, to_ = 0.0, time_ = 0.0, length_ = 1.0;  // mm, s
  bool up_ = false;
};

}  // namespace bodkin
