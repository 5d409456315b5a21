#include "simulation/closed_loop.h"

#include "simulation/operator_thresholds.h"

namespace bodkin::simulation {

ClosedLoop::ClosedLoop(const anatomy::Case& patient, const OperatorScript& script, const anatomy::NeedlePath& path,
                       std::uint64_t seed)
    : tick_(patient),
      operator_(for_patient(script, patient), path, seed, tick_.dt()),
      hand_(script.hand, tick_.dt(), mix64(seed ^ 0xD7)) {
  breathes_ = patient.description.breathing.has_value();
  hand_.start(operator_.start());
}

void ClosedLoop::step(TickRecord& record) noexcept {
  const Pose intended = operator_.step({hand_.needle(), felt_.force});
  record.tick = ticks_++;
  record.input.needle = hand_.step(intended, felt_);
  record.input.other = operator_.other_hand();
  record.input.other.breath_held = breathes_;
  record.output = tick_.step(record.input);
  felt_ = record.output.applied;
}

}  // namespace bodkin::simulation
