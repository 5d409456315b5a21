#pragma once

#include <array>
#include <cstddef>

#include "core/axial_motion.h"
#include "core/one_pole.h"

namespace bodkin {

// Velocity, direction and rest of a needle, from its depth only, sample by sample.
//
// One count of a position sensor in one tick of 1 ms is 20 to 60 mm/s, so a plain difference is useless. The velocity
// is the slope between the newest sample and the oldest one of the longest window (at most 20 ms) whose samples all
// lie within one count of that line (Janabi-Sharifi, Hayward and Chen 2000, end-fit), then a one-pole low pass of 50
// Hz. The direction flips only at speeds above v_eps: 0.5 mm/s for a noiseless input, 3 mm/s for a real device, whose
// one count in 20 ms is up to 2.75 mm/s. Rest begins after 20 ms below v_eps and ends above 1.5 v_eps.
class MotionEstimator {
 public:
  // `dt`: s, 0.00025 to 0.005. `resolution`: mm of one count of the device; 0 = noiseless.
  MotionEstimator(double dt, double resolution);

  // Adds the depth (mm) of this tick.
  AxialMotion step(double depth) noexcept;
  // Moves the origin of depth so that the newest sample becomes `depth`; velocity and direction are unaffected.
  void rebase(double depth) noexcept;
  void reset() noexcept;

  double threshold() const noexcept { return threshold_; }
  // Depth of the newest sample; 0 before the first one.
  double depth() const noexcept { return samples_[newest_]; }

 private:
  static constexpr std::size_t capacity = 128;  // a power of two above 20 ms at 4 kHz

  double slope() const noexcept;

  double tolerance_, threshold_;
  int window_;  // samples, the longest window
  int dwell_;   // ticks below the threshold after which the needle rests
  OnePole filter_;
  std::array<double, capacity> per_sample_{};  // capacity: 1 / (n dt)
  std::array<double, capacity> samples_{};     // capacity, a ring
  std::size_t newest_ = 0;
  bool begun_ = false;
  int slow_ticks_ = 0;
  int direction_ = 0;
  bool resting_ = true;
};

}  // namespace bodkin
