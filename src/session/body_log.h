#pragma once

#include <cstdint>
#include <memory>

#include "core/single_producer_ring.h"
#include "fem/body_motion.h"

namespace bodkin::session {

// From this tick on the needle met the motion of the body (BodyThread) after this step.
struct AppliedBodyStep {
  std::uint64_t number = 0;  // consecutive number, from 0
  std::uint64_t tick = 0;
  std::uint64_t step = 0;
};

// A recorder's input from a body with motion of its own: from it a replay makes the same steps, and the needle meets
// each of them in the same tick. Wait-free for the writers.
struct BodyLog {
  std::shared_ptr<fem::BodySteps> steps;                    // pushed by the body's thread
  SingleProducerRing<AppliedBodyStep> applied_steps{4096};  // pushed by the tick's thread, each before its tick
};

}  // namespace bodkin::session
