#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/servo_records.h"

namespace bodkin::session {

// How many rounds took at most so long, and longer than the bin before.
struct TimeBin {
  double up_to = 0.0;  // s; of the last bin, the longest of all
  std::uint64_t count = 0;
};

// How well a session that ran on the clock kept its time; part of its recording.
struct SessionTimings {
  std::vector<TimeBin> lateness;  // by which rounds began late; ascending, without empty bins
  std::vector<TimeBin> compute;   // that they took
  std::uint64_t overruns = 0;     // rounds that began more than a period late, or took longer than one
};

SessionTimings timings_of(const haptics::ServoTimings& servo);

// Rounds that the bins hold.
std::uint64_t count_of(std::span<const TimeBin> bins);
// s within which `share` (0 to 1) of all lie; 0 when there are none.
double percentile(std::span<const TimeBin> bins, double share);

}  // namespace bodkin::session
