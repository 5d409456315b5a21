#pragma once

#include <algorithm>
#include <cmath>

namespace bodkin::forces {

// The time for which a needle has been at rest. Rest is detected late, after the speed has been small for a while;
// the clock also counts the time before, so that effects that begin with the stop do not begin late. A depth without
// noise that does not change for one tick is a stop at once.
class StopClock {
 public:
  // `resolution`: mm, of the measured depth; 0 = without noise. `dt`: s.
  StopClock(double resolution, double dt)
      : band_(resolution + rounding), noiseless_(!(resolution > 0.0)), most_owed_(longest_owed / dt) {}

  // To be called every tick with the depth (mm) and whether rest has been detected. True while the needle rests.
  bool step(double depth, bool known) noexcept {
    still_ = std::abs(depth - anchor_) <= band_ ? still_ + 1.0 : 0.0;
    if (still_ == 0.0) anchor_ = depth;
    return known || (noiseless_ && still_ > 0.0);
  }
  // To be called at the beginning of a stop, after step().
  void start() noexcept { ticks_ = 0.0, owed_ = std::clamp(still_ - 1.0, 0.0, most_owed_); }
  // Restarts the stop, in the middle of one.
  void restart() noexcept { ticks_ = 0.0; }
  // Ticks of the stop, one more on each call; the time before detection is made up at double speed, without jumps.
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
