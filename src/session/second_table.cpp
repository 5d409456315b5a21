#include "session/second_table.h"

#include <array>

#include "session/session_schema.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

namespace bodkin::session {

namespace {

// Limits that no second hand exceeds.
constexpr double strongest = 1e4;          // N
constexpr double lowest_pressure = -0.2;   // MPa gauge
constexpr double highest_pressure = 10.0;  // MPa
constexpr double largest_volume = 1e6;     // mm^3

}  // namespace

std::vector<SecondSample> read_second_hand(SQLite::Database& database, const std::string& file,
                                           const std::optional<SecondHeader>& second) {
  std::vector<SecondSample> samples;
  SQLite::Statement query(database,
                          "SELECT sample, time_s, x_mm, y_mm, z_mm, qw, qx, qy, qz, force_N, pressure_MPa, "
                          "volume_mm3 FROM second_hand ORDER BY sample");
  const bool is_plunger = second && second->role == SecondRole::plunger;
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };  // no NaN
  while (query.executeStep()) {
    const std::size_t row = samples.size();
    if (!second) refuse_session(file, "there are samples of a second hand, but the header names none");
    if (row >= session_schema::most_second_samples) refuse_session(file, "the second hand has too many samples");
    std::array<double, 11> values{};  // in the order of the columns
    bool valid = query.getColumn(0).getInt64() == static_cast<std::int64_t>(row);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const SQLite::Column column = query.getColumn(static_cast<int>(i) + 1);
      const bool is_number = i < 9 || is_plunger;
      valid = valid && (is_number ? column.isFloat() : column.isNull());
      if (is_number) values[i] = column.getDouble();
    }
    SecondSample sample;
    sample.time = values[0];
    sample.position = Vec3(values[1], values[2], values[3]);
    sample.rotation = Eigen::Quaterniond(values[4], values[5], values[6], values[7]);
    sample.force = values[8];
    sample.pressure = values[9];
    sample.volume = values[10];
    for (int axis = 0; axis < 3; ++axis) valid = valid && within(sample.position[axis], -furthest, furthest);
    valid = valid && within(sample.time, 0.0, last_time) &&
            within(sample.rotation.norm(), 1.0 - unit_tolerance, 1.0 + unit_tolerance) &&
            within(sample.force, -strongest, strongest) &&
            within(sample.pressure, lowest_pressure, highest_pressure) &&
            within(sample.volume, 0.0, largest_volume) && (row == 0 || sample.time > samples.back().time);
    if (!valid) refuse_session(file, fmt::format("sample {} of the second hand is damaged", row));
    samples.push_back(sample);
  }
  return samples;
}

}  // namespace bodkin::session
