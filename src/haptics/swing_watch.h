#pragma once

#include <array>

#include "core/geometry.h"

namespace bodkin::haptics {

// Detects a hand that is shaken, only from its motion: on every axis, 3 to 200 Hz, whatever the force and its energy
// account. It looks for three whole cycles in a row, of equal length and width, that do not decay and are wider than
// a hand's own oscillations:
//
//   19 Hz and above  in each of the three: twice the smallest swing that the encoder can tell from noise (no hand
//                    trembles that fast)
//   below 19 Hz      A = 2 a / (2 pi f)^2 from side to side, a = 20 m/s^2 (a choice: about four times that of a hand
//                    that trembles by 3 mm at 6 Hz or by 1 mm at 11 Hz): 2.8 mm at 19 Hz, 113 mm at 3 Hz
//
// Smaller swings below 19 Hz are left to OscillationWatch, which asks who does the work, and to lasts(): a swing,
// however small, with an unbroken sequence of equally long and equally wide cycles.
//
//   8.5 Hz and above  within 15 % (and two ticks) of the period and 30 % (and a count) of the width, for 1.2 s: a
//                     tremor changes its amplitude and period in that time, a self-driven loop does not
//   3 to 8.5 Hz       within 5 % and 10 %, for twelve cycles (4 s at 3 Hz, 1.4 s at 8.5 Hz): a hand that keeps time
//                     varies by 3 to 5 % from one interval to the next (Wing and Kristofferson, Perception &
//                     Psychophysics 14 (1973) 5-12) and by more in amplitude
//
// step() is noexcept and allocates nothing.
class SwingWatch {
 public:
  // `least`: mm from turning point to turning point; less is noise.
  explicit SwingWatch(double least) noexcept : least_(least) {}

  // `moved`: mm since the last tick, `dt` s ago. True in the tick of a turning point at which an oscillation is
  // detected.
  bool step(const Vec3& moved, double dt) noexcept;
  // Whether an equal swing has lasted: true in the tick in which it has, and again after every such period.
  bool lasts() const noexcept { return lasts_; }
  void reset() noexcept { *this = SwingWatch(least_); }

  // Of the last detected oscillation: Hz, mm from side to side, axis 0 to 2.
  double frequency() const noexcept { return frequency_; }
  double width() const noexcept { return width_; }
  int axis() const noexcept { return axis_; }

  // mm from side to side that a hand may swing on its own at `frequency` (Hz).
  double allowed(double frequency) const noexcept;

 private:
  struct Swing {
    double width = 0.0;  // mm
    double time = 0.0;   // s, from turning point to turning point
  };
  struct Axis {
    double place = 0.0, extreme = 0.0, turn = 0.0;  // mm
    double since_extreme = 0.0, since_turn = 0.0;   // s; the latter to the extreme
    double dwelt = 0.0;                             // s spent near the extreme
    bool forwards = true;
    int count = 0;                                                        // consecutive swings that were fast enough
    std::array<Swing, 6> last{};                                          // the newest first
    double widest = 0.0, narrowest = 0.0, longest = 0.0, shortest = 0.0;  // mm, s, of the equal cycles
    double lasting = 0.0;                                                 // s of equal cycles
    double half_cycles = 0.0;                                             // number of equal half cycles
  };

  bool step(Axis& axis, double moved, double dt) noexcept;
  bool is_shaken(const Axis& axis) noexcept;
  void watch_lasting(Axis& axis, double dt) noexcept;

  double least_;
  std::array<Axis, 3> axes_{};
  double frequency_ = 0.0, width_ = 0.0;
  int axis_ = 0;
  bool lasts_ = false;
};

}  // namespace bodkin::haptics
