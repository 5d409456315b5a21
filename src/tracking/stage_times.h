#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bodkin::tracking {

// How long the stages of a picture's way take. Not for several threads at once.
class StageTimes {
 public:
  struct Row {
    std::string stage;
    std::size_t count = 0;
    double median = 0.0, late = 0.0;  // ms; `late`: 95 % took no longer
  };

  void add(std::string_view stage, double seconds);
  // In the order in which the stages came first.
  std::vector<Row> rows() const;

 private:
  std::vector<std::pair<std::string, std::vector<double>>> stages_;  // s
};

}  // namespace bodkin::tracking
