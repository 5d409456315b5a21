#pragma once

#include "simulation/haptic_tick.h"

namespace bodkin::simulation {

// A haptic tick whose numbers change while it runs: another tick of the same patient takes over, which has processed
// the same inputs with its own numbers. So the force afterwards is the one of an insertion performed with these
// numbers from the beginning, for any model. For `blend_time` the forces change from one to the other in equal steps;
// everything else switches at once. Deterministic, like the ticks; step() does not allocate, lock or throw.
class ChangingTick {
 public:
  static constexpr double blend_time = 0.1;  // s

  // `first` must outlive the object, or the takeover by another tick.
  explicit ChangingTick(HapticTick& first) noexcept;

  // `next` acts from the next step on and must live until another has taken over completely. During a takeover none
  // can begin: false, without effect.
  bool switch_to(HapticTick& next) noexcept;
  bool is_settling() const noexcept { return before_ != nullptr; }

  TickOutput step(const TickInput& input) noexcept;

 private:
  HapticTick* now_;
  HapticTick* before_ = nullptr;  // the tick whose force fades out
  int steps_ = 0, step_ = 0;      // of the takeover
};

}  // namespace bodkin::simulation
