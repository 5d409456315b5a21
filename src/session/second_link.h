#pragma once

#include <atomic>
#include <cstdint>

#include "session/second_sample.h"

#include "anatomy/tissue.h"
#include "core/latest_value.h"
#include "core/single_producer_ring.h"

namespace bodkin::session {

// What a second hand needs to know of the needle.
struct NeedleSnapshot {
  double time = -1.0;                               // s of the session; negative: the needle has had no tick yet
  anatomy::TissueId tissue = anatomy::tissue::air;  // at the tip
};

// Everything that crosses between the needle's thread, the second hand's and the recorder's. Wait-free on both sides
// of each: no hand waits for the other, and neither for the disk.
struct SecondLink {
  LatestValue<NeedleSnapshot> needle;              // written by the needle's thread, read by the second hand's
  SingleProducerRing<SecondSample> samples{4096};  // pushed by the second hand's thread, popped by the recorder's
  std::atomic<double> thumb_force{0.0};            // N on a plunger, of the second hand's newest tick
  std::atomic<std::uint64_t> lost{0};              // samples that found the ring full
};

}  // namespace bodkin::session
