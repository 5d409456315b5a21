#include "haptics/latency_histogram.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace bodkin::haptics {

namespace {
constexpr double longest = 0.1;  // s
constexpr int linear_bits = 4;   // below 2^4 ns every nanosecond has its bin
}  // namespace

// The position of the highest bit and the four bits below it: sixteen equal steps to an octave.
std::size_t LatencyHistogram::bin_of(std::uint64_t nanoseconds) noexcept {
  if (nanoseconds < per_octave) return nanoseconds;
  const int shift = std::bit_width(nanoseconds) - 1 - linear_bits;
  const std::size_t step = (nanoseconds >> shift) - per_octave;
  return std::min(per_octave * (static_cast<std::size_t>(shift) + 1) + step, last_bin - 1);
}

std::uint64_t LatencyHistogram::end_of(std::size_t bin) noexcept {
  if (bin < per_octave) return bin;
  const std::size_t shift = bin / per_octave - 1;
  return ((per_octave + bin % per_octave + 1) << shift) - 1;
}

double LatencyHistogram::upper_edge(std::size_t bin) noexcept {
  return bin < last_bin ? static_cast<double>(end_of(bin)) * 1e-9 : std::numeric_limits<double>::infinity();
}

void LatencyHistogram::record(double seconds) noexcept {
  ++count_;
  if (!(seconds <= longest)) {
    ++bins_[last_bin];
    if (!std::isfinite(seconds)) return;
  } else {
    ++bins_[bin_of(static_cast<std::uint64_t>(std::max(seconds, 0.0) * 1e9 + 0.5))];
  }
  seconds = std::max(seconds, 0.0);
  sum_ += seconds;
  maximum_ = std::max(maximum_, seconds);
}

double LatencyHistogram::percentile(double share) const noexcept {
  const double wanted = std::clamp(share, 0.0, 1.0) * static_cast<double>(count_);
  const auto rank = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::ceil(wanted)));
  std::uint64_t seen = 0;
  for (std::size_t bin = 0; bin < last_bin; ++bin) {
    seen += bins_[bin];
    if (seen >= rank) return std::min(maximum_, static_cast<double>(end_of(bin)) * 1e-9);
  }
  return maximum_;
}

}  // namespace bodkin::haptics
