#pragma once

#include <array>

#include "core/geometry.h"

namespace bodkin::haptics {

// Sees a hand that is shaken, from its motion alone: on every axis, 3 to 200 Hz, whatever the force and its energy
// account say. It looks for three whole cycles in a row, as long and as wide as each other, that do not die away and
// are wider than a hand of its own makes them:
//
//   from 19 Hz on in each of the three: twice the smallest swing that the encoder can tell from noise (no hand
//   trembles that fast); below: A = 2 a / (2 pi f)^2 from side to side, a = 20 m/s^2 (a choice: about four times what
//   a hand that trembles by 3 mm at 6 Hz or by 1 mm at 11 Hz needs), which is 2.8 mm at 19 Hz, 10 mm at 10 Hz and 113
//   mm at 3 Hz.
//
// What swings less below 19 Hz is for OscillationWatch, which asks who does the work, and for lasts(): a swing,
// however small, all of whose cycles are equally long and equally wide without a break.
//
//   from 8.5 Hz on: within 15 % (and two ticks) of the period and 30 % (and a count) of the width, for 1.2 s; a
//   tremor waxes and wanes and changes its pace meanwhile, a loop that drives itself does not; from 3 to 8.5 Hz:
//   within 5 % and 10 %, for twelve cycles (4 s at 3 Hz, 1.4 s at 8.5 Hz). A hand that means to keep a rhythm varies
//   by 3 to 5 % from one interval to the next (Wing and Kristofferson, Perception & Psychophysics 14 (1973) 5-12) and
//   by more in how far it goes, so that twelve such cycles are not its own.
//
// step() is noexcept and allocates nothing.
class SwingWatch {
 public:
  // `least`: mm from turning point to turning point; less is noise.
  explicit SwingWatch(double least) noexcept : least_(least) {}

  // `moved`: mm since the last tick, `dt` s ago. True in the tick of a turning point with which the shaking is found.
  bool step(const Vec3& moved, double dt) noexcept;
  // Whether an equal swing has lasted: true in the tick in which it has, and again after every such time.
  bool lasts() const noexcept { return lasts_; }
  void reset() noexcept { *this = SwingWatch(least_); }

  // Of the shaking that was found last: Hz, mm from side to side, 0 to 2.
  double frequency() const noexcept { return frequency_; }
  double width() const noexcept { return width_; }
  int axis() const noexcept { return axis_; }

  // mm from side to side that a hand may swing by itself at `frequency` (Hz).
  double allowed(double frequency) const noexcept;

 private:
  struct Swing {
    double width = 0.0;  // mm
    double time = 0.0;   // s, from turning point to turning point
  };
  struct Axis {
    double place = 0.0, extreme = 0.0, turn = 0.0;  // mm
    double since_extreme = 0.0, since_turn = 0.0;   // s; the latter to the extreme
    double dwelt = 0.0;                             // s that it stayed near the extreme
    bool forwards = true;
    int count = 0;                                                        // swings in a row that were fast enough
    std::array<Swing, 6> last{};                                          // the newest first
    double widest = 0.0, narrowest = 0.0, longest = 0.0, shortest = 0.0;  // mm, s, of the equal cycles
    double lasting = 0.0;                                                 // s of them
    double half_cycles = 0.0;                                             // of them
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
