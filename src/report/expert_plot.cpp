#include "report/expert_plot.h"

#include <algorithm>
#include <cmath>

#include "training/metric.h"

namespace bodkin::report {

namespace {

constexpr double row_high = 26.0, top_of_rows = 34.0, below_rows = 12.0;      // px
constexpr double whole_width = 1000.0, bar_from = 510.0, bar_to = 710.0;      // px
constexpr double scale_from = 405.0, scale_to = 815.0, titles_until = 310.0;  // px
constexpr double beside_scale = 12.0;                                         // px, room for an arrow
constexpr std::uint32_t words_ink = 0x26303A, remark_ink = 0x5B6670, band_ink = 0x9CC5E8, rail_ink = 0xE3E8EC,
                        within_ink = 0x1D7A4F, outside_ink = 0xB3261E;

}  // namespace

double ExpertRow::share() const {
  if (high > low) return (value - low) / (high - low);
  // All experts have the same value: one who shares it is in the middle.
  return value == low ? 0.5 : value < low ? -2.0 : 3.0;
}

std::vector<ExpertRow> expert_rows(const training::Score& score) {
  std::vector<ExpertRow> rows;
  for (const training::MetricResult& each : score.metrics) {
    if (!each.grade || !each.experts) continue;
    const auto text = [&](double value) { return training::metric_text(*each.metric, value); };
    rows.push_back({std::string(each.metric->title), each.value, each.experts->low, each.experts->high,
                    text(each.value), text(each.experts->low), text(each.experts->high)});
  }
  std::stable_partition(rows.begin(), rows.end(), [](const ExpertRow& row) { return !row.is_within(); });
  return rows;
}

imaging::Canvas draw_expert_band(const std::vector<ExpertRow>& rows) {
  using imaging::Path;
  using imaging::TextAnchor;
  imaging::Canvas canvas(whole_width, top_of_rows + row_high * static_cast<double>(rows.size()) + below_rows);
  canvas.fill_all(0xFFFFFF);
  canvas.text({0.5 * (bar_from + bar_to), 18.0}, "nine of ten experts",
              {.size = 12.0, .ink = remark_ink, .anchor = TextAnchor::middle});
  canvas.text({whole_width - 8.0, 18.0}, "this attempt",
              {.size = 12.0, .ink = remark_ink, .anchor = TextAnchor::end});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ExpertRow& row = rows[i];
    const double y = top_of_rows + row_high * (static_cast<double>(i) + 0.5);
    const std::uint32_t ink = row.is_within() ? within_ink : outside_ink;
    canvas.text({titles_until, y + 4.0}, row.title,
                {.size = row.title.size() > 44 ? 10.5 : 12.5, .ink = words_ink, .anchor = TextAnchor::end});
    canvas.stroke(Path::segment({scale_from, y}, {scale_to, y}), {rail_ink, 1.0});
    canvas.fill(Path::rectangle(bar_from, y - 6.0, bar_to - bar_from, 12.0), band_ink);
    canvas.text({scale_from - beside_scale, y + 4.0}, row.low_text,
                {.size = 11.0, .ink = remark_ink, .anchor = TextAnchor::end});
    canvas.text({scale_to + beside_scale, y + 4.0}, row.high_text, {.size = 11.0, .ink = remark_ink});
    const double wanted = bar_from + row.share() * (bar_to - bar_from);
    const double x = std::clamp(wanted, scale_from, scale_to);
    if (x == wanted) {
      canvas.fill(Path::circle({x, y}, 5.0), ink);
    } else {
      const double tip = wanted < x ? -7.0 : 7.0;
      canvas.fill(Path::polygon({{x + tip, y}, {x, y - 6.0}, {x, y + 6.0}}), ink);
    }
    canvas.text({whole_width - 8.0, y + 4.0}, row.value_text,
                {.size = 12.5, .ink = ink, .anchor = TextAnchor::end, .bold = true});
  }
  return canvas;
}

}  // namespace bodkin::report
