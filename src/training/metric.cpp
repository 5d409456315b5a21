#include "training/metric.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "training/metric_groups.h"

namespace bodkin::training {

std::span<const Metric> all_metrics() {
  static const std::vector<Metric> all = [] {
    std::vector<Metric> list;
    for (const auto& group :
         {metrics_of_time(), metrics_of_target(), metrics_of_path(), metrics_of_tissue(), metrics_of_motion(),
          metrics_of_hands(), metrics_of_technique(), metrics_of_ultrasound(), metrics_of_guidance(),
          metrics_of_palpation(), metrics_of_fluid()})
      list.insert(list.end(), group.begin(), group.end());
    return list;
  }();
  return all;
}

const Metric* find_metric(std::string_view name) {
  const std::span<const Metric> all = all_metrics();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Metric& each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::string metric_text(const Metric& metric, double value) {
  if (metric.unit.empty()) return fmt::format("{:.4g}", value);
  const int decimals = metric.unit == "s" || metric.unit == "N"      ? 2
                       : metric.unit == "N mm" || metric.unit == "%" ? 0
                                                                     : 1;
  return fmt::format("{:.{}f} {}", value, metric.unit == "mm" && value < 0.1 && value > 0.0 ? 3 : decimals,
                     metric.unit);
}

std::string metrics_table() {
  std::string text = "| name | what | definition | source |\n|---|---|---|---|\n";
  for (const Metric& metric : all_metrics())
    text += fmt::format("| `{}` | {} | {} | {} |\n", metric.name, metric.title, metric.definition, metric.source);
  return text;
}

}  // namespace bodkin::training
