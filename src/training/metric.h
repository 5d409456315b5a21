#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "training/measured.h"

namespace bodkin::training {

// One number of an attempt, computed only from the session, so that old sessions have it too.
struct Metric {
  std::string_view name;        // with its unit, as files and rules write it: "path_length_mm"
  std::string_view unit;        // "mm"; empty: a count
  std::string_view title;       // as people read it: "length of the tip's path"
  std::string_view definition;  // how it is computed, a phrase
  std::string_view source;      // its users, or "Bodkin"
  // Empty if the session does not have it: no insertion, no loss of resistance, no probe.
  std::optional<double> (*compute)(const Measured& measured);
};

// All metrics, in the order of reports.
std::span<const Metric> all_metrics();

// nullptr for an unknown name.
const Metric* find_metric(std::string_view name);

// "6.2 mm", "3"; counts are whole numbers without decimals.
std::string metric_text(const Metric& metric, double value);

// The table of docs/metrics.md.
std::string metrics_table();

}  // namespace bodkin::training
