#pragma once

#include <cstdint>

#include "simulation/haptic_tick.h"
#include "simulation/operator.h"

namespace bodkin::simulation {

// An operator's hand in the patient: the operator intends, the hand moves, the tick computes the force, and the hand
// feels it one tick later. A breathing patient is asked to hold the breath all the time. Equal cases, scripts, paths
// and seeds give equal bits. step() allocates nothing and locks nothing; the patient must outlive the loop.
class ClosedLoop {
 public:
  // Throws InputError for an invalid script, path or patient.
  ClosedLoop(const anatomy::Case& patient, const OperatorScript& script, const anatomy::NeedlePath& path,
             std::uint64_t seed);

  // One tick; its result is written to `record`.
  void step(TickRecord& record) noexcept;
  // Whether the operator has reached the end of the script.
  bool finished() const noexcept { return operator_.finished(); }
  // The operator's present phase, see Operator::phase.
  int phase() const noexcept { return operator_.phase(); }
  double dt() const noexcept { return tick_.dt(); }
  // Null for a patient without a deformable body.
  BodyPort* body() noexcept { return tick_.body(); }

 private:
  HapticTick tick_;
  Operator operator_;
  haptics::SimulatedHand hand_;
  bool breathes_ = false;
  std::uint64_t ticks_ = 0;
  Wrench felt_;  // on the hand, from the last tick
};

}  // namespace bodkin::simulation
