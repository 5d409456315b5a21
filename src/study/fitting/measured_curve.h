#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bodkin::study {

// The measurements of a testing machine or an instrumented needle, sample by sample.
struct MeasuredCurve {
  std::string name;           // of the file, for messages and titles
  std::vector<double> time;   // s, increasing; empty: not measured
  std::vector<double> depth;  // mm, positive inwards
  std::vector<double> force;  // N, positive pushes the needle out
  std::string assumed;        // assumptions, a sentence; empty: none

  std::size_t size() const noexcept { return depth.size(); }
};

// Reads a table with the columns time_s (may be missing), depth_mm and force_N, in any order, under a header;
// separated by commas, semicolons or tabs; lines that begin with # are comments. At least 10 rows. Throws InputError
// naming line, column, what was found and what was expected; also for values implausible in these units: a range of
// depth below 0.2 mm or above 500 mm, forces above 100 N or below 1 mN, more than 600 s, negative forces during
// insertion. A table with times and without depth is taken as one uniform insertion from 0 mm at its first sample at
// `speed` (mm/s), as `assumed` says; without a speed it is rejected.
MeasuredCurve read_measured_curve(const std::filesystem::path& file, std::optional<double> speed = {});

// As above, from text in memory; `origin` names it in messages.
MeasuredCurve parse_measured_curve(std::string_view text, const std::string& origin,
                                   std::optional<double> speed = {});

// The time of every sample, s: as measured, or the distance divided by `speed` (mm/s). Throws InputError when the
// curve has neither.
std::vector<double> sample_times(const MeasuredCurve& curve, std::optional<double> speed);

// Samples of several curves one after the other, without times; the name holds all names.
MeasuredCurve joined(std::span<const MeasuredCurve> curves);

}  // namespace bodkin::study
