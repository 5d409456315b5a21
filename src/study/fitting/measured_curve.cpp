#include "study/fitting/measured_curve.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "core/error.h"
#include "io/csv_rows.h"
#include "io/resources.h"
#include "io/xml_document.h"

namespace bodkin::study {

namespace {

constexpr std::size_t curve_limit = 32 << 20;  // bytes
constexpr std::size_t fewest_samples = 10;
constexpr std::size_t most_samples = 500000;
constexpr double least_travel = 0.2, greatest_travel = 500.0;  // mm between the least and the greatest depth
constexpr double least_force = 1e-3, greatest_force = 100.0;   // N, of the largest force
constexpr double longest_time = 600.0;                         // s
constexpr double fastest_needle = 2000.0;                      // mm/s
constexpr double pulled_share = -0.5;                          // mean over largest force during insertion
constexpr const char* expected_header = "time_s,depth_mm,force_N";

struct Column {
  const char* name;
  const char* quantity;
};
constexpr std::array<Column, 3> columns = {{{"time_s", "time"}, {"depth_mm", "depth"}, {"force_N", "force"}}};

// The separator of the first non-comment line: the one of the three that occurs in it.
char separator_of(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, end);
    if (!line.empty() && line.front() != '#') {
      for (const char separator : {';', '\t'}) {
        if (line.find(separator) != std::string_view::npos) return separator;
      }
      return ',';
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return ',';
}

// For each column of the table its index in `columns`.
std::vector<std::size_t> columns_of(const io::CsvRow& header, const std::string& origin,
                                    std::optional<double> speed) {
  std::vector<std::size_t> order;
  for (const std::string& field : header.fields) {
    const auto same = std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return field == c.name; });
    if (same == columns.end()) {
      for (const Column& column : columns) {
        if (!field.starts_with(column.quantity)) continue;
        io::fail_at(
            origin, header.line,
            fmt::format("the column {} is not in the unit that is expected, {}; convert its values and rename it",
                        io::in_quotes(field), column.name));
      }
      io::fail_at(origin, header.line,
                  fmt::format("there is a column {}, expected the header {} (time_s may be missing)",
                              io::in_quotes(field), expected_header));
    }
    const auto place = static_cast<std::size_t>(same - columns.begin());
    if (std::find(order.begin(), order.end(), place) != order.end())
      io::fail_at(origin, header.line, fmt::format("the column {} appears twice", field));
    order.push_back(place);
  }
  const auto has = [&](std::size_t place) { return std::find(order.begin(), order.end(), place) != order.end(); };
  if (has(0) && !has(1) && has(2)) {
    if (speed) return order;
    io::fail_at(
        origin, header.line,
        "there is no column depth_mm, so that the forces belong to no place; give the depth of every sample, or "
        "--speed, the needle's mm/s, for one insertion at this speed that begins at the skin");
  }
  for (const std::size_t needed : {std::size_t{1}, std::size_t{2}}) {
    if (!has(needed))
      io::fail_at(origin, header.line,
                  fmt::format("there is no column {}, expected the header {} (time_s may be missing)",
                              columns[needed].name, expected_header));
  }
  return order;
}

double number_of(const std::string& field, const char* column, int line, const std::string& origin) {
  double value = 0.0;
  const auto [end, problem] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (problem != std::errc() || end != field.data() + field.size() || !std::isfinite(value)) {
    io::fail_at(
        origin, line,
        fmt::format("{} is {}, expected a finite number with a point as in 1.5", column, io::in_quotes(field)));
  }
  return value;
}

void check_units(const MeasuredCurve& curve) {
  const auto [shallow, deep] = std::minmax_element(curve.depth.begin(), curve.depth.end());
  const double travel = *deep - *shallow;
  if (travel < least_travel) {
    throw InputError(
        fmt::format("{}: the depths lie within {:.3g} mm, which is not an insertion; depth_mm is expected in "
                    "millimetres, perhaps these are metres or inches",
                    curve.name, travel));
  }
  if (travel > greatest_travel) {
    throw InputError(
        fmt::format("{}: the depths span {:.4g} mm, longer than any needle; depth_mm is expected in "
                    "millimetres, perhaps these are micrometres",
                    curve.name, travel));
  }
  double largest = 0.0;
  for (const double force : curve.force) largest = std::max(largest, std::abs(force));
  if (largest > greatest_force) {
    throw InputError(
        fmt::format("{}: the largest force is {:.4g} N, more than a needle bears; force_N is expected in "
                    "newtons, perhaps these are millinewtons or grams",
                    curve.name, largest));
  }
  if (largest < least_force) {
    throw InputError(
        fmt::format("{}: the largest force is {:.3g} N, less than a sensor resolves; force_N is expected "
                    "in newtons, perhaps these are kilonewtons",
                    curve.name, largest));
  }
  double sum = 0.0;
  std::size_t inwards = 0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    if (curve.depth[i] <= curve.depth[i - 1]) continue;
    sum += curve.force[i];
    ++inwards;
  }
  if (inwards > 0 && sum < pulled_share * largest * static_cast<double>(inwards)) {
    throw InputError(
        fmt::format("{}: the forces are negative while the needle goes in; a positive force_N is expected "
                    "to push the needle out, so change their sign",
                    curve.name));
  }
  if (!curve.time.empty() && curve.time.back() - curve.time.front() > longest_time) {
    throw InputError(
        fmt::format("{}: the times span {:.4g} s, expected at most {:g} s; time_s is expected in seconds, "
                    "perhaps these are milliseconds",
                    curve.name, curve.time.back() - curve.time.front(), longest_time));
  }
  for (std::size_t i = 1; i < curve.time.size(); ++i) {
    const double speed = std::abs(curve.depth[i] - curve.depth[i - 1]) / (curve.time[i] - curve.time[i - 1]);
    if (speed > fastest_needle) {
      throw InputError(
          fmt::format("{}: after {:.6g} s the needle moves at {:.4g} mm/s, expected at most {:g}; check "
                      "the units of time_s and depth_mm",
                      curve.name, curve.time[i - 1], speed, fastest_needle));
    }
  }
}

}  // namespace

