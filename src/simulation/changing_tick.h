#pragma once

#include "simulation/haptic_tick.h"

namespace bodkin::simulation {

// A haptic tick whose numbers change while it runs: another tick of the same patient takes over, which has gone
// through the same inputs with its own numbers. So what is felt afterwards is what would have been felt if the
// insertion had been done with them, whichever model it is. For `blend_time` the forces go over from the one to the
// other in equal steps; everything else is that of the new one at once. Deterministic, as the ticks are; step()
// allocates, locks and throws nothing.
class ChangingTick {
 public:
  static constexpr double blend_time = 0.1;  // s

  // `first` must outlive the object, or the settling of another.
  explicit ChangingTick(HapticTick& first) noexcept;

  // `next` acts from the next step on and must live until another has settled. While one is settling none can be
  // taken: false, and nothing has changed.
  bool take(HapticTick& next) noexcept;
  bool is_settling() const noexcept { return before_ != nullptr; }

  TickOutput step(const TickInput& input) noexcept;

 private:
  HapticTick* now_;
  HapticTick* before_ = nullptr;  // whose force fades
  int steps_ = 0, step_ = 0;      // of the settling
};

}  // namespace bodkin::simulation
