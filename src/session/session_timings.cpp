#include "session/session_timings.h"

#include <algorithm>
#include <cmath>

namespace bodkin::session {

namespace {

std::vector<TimeBin> bins_of(const haptics::LatencyHistogram& histogram) {
  std::vector<TimeBin> bins;
  for (std::size_t bin = 0; bin < haptics::LatencyHistogram::bins; ++bin) {
    if (histogram.count_in(bin) == 0) continue;
    // A reading that is not a number counts as the longest, and has no length.
    const double up_to = std::min(haptics::LatencyHistogram::upper_edge(bin), histogram.maximum());
    bins.push_back({bins.empty() ? up_to : std::max(up_to, bins.back().up_to), histogram.count_in(bin)});
  }
  return bins;
}

}  // namespace

SessionTimings timings_of(const haptics::ServoTimings& servo) {
  return {bins_of(servo.lateness), bins_of(servo.compute), servo.overruns};
}

std::uint64_t count_of(std::span<const TimeBin> bins) {
  std::uint64_t sum = 0;
  for (const TimeBin& bin : bins) sum += bin.count;
  return sum;
}

double percentile(std::span<const TimeBin> bins, double share) {
  const double wanted = std::clamp(share, 0.0, 1.0) * static_cast<double>(count_of(bins));
  const auto rank = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::ceil(wanted)));
  std::uint64_t seen = 0;
  for (const TimeBin& bin : bins) {
    seen += bin.count;
    if (seen >= rank) return bin.up_to;
  }
  return 0.0;
}

}  // namespace bodkin::session
