#include "training/expert_set.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parameter_value.h"
#include "io/csv_rows.h"
#include "io/resources.h"
#include "training/metric.h"

namespace bodkin::training {

namespace {

constexpr std::size_t largest_expert_file = 64 << 20;  // bytes
constexpr std::size_t fewest = 5;                      // experts, for a comparison

// Linear between the sorted values (Hyndman and Fan 1996, type 7).
double quantile_of(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

ExpertSet ExpertSet::parse(std::string_view text, const std::string& origin) {
  const std::vector<io::CsvRow> rows = io::read_csv_rows(text, origin, {.comments = true});
  if (rows.size() < 2) {
    throw InputError(fmt::format("{}: there are {} rows, expected the names of metrics and at least one attempt",
                                 origin, rows.size()));
  }
  ExpertSet set;
  set.origin_ = origin;
  set.attempts_ = rows.size() - 1;
  const std::vector<std::string>& names = rows.front().fields;
  for (std::size_t column = 0; column < names.size(); ++column) {
    if (find_metric(names[column]) == nullptr) continue;
    Column values{.metric = names[column], .values = {}};
    for (std::size_t row = 1; row < rows.size(); ++row) {
      if (rows[row].fields.size() != names.size()) {
        throw InputError(fmt::format("{}, line {}: there are {} fields, expected {} as in the first line", origin,
                                     rows[row].line, rows[row].fields.size(), names.size()));
      }
      const std::string& field = rows[row].fields[column];
      if (field.empty()) continue;
      double value = 0.0;
      if (!parse_number(field, value)) {
        throw InputError(fmt::format("{}, line {}: {} is '{}', expected a number or nothing", origin, rows[row].line,
                                     names[column], field.substr(0, 40)));
      }
      values.values.push_back(value);
    }
    std::sort(values.values.begin(), values.values.end());
    set.columns_.push_back(std::move(values));
  }
  if (set.columns_.empty())
    throw InputError(fmt::format("{}: no column is a metric, expected names such as path_length_mm", origin));
  return set;
}

ExpertSet ExpertSet::read(const std::filesystem::path& file) {
  return parse(io::read_text_file(file, largest_expert_file), file.string());
}

std::optional<ExpertSet> ExpertSet::shipped(const std::string& procedure) {
  const std::filesystem::path file =
      io::shared_file("procedure.xsd").parent_path() / "experts" / (procedure + ".csv");
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  return read(file);
}

std::optional<ExpertSet::Place> ExpertSet::place(std::string_view metric, double value) const {
  const auto column =
      std::find_if(columns_.begin(), columns_.end(), [&](const Column& each) { return each.metric == metric; });
  if (column == columns_.end() || column->values.size() < fewest) return std::nullopt;
  const std::vector<double>& values = column->values;
  const auto count = static_cast<double>(values.size());
  const auto smaller = static_cast<double>(std::lower_bound(values.begin(), values.end(), value) - values.begin());
  const auto at_most = static_cast<double>(std::upper_bound(values.begin(), values.end(), value) - values.begin());
  double mean = 0.0, squares = 0.0;
  for (const double each : values) mean += each / count;
  for (const double each : values) squares += (each - mean) * (each - mean);
  const double deviation = std::sqrt(squares / (count - 1.0));
  Place found;
  found.percentile = 100.0 * (smaller + 0.5 * (at_most - smaller)) / count;
  found.z = deviation > 0.0 ? (value - mean) / deviation : 0.0;
  found.low = quantile_of(values, 0.05);
  found.high = quantile_of(values, 0.95);
  return found;
}

}  // namespace bodkin::training