MeasuredCurve parse_measured_curve(std::string_view text, const std::string& origin, std::optional<double> speed) {
  const std::vector<io::CsvRow> rows =
      io::read_csv_rows(text, origin, {.separator = separator_of(text), .comments = true});
  if (rows.empty()) io::fail_at(origin, 1, fmt::format("the file is empty, expected the header {}", expected_header));
  const std::vector<std::size_t> order = columns_of(rows.front(), origin, speed);
  if (rows.size() - 1 < fewest_samples || rows.size() - 1 > most_samples) {
    throw InputError(fmt::format("{}: there are {} samples, expected {} to {}", origin, rows.size() - 1,
                                 fewest_samples, most_samples));
  }
  MeasuredCurve curve;
  curve.name = origin;
  const std::array<std::vector<double>*, 3> values = {&curve.time, &curve.depth, &curve.force};
  for (const io::CsvRow& row : std::span(rows).subspan(1)) {
    if (row.fields.size() != order.size())
      io::fail_at(origin, row.line,
                  fmt::format("there are {} columns, expected {} as in the header", row.fields.size(), order.size()));
    for (std::size_t i = 0; i < order.size(); ++i)
      values[order[i]]->push_back(number_of(row.fields[i], columns[order[i]].name, row.line, origin));
    const std::size_t n = curve.time.size();
    if (n > 1 && curve.time[n - 1] <= curve.time[n - 2]) {
      io::fail_at(
          origin, row.line,
          fmt::format("time_s is {} after {}, expected times that increase", curve.time[n - 1], curve.time[n - 2]));
    }
  }
  if (curve.depth.empty()) {
    for (const double time : curve.time) curve.depth.push_back(*speed * (time - curve.time.front()));
    curve.assumed = fmt::format(
        "{} has no depths: they are taken as {:g} mm/s times time_s, one even insertion from 0 mm at the first "
        "sample",
        origin, *speed);
  } else if (curve.time.empty() && speed) {
    curve.assumed = fmt::format("{} has no times: they are taken from the depths at {:g} mm/s", origin, *speed);
  } else if (speed) {
    curve.assumed = fmt::format("{} has times and depths, so that --speed is not used for it", origin);
  }
  check_units(curve);
  return curve;
}

MeasuredCurve read_measured_curve(const std::filesystem::path& file, std::optional<double> speed) {
  return parse_measured_curve(io::read_text_file(file, curve_limit), file.string(), speed);
}

MeasuredCurve joined(std::span<const MeasuredCurve> curves) {
  MeasuredCurve all;
  for (const MeasuredCurve& curve : curves) {
    all.name += (all.name.empty() ? "" : ", ") + curve.name;
    all.depth.insert(all.depth.end(), curve.depth.begin(), curve.depth.end());
    all.force.insert(all.force.end(), curve.force.begin(), curve.force.end());
  }
  return all;
}

std::vector<double> sample_times(const MeasuredCurve& curve, std::optional<double> speed) {
  if (!curve.time.empty()) return curve.time;
  if (!speed) {
    throw InputError(fmt::format(
        "{}: there is no column time_s and the model depends on time; give --speed, the needle's mm/s", curve.name));
  }
  std::vector<double> times = {0.0};
  for (std::size_t i = 1; i < curve.size(); ++i)
    times.push_back(times.back() + std::abs(curve.depth[i] - curve.depth[i - 1]) / *speed);
  if (times.back() > longest_time) {
    throw InputError(fmt::format("{}: the motion takes {:.4g} s at {:g} mm/s, expected at most {:g} s; check --speed",
                                 curve.name, times.back(), *speed, longest_time));
  }
  return times;
}

}  // namespace bodkin::study
