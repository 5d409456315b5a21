#include "session/scan_table.h"

#include <array>
#include <cstddef>

#include "session/session_schema.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::session {

namespace {

constexpr std::size_t scan_numbers = 21;    // columns of `scans` after the first
constexpr std::size_t most_parts = 70'000;  // more than a segmentation has labels
constexpr std::size_t longest_name = 1000;  // bytes

using ScanNumbers = std::array<double, scan_numbers>;

// In the order of the columns.
ScanNumbers numbers_of(const ScanSample& sample) {
  const Vec3 at = sample.probe.translation();
  const Eigen::Quaterniond turn = Eigen::Quaterniond(sample.probe.linear()).normalized();
  const imaging::UltrasoundSettings& set = sample.settings;
  ScanNumbers numbers{sample.time,       at.x(),    at.y(),       at.z(),    turn.w(),
                      turn.x(),          turn.y(),  turn.z(),     set.depth, set.gain,
                      set.dynamic_range, set.focus, set.frequency};
  for (std::size_t slider = 0; slider < set.sliders.size(); ++slider) numbers[13 + slider] = set.sliders[slider];
  return numbers;
}

ScanSample sample_of(const ScanNumbers& numbers, bool gel) {
  ScanSample sample;
  sample.time = numbers[0];
  sample.probe.translation() = Vec3(numbers[1], numbers[2], numbers[3]);
  sample.probe.linear() = Eigen::Quaterniond(numbers[4], numbers[5], numbers[6], numbers[7]).toRotationMatrix();
  imaging::UltrasoundSettings& set = sample.settings;
  set.depth = numbers[8];
  set.gain = numbers[9];
  set.dynamic_range = numbers[10];
  set.focus = numbers[11];
  set.frequency = numbers[12];
  for (std::size_t slider = 0; slider < set.sliders.size(); ++slider) set.sliders[slider] = numbers[13 + slider];
  set.gel = gel;
  return sample;
}

bool is_possible(const ScanNumbers& numbers, const ScanSample& sample, const anatomy::UltrasoundProbe& probe) {
  for (std::size_t axis = 1; axis <= 3; ++axis)
    if (!(numbers[axis] >= -furthest && numbers[axis] <= furthest)) return false;
  const double length = Eigen::Vector4d(numbers[4], numbers[5], numbers[6], numbers[7]).norm();
  if (!(length >= 1.0 - unit_tolerance && length <= 1.0 + unit_tolerance)) return false;
  if (!(sample.time >= 0.0 && sample.time <= last_time)) return false;
  try {
    imaging::check(sample.settings, probe);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

}  // namespace

ScanTables::ScanTables(SQLite::Database& database)
    : insert_sample_(std::make_unique<SQLite::Statement>(
          database, "INSERT INTO scans VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")),
      insert_part_(std::make_unique<SQLite::Statement>(database, "INSERT OR IGNORE INTO scanned VALUES(?, ?, ?)")) {}

ScanTables::~ScanTables() = default;

void ScanTables::add(const ScanSample& sample) {
  if (total_ + samples_.size() < session_schema::most_second_samples) samples_.push_back(sample);
}

void ScanTables::add(const ScannedPart& part) {
  parts_.push_back(part);
}

void ScanTables::put() {
  for (const ScanSample& sample : samples_) {
    insert_sample_->reset();
    int column = 1;
    insert_sample_->bind(column++, static_cast<std::int64_t>(total_++));
    for (const double number : numbers_of(sample)) insert_sample_->bind(column++, number);
    insert_sample_->bind(column, sample.settings.gel ? 1 : 0);
    insert_sample_->exec();
  }
  for (const ScannedPart& part : parts_) {
    insert_part_->reset();
    insert_part_->bind(1, part.is_structure ? 1 : 0);
    insert_part_->bind(2, part.name);
    insert_part_->bind(3, part.time);
    insert_part_->exec();
  }
  samples_.clear();
  parts_.clear();
}

void ScanTables::close() {
  insert_sample_.reset();
  insert_part_.reset();
}

std::vector<ScanSample> read_scans(SQLite::Database& database, const std::string& file,
                                   const anatomy::UltrasoundProbe* probe) {
  std::vector<ScanSample> scans;
  SQLite::Statement query(database, "SELECT * FROM scans ORDER BY sample");
  while (query.executeStep()) {
    const std::size_t row = scans.size();
    if (probe == nullptr) refuse_session(file, "there are samples of an ultrasound probe, but the header names none");
    if (row >= session_schema::most_second_samples) refuse_session(file, "the ultrasound probe has too many samples");
    ScanNumbers numbers{};
    bool valid = query.getColumn(0).getInt64() == static_cast<std::int64_t>(row);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const SQLite::Column column = query.getColumn(static_cast<int>(i) + 1);
      valid = valid && column.isFloat();
      numbers[i] = column.getDouble();
    }
    const SQLite::Column gel = query.getColumn(static_cast<int>(numbers.size()) + 1);
    valid = valid && gel.isInteger() && (gel.getInt64() == 0 || gel.getInt64() == 1);
    const ScanSample sample = sample_of(numbers, gel.getInt64() == 1);
    valid = valid && is_possible(numbers, sample, *probe) && (row == 0 || sample.time > scans.back().time);
    if (!valid) refuse_session(file, fmt::format("sample {} of the ultrasound probe is damaged", row));
    scans.push_back(sample);
  }
  return scans;
}

std::vector<ScannedPart> read_scanned(SQLite::Database& database, const std::string& file,
                                      const anatomy::UltrasoundProbe* probe) {
  std::vector<ScannedPart> parts;
  SQLite::Statement query(database,
                          "SELECT is_structure, name, first_s FROM scanned ORDER BY first_s, is_structure, name");
  while (query.executeStep()) {
    const std::int64_t kind = query.getColumn(0).getInt64();
    const ScannedPart part{kind == 1, query.getColumn(1).getString(), query.getColumn(2).getDouble()};
    const bool valid = probe != nullptr && parts.size() < most_parts && (kind == 0 || kind == 1) &&
                       part.name.size() <= longest_name && part.time >= 0.0 && part.time <= last_time;
    if (!valid) refuse_session(file, "the list of what the ultrasound showed is damaged");
    parts.push_back(part);
  }
  return parts;
}

}  // namespace bodkin::session
