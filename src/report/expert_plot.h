#pragma once

#include <string>
#include <vector>

#include "imaging/canvas.h"
#include "training/score.h"

namespace bodkin::report {

// An attempt within the band of experts: a row for each measure, the bar being the middle nine tenths of the experts
// (from 5 % to 95 %) and the dot the attempt. Each row has a scale of its own, on which the bar is as long as the
// others; a dot that lies more than a bar's length outside it is drawn at the edge, as an arrow.
struct ExpertRow {
  std::string title;
  double value = 0.0, low = 0.0, high = 0.0;
  std::string value_text, low_text, high_text;

  // Where the dot stands: 0 at the bar's low end, 1 at its high end.
  double share() const;
  bool is_within() const { return value >= low && value <= high; }
};

// The measures that the procedure has a rule about and experts have; those outside the band first.
std::vector<ExpertRow> expert_rows(const training::Score& score);

// At least one row.
imaging::Canvas draw_expert_band(const std::vector<ExpertRow>& rows);

}  // namespace bodkin::report
