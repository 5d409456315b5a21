#include "io/device_profiles_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include <fmt/format.h>

#include "anatomy/case.h"
#include "core/settings_check.h"
#include "io/csv_rows.h"
#include "io/resources.h"
#include "io/xml_document.h"

namespace bodkin::io {

namespace {

constexpr std::size_t table_limit = 1 << 20;  // bytes
constexpr std::string_view header = "device,quantity,value,unit,source,provenance,remark";
constexpr std::array<const char*, 7> columns = {"device", "quantity",   "value", "unit",
                                                "source", "provenance", "remark"};
constexpr const char* other_name = "also_called";

struct QuantityKind {
  std::string_view name;
  std::string_view unit;
  double most;
};

// A quantity also present in a case's device.
QuantityKind kind_of(std::string_view name, double anatomy::DeviceLimits::*limit) {
  const DeclaredParameter declared = declaration_of(limit);
  return {name, declared.unit, declared.range.high};
}

// In the order of DeviceQuantity.
const std::array<QuantityKind, haptics::device_quantities>& quantities() {
  using Limits = anatomy::DeviceLimits;
  static const std::array<QuantityKind, haptics::device_quantities> kinds = {
      {kind_of("peak_force", &Limits::peak_force),
       kind_of("continuous_force", &Limits::continuous_force),
       kind_of("peak_torque", &Limits::peak_torque),
       kind_of("stiffness", &Limits::stiffness),
       {"damping", "N s/mm", 1.0},
       kind_of("resolution", &Limits::position_resolution),
       {"workspace_x", "mm", 3000.0},
       {"workspace_y", "mm", 3000.0},
       {"workspace_z", "mm", 3000.0},
       {"friction", "N", 20.0},
       {"inertia", "kg", 5.0}}};
  return kinds;
}

constexpr std::array<std::string_view, 5> provenances = {"not sourced", "paper", "looked-up", "recalled", "derived"};

// One row, checked.
class ProfileRow {
 public:
  ProfileRow(const CsvRow& row, const std::string& origin) : row_(row), origin_(origin) {
    if (row.fields.size() != columns.size()) {
      fail_at(origin, row.line,
              fmt::format("there are {} columns, expected {} ({})", row.fields.size(), columns.size(), header));
    }
    if (row.fields[0].empty() || row.fields[0].size() > 100) fail(0, "the name of a device, at most 100 bytes long");
    if (row.fields[1] == other_name && row.fields[2].empty()) fail(2, "another name of the device");
  }

  bool is_other_name() const { return row_.fields[1] == other_name; }

  haptics::DeviceQuantity quantity() const {
    for (std::size_t i = 0; i < quantities().size(); ++i) {
      if (row_.fields[1] == quantities()[i].name) return static_cast<haptics::DeviceQuantity>(i);
    }
    std::string names = other_name;
    for (const QuantityKind& known : quantities()) names += fmt::format(", {}", known.name);
    fail(1, fmt::format("one of {}", names));
  }

  haptics::ProfileValue value() const {
    const QuantityKind& kind = quantities()[static_cast<std::size_t>(quantity())];
    if (row_.fields[3] != kind.unit) fail(3, fmt::format("{} for {}", kind.unit, kind.name));
    haptics::ProfileValue found{.value = number(kind), .source = row_.fields[4], .remark = row_.fields[6]};
    const auto* const known = std::find(provenances.begin(), provenances.end(), row_.fields[5]);
    if (known == provenances.end()) fail(5, "paper, looked-up, recalled, derived or not sourced");
    found.provenance = static_cast<haptics::Provenance>(known - provenances.begin());
    if ((found.provenance == haptics::Provenance::unknown) != row_.fields[2].empty()) {
      fail(5, row_.fields[2].empty() ? "not sourced, because there is no value" : "where the value comes from");
    }
    if (found.provenance != haptics::Provenance::unknown && found.source.empty())
      fail(4, "where the value comes from");
    return found;
  }

 private:
  [[noreturn]] void fail(std::size_t column, const std::string& expected) const {
    fail_at(origin_, row_.line,
            fmt::format("column {}: {} is {}, expected {}", column + 1, columns[column],
                        in_quotes(row_.fields[column]), expected));
  }

  double number(const QuantityKind& kind) const {
    const std::string& text = row_.fields[2];
    if (text.empty()) return 0.0;
    double value = 0.0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size() || !(value > 0.0 && value <= kind.most)) {
      fail(2, fmt::format("a number above 0 and at most {} {}, or nothing", kind.most, kind.unit));
    }
    return value;
  }

  const CsvRow& row_;
  const std::string& origin_;
};

// Profiles during reading, with the lines of their numbers.
struct Reading {
  haptics::DeviceProfile profile;
  std::array<int, haptics::device_quantities> lines{};
};

Reading& profile_named(std::vector<Reading>& readings, const std::string& name) {
  for (Reading& reading : readings) {
    if (reading.profile.name == name) return reading;
  }
  readings.emplace_back().profile.name = name;
  return readings.back();
}

void check_forces(const Reading& reading, const std::string& origin) {
  const double peak = reading.profile.of(haptics::DeviceQuantity::peak_force).value;
  const double continuous = reading.profile.of(haptics::DeviceQuantity::continuous_force).value;
  if (continuous <= peak) return;
  fail_at(origin, reading.lines[static_cast<std::size_t>(haptics::DeviceQuantity::continuous_force)],
          fmt::format("the continuous force of {} is {} N, expected at most its peak force of {} N",
                      in_quotes(reading.profile.name), continuous, peak));
}

}  // namespace

std::vector<haptics::DeviceProfile> parse_device_profiles(const std::string& text, const std::string& origin) {
  const std::vector<CsvRow> rows = read_csv_rows(text, origin, {.comments = true});
  if (rows.empty()) fail_at(origin, 1, fmt::format("the file is empty, expected the header {}", header));
  const std::string first = fmt::format("{}", fmt::join(rows.front().fields, ","));
  if (first != header) {
    fail_at(origin, rows.front().line, fmt::format("the header is {}, expected {}", in_quotes(first), header));
  }
  std::vector<Reading> readings;
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    const ProfileRow entry(*row, origin);
    Reading& reading = profile_named(readings, row->fields[0]);
    if (entry.is_other_name()) {
      reading.profile.other_names.push_back(row->fields[2]);
      continue;
    }
    const auto index = static_cast<std::size_t>(entry.quantity());
    if (reading.lines[index] != 0) {
      fail_at(origin, row->line,
              fmt::format("{} of {} is given again, which line {} gives already", quantities()[index].name,
                          in_quotes(row->fields[0]), reading.lines[index]));
    }
    reading.profile.values[index] = entry.value();
    reading.lines[index] = row->line;
  }
  if (readings.empty()) fail_at(origin, rows.front().line, "there are no devices under the header");
  std::vector<haptics::DeviceProfile> profiles;
  for (Reading& reading : readings) {
    check_forces(reading, origin);
    profiles.push_back(std::move(reading.profile));
  }
  return profiles;
}

std::vector<haptics::DeviceProfile> read_device_profiles(const std::filesystem::path& file) {
  return parse_device_profiles(read_text_file(file, table_limit), file.string());
}

std::vector<haptics::DeviceProfile> default_device_profiles() {
  return read_device_profiles(shared_file("devices.csv"));
}

}  // namespace bodkin::io
