#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/servo_records.h"

namespace bodkin::session {

// The number of rounds with a duration up to this bin's and above the previous bin's.
struct TimeBin {
  double up_to = 0.0;  // s; of the last bin, the longest of all
  std::uint64_t count = 0;
};

// Timing statistics of a real-time session; part of its recording.
struct SessionTimings {
  std::vector<TimeBin> lateness;  // of the rounds' beginnings; ascending, without empty bins
  std::vector<TimeBin> compute;   // of the rounds
  std::uint64_t overruns = 0;     // rounds that began more than a period late, or took longer than one
};

SessionTimings timings_of(const haptics::ServoTimings& servo);

// Number of rounds in the bins.
std::uint64_t count_of(std::span<const TimeBin> bins);
// s within which `share` (0 to 1) of all lie; 0 when there are none.
double percentile(std::span<const TimeBin> bins, double share);

}  // namespace bodkin::session
