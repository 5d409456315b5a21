#pragma once

#include <cstdint>
#include <optional>

#include "anatomy/breathing.h"
#include "simulation/tick_record.h"

namespace bodkin::session {

// Where the needle of a recording is in the tissue of a patient who may breathe: from the ticks alone, as HapticTick
// had it.
class MaterialTip {
 public:
  // `dt`: s.
  MaterialTip(const std::optional<anatomy::Breathing>& breathing, double dt);

  // LPS mm, where the tissue at the tip lies while the patient has breathed out. Ticks in rising order; those that
  // are missing count as the one after them. The tip itself where nobody breathes.
  Vec3 place_of(const simulation::TickRecord& record);
  // How far breath is drawn in, 0 to 1, as of the last place_of().
  double drawn_in() const { return clock_ ? clock_->drawn_in() : 0.0; }

 private:
  std::optional<anatomy::BreathClock> clock_;
  std::optional<anatomy::BreathField> field_;
  std::uint64_t next_ = 0;  // tick
};

}  // namespace bodkin::session
