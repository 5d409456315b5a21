#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "haptics/guard_event.h"
#include "haptics/latency_histogram.h"

namespace bodkin::views {

// The actions and reasons of the guard, and the station's sentences, as lines for people, the newest first. The
// guard's actions are derived from every frame's state: a state that came and went between two frames is not included
// (the session's recording has it).
class GuardLog {
 public:
  struct Line {
    double time = 0.0;  // s of the session
    std::string words;
    bool bad = false;  // no force
    int times = 1;     // in a row
  };

  // `limits`: bit n for the reason n that limited the force, see HandGuard::limits().
  void note(double time, haptics::GuardState state, haptics::GuardReason fault, std::uint32_t limits);
  // A sentence that begins with a time, "0.1 s: armed", is placed at that time.
  void note(double time, const std::string& sentence);
  void clear();

  const std::deque<Line>& lines() const { return lines_; }

  static constexpr std::size_t most_lines = 50;

 private:
  void add(double time, std::string words, bool bad);

  std::deque<Line> lines_;
  haptics::GuardState state_ = haptics::GuardState::disarmed;
  std::uint32_t limits_ = 0;
};

// The fraction of all values (0 to 1) in each of `count` columns between `from` and `to` seconds on a logarithmic
// axis. Values outside are in the first or the last column. All 0 if the histogram is empty.
std::vector<double> histogram_columns(const haptics::LatencyHistogram& histogram, double from, double to,
                                      std::size_t count);

}  // namespace bodkin::views
