#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bodkin::tracking {

// Durations of the stages of processing an image. Not thread-safe.
class StageTimes {
 public:
  struct Row {
    std::string stage;
    std::size_t count = 0;
    double median = 0.0, late = 0.0;  // ms; `late`: 95th percentile
  };

  void add(std::string_view stage, double seconds);
  // In the order of the stages' first occurrence.
  std::vector<Row> rows() const;

 private:
  std::vector<std::pair<std::string, std::vector<double>>> stages_;  // s
};

}  // namespace bodkin::tracking
