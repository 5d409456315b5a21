#pragma once

#include <cstdint>
#include <memory>

#include "core/single_producer_ring.h"
#include "fem/body_motion.h"

namespace bodkin::session {

// From a tick on the needle met a body that moves by itself (BodyThread) as this step had left it.
struct BodyTaken {
  std::uint64_t number = 0;  // of these, from 0 on, without a gap
  std::uint64_t tick = 0;
  std::uint64_t step = 0;
};

// What a recorder needs of a body that moves by itself: with it a replay makes the same steps, and the needle meets
// each of them in the same tick. Wait-free for those who write.
struct BodyLog {
  std::shared_ptr<fem::BodySteps> steps;      // pushed by the body's thread
  SingleProducerRing<BodyTaken> taken{4096};  // pushed by the thread of the ticks, each before its tick
};

}  // namespace bodkin::session
