#pragma once

#include <cstdint>
#include <optional>

#include "anatomy/breathing.h"
#include "simulation/tick_record.h"

namespace bodkin::session {

// The position of a recorded needle in the tissue of a patient who may breathe: computed only from the ticks, as
// HapticTick does.
class MaterialTip {
 public:
  // `dt`: s.
  MaterialTip(const std::optional<anatomy::Breathing>& breathing, double dt);

  // LPS mm, position after expiration of the tissue at the tip. Ticks in ascending order; a missing tick is treated
  // like the one after it. The tip itself without breathing.
  Vec3 place_of(const simulation::TickRecord& record);
  // Depth of inspiration, 0 to 1, as of the last place_of().
  double drawn_in() const { return clock_ ? clock_->drawn_in() : 0.0; }

 private:
  std::optional<anatomy::BreathClock> clock_;
  std::optional<anatomy::BreathField> field_;
  std::uint64_t next_ = 0;  // tick
};

}  // namespace bodkin::session
