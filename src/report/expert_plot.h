#pragma once

#include <string>
#include <vector>

#include "imaging/canvas.h"
#include "training/score.h"

namespace bodkin::report {

// An attempt relative to the experts: a row for each measure, the bar being the middle nine tenths of the experts
// (from 5 % to 95 %) and the dot the attempt. Each row has its own scale, so that all bars are equally long; a dot
// more than a bar's length outside it is drawn at the edge, as an arrow.
struct ExpertRow {
  std::string title;
  double value = 0.0, low = 0.0, high = 0.0;
  std::string value_text, low_text, high_text;

  // Position of the dot: 0 at the bar's low end, 1 at its high end.
  double share() const;
  bool is_within() const { return value >= low && value <= high; }
};

// The measures with a rule of the procedure and values of experts; those outside the band first.
std::vector<ExpertRow> expert_rows(const training::Score& score);

// At least one row.
imaging::Canvas draw_expert_band(const std::vector<ExpertRow>& rows);

}  // namespace bodkin::report
