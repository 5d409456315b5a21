#include "training/store/results_csv.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/parameter_value.h"
#include "training/metric.h"

namespace bodkin::training {

namespace {

// In quotes if necessary. A text that a spreadsheet would take for a formula gets an apostrophe before it.
std::string field_of(const std::string& text) {
  std::string safe = text;
  if (!safe.empty() && std::string_view("=+-@").find(safe.front()) != std::string_view::npos) safe.insert(0, 1, '\'');
  if (safe.find_first_of(",\"\r\n") == std::string::npos) return safe;
  std::string quoted = "\"";
  for (const char each : safe) {
    if (each == '"') quoted += '"';
    quoted += each;
  }
  return quoted + '"';
}

}  // namespace

std::string results_csv(const std::vector<AttemptRecord>& attempts) {
  std::string table =
      "trainee,procedure,plan,stage,started_at,station,patient,duration_s,verdict,reached,score,session";
  for (const Metric& metric : all_metrics()) table += fmt::format(",{}", metric.name);
  table += "\r\n";
  for (const AttemptRecord& each : attempts) {
    table += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}", field_of(each.trainee), field_of(each.procedure),
                         field_of(each.plan), each.stage > 0 ? std::to_string(each.stage) : std::string(),
                         field_of(each.started_at), field_of(each.station), field_of(each.patient),
                         number_text(each.duration), name_of(each.verdict), each.reached ? 1 : 0,
                         number_text(each.score), each.digest);
    for (const Metric& metric : all_metrics()) {
      const auto found = std::find_if(each.metrics.begin(), each.metrics.end(),
                                      [&](const auto& value) { return value.first == metric.name; });
      table += ',';
      if (found != each.metrics.end()) table += number_text(found->second);
    }
    table += "\r\n";
  }
  return table;
}

}  // namespace bodkin::training
