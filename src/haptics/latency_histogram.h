#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace bodkin::haptics {

// Histogram of durations: fixed bins from 1 ns to 100 ms, sixteen per octave, so that a percentile is at most 1/16
// too high at any scale, and one bin for longer durations. record() is noexcept, allocates nothing and takes a few
// nanoseconds; the object is plain data and can be copied to another thread as a whole.
class LatencyHistogram {
 public:
  // `seconds`: less than 1 ns counts as 0, NaN as longer than everything.
  void record(double seconds) noexcept;
  void reset() noexcept { *this = LatencyHistogram(); }

  std::uint64_t count() const noexcept { return count_; }
  // s, the longest that was recorded, exactly; 0 when it is empty.
  double maximum() const noexcept { return maximum_; }
  // s; 0 when it is empty.
  double mean() const noexcept { return count_ == 0 ? 0.0 : sum_ / static_cast<double>(count_); }
  // s within which `share` (0 to 1) of all lie: the upper edge of the bin of the last of them, but never more than
  // the maximum. 0 when it is empty.
  double percentile(double share) const noexcept;
  // Number of durations beyond the last bin, 100 ms.
  std::uint64_t beyond() const noexcept { return bins_[last_bin]; }

  // Number of bins, including the one beyond 100 ms.
  static constexpr std::size_t bins = 377;
  std::uint64_t count_in(std::size_t bin) const noexcept { return bins_[bin]; }
  // s, upper edge of a bin; infinity for the last.
  static double upper_edge(std::size_t bin) noexcept;

 private:
  static constexpr std::size_t per_octave = 16;
  static constexpr std::size_t last_bin = bins - 1;  // above 100 ms

  static std::size_t bin_of(std::uint64_t nanoseconds) noexcept;
  static std::uint64_t end_of(std::size_t bin) noexcept;

  std::array<std::uint64_t, bins> bins_{};
  std::uint64_t count_ = 0;
  double sum_ = 0.0;      // s
  double maximum_ = 0.0;  // s
};

}  // namespace bodkin::haptics
