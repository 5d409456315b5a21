#pragma once

#include <atomic>
#include <cstdint>

#include "session/second_sample.h"

#include "anatomy/tissue.h"
#include "core/latest_value.h"
#include "core/single_producer_ring.h"

namespace bodkin::session {

// The needle's state, as a second hand needs it.
struct NeedleSnapshot {
  double time = -1.0;                               // s of the session; negative: no tick yet
  anatomy::TissueId tissue = anatomy::tissue::air;  // at the tip
};

// All data exchanged between the threads of the needle, the second hand and the recorder. Wait-free on both sides:
// neither hand waits for the other or for the disk.
struct SecondLink {
  LatestValue<NeedleSnapshot> needle;              // written by the needle's thread, read by the second hand's
  SingleProducerRing<SecondSample> samples{4096};  // pushed by the second hand's thread, popped by the recorder's
  std::atomic<double> thumb_force{0.0};            // N on a plunger, of the second hand's newest tick
  std::atomic<std::uint64_t> lost{0};              // samples dropped because the ring was full
};

}  // namespace bodkin::session
