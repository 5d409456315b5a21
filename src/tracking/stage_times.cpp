#include "tracking/stage_times.h"

#include <algorithm>

namespace bodkin::tracking {

namespace {

constexpr double late_share = 0.95;

// ms
double value_at(std::vector<double> seconds, double share) {
  const auto place = seconds.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(seconds.size() - 1));
  std::nth_element(seconds.begin(), place, seconds.end());
  return 1000.0 * *place;
}

}  // namespace

void StageTimes::add(std::string_view stage, double seconds) {
  const auto found =
      std::find_if(stages_.begin(), stages_.end(), [&](const auto& one) { return one.first == stage; });
  if (found != stages_.end()) {
    found->second.push_back(seconds);
  } else {
    stages_.push_back({std::string(stage), {seconds}});
  }
}

std::vector<StageTimes::Row> StageTimes::rows() const {
  std::vector<Row> rows;
  for (const auto& [stage, seconds] : stages_) {
    rows.push_back({stage, seconds.size(), value_at(seconds, 0.5), value_at(seconds, late_share)});
  }
  return rows;
}

}  // namespace bodkin::tracking
