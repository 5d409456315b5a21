#pragma once

#include <algorithm>
#include <cmath>

namespace bodkin::forces {

// Since when a needle rests. That it rests is known late, once its speed has been small for a while; the clock counts
// the time before as well, so that what begins with the stop does not begin late. A depth without noise that stays
// the same for one tick is a stop at once.
class StopClock {
 public:
  // `resolution`: mm, of the measured depth; 0 = without noise. `dt`: s.
  StopClock(double resolution, double dt)
      : band_(resolution + rounding), noiseless_(!(resolution > 0.0)), most_owed_(longest_owed / dt) {}

  // Every tick, with the depth (mm) and whether the needle is known to rest. True while it rests.
  bool step(double depth, bool known) noexcept {
    still_ = std::abs(depth - anchor_) <= band_ ? still_ + 1.0 : 0.0;
    if (still_ == 0.0) anchor_ = depth;
    return known || (noiseless_ && still_ > 0.0);
  }
  // At the beginning of a stop, after step().
  void start() noexcept { ticks_ = 0.0, owed_ = std::clamp(still_ - 1.0, 0.0, most_owed_); }
  // Where a stop begins anew in the middle of one.
  void restart() noexcept { ticks_ = 0.0; }
  // Ticks of the stop, one more each time; the time before it was known is made up at double speed, without a jump.
  double advance() noexcept {
    ticks_ += owed_ >= 1.0 ? 2.0 : 1.0;
    owed_ = std::max(0.0, owed_ - 1.0);
    return ticks_;
  }

 private:
  static constexpr double rounding = 1e-9;     // mm
  static constexpr double longest_owed = 0.1;  // s

  double band_;
  bool noiseless_;
  double most_owed_;     // ticks
  double anchor_ = 0.0;  // mm, where the needle has stayed ...
  double still_ = 0.0;   // ticks, ... for so long
  double ticks_ = 0.0, owed_ = 0.0;
};

}  // namespace bodkin::forces
