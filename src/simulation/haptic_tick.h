#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "anatomy/case.h"
#include "fem/node_forces.h"
#include "simulation/tick_record.h"

namespace bodkin {

// The one function that a servo calls a thousand times a second: needle in tissue to force on the hand, through the
// governor. Deterministic: the same case and the same inputs give the same bits. step() allocates nothing, locks
// nothing, throws nothing and reads no clock; the case must outlive the object.
class HapticTick {
 public:
  // Throws InputError when the case's parameters make a model impossible or the case has no tissues.
  explicit HapticTick(const Case& patient);
  ~HapticTick();
  HapticTick(HapticTick&&) noexcept;
  HapticTick& operator=(HapticTick&&) noexcept;

  TickOutput step(const TickInput& input) noexcept;
  // Another corridor of a deformable body, for the next time that the needle touches the body. Beside step(), but not
  // for two threads at once. False: there are `most_corridors`, or the resistance needs none.
  static constexpr std::size_t most_corridors = 8;
  bool add_corridor(const PreparedCorridor& corridor);
  // The corridor that the patient came with, about another state of the body (PreparedCorridor::state): of
  // `embedded_needle` alone, for the next time that the needle touches the body. From the thread that adds corridors.
  // False: the resistance has none that can change. Throws InputError.
  bool refresh_corridor(const PreparedCorridor& corridor);
  // From the thread of step(): the next time that the needle touches the body it finds it at rest, whatever was or
  // will be refreshed.
  void stay_at_rest() noexcept;
  // What the needle did to a deformable body in the last step, by node of its mesh; nothing for other resistances.
  NodeForces node_forces() const noexcept;
  // mm by which the hand's needle was ahead of the one in that body, where the body is stiffer than the device
  // renders or bone is in the way: what is drawn is the needle less this.
  Vec3 needle_ahead() const noexcept;

  // Names of TickOutput::diagnostics; they live as long as this.
  std::span<const DiagnosticName> diagnostic_names() const noexcept;

  // s; 1 / rate of the case.
  double dt() const noexcept;
  // The smallest factor by which a tissue's stiffness had to be reduced for the device; 1 = none.
  double stiffness_scale() const noexcept;
  // Back to the state after construction: needle outside, nothing punctured, governor armed.
  void reset() noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodkin
