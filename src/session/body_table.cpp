#include "session/body_table.h"

#include <array>
#include <bit>
#include <cstddef>
#include <span>

#include "session/session_schema.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

namespace bodkin::session {

namespace {

constexpr std::size_t pose_numbers = 12, pose_bytes = 8 * pose_numbers;
constexpr std::size_t most_body_rows = 10'000'000;  // almost two days of steps

using PoseBytes = std::array<std::uint8_t, pose_bytes>;

// The pose's columns as doubles, bit for bit, little-endian whatever the machine.
PoseBytes bytes_of_pose(const Pose& pose) {
  PoseBytes bytes{};
  std::size_t at = 0;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) {
      const auto bits = std::bit_cast<std::uint64_t>(pose.matrix()(row, column));
      for (int byte = 0; byte < 8; ++byte) bytes[at++] = static_cast<std::uint8_t>(bits >> (8 * byte));
    }
  return bytes;
}

Pose pose_of_bytes(std::span<const std::uint8_t> bytes) {
  Pose pose = Pose::Identity();
  std::size_t at = 0;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) {
      std::uint64_t bits = 0;
      for (int byte = 0; byte < 8; ++byte) bits |= std::uint64_t{bytes[at++]} << (8 * byte);
      pose.matrix()(row, column) = std::bit_cast<double>(bits);
    }
  return pose;
}

std::int64_t checksum_of_step(std::uint64_t step, std::uint64_t digest, std::span<const std::uint8_t> probe) {
  return chunk_checksum(step, static_cast<std::uint32_t>(digest >> 32U), static_cast<std::uint32_t>(digest), probe);
}

std::int64_t checksum_of_applied_step(const AppliedBodyStep& step) {
  return chunk_checksum(step.number * 0x100000001B3ULL + step.tick, static_cast<std::uint32_t>(step.step >> 32U),
                        static_cast<std::uint32_t>(step.step), {});
}

}  // namespace

BodyTables::BodyTables(SQLite::Database& database) {
  for (const session_schema::Table& table : session_schema::moving_body) database.exec(table.sql);
  insert_step_ = std::make_unique<SQLite::Statement>(database, "INSERT INTO body_steps VALUES(?, ?, ?, ?)");
  insert_applied_step_ = std::make_unique<SQLite::Statement>(database, "INSERT INTO body_taken VALUES(?, ?, ?, ?)");
}

BodyTables::~BodyTables() = default;

void BodyTables::add(const fem::BodyStep& step) {
  if (step.step <= most_body_rows) steps_.push_back(step);
}

void BodyTables::add(const AppliedBodyStep& step) {
  if (step.number < most_body_rows) applied_steps_.push_back(step);
}

void BodyTables::put() {
  for (const fem::BodyStep& step : steps_) {
    PoseBytes bytes{};
    if (step.probe) bytes = bytes_of_pose(*step.probe);
    const std::span<const std::uint8_t> probe(bytes.data(), step.probe ? bytes.size() : 0);
    insert_step_->reset();
    insert_step_->bind(1, static_cast<std::int64_t>(step.step));
    if (step.probe) {
      insert_step_->bind(2, bytes.data(), static_cast<int>(bytes.size()));
    } else {
      insert_step_->bind(2);
    }
    insert_step_->bind(3, std::bit_cast<std::int64_t>(step.digest));
    insert_step_->bind(4, checksum_of_step(step.step, step.digest, probe));
    insert_step_->exec();
  }
  for (const AppliedBodyStep& step : applied_steps_) {
    insert_applied_step_->reset();
    insert_applied_step_->bind(1, static_cast<std::int64_t>(step.number));
    insert_applied_step_->bind(2, static_cast<std::int64_t>(step.tick));
    insert_applied_step_->bind(3, static_cast<std::int64_t>(step.step));
    insert_applied_step_->bind(4, checksum_of_applied_step(step));
    insert_applied_step_->exec();
  }
  steps_.clear();
  applied_steps_.clear();
}

void BodyTables::close() {
  insert_step_.reset();
  insert_applied_step_.reset();
}

std::vector<fem::BodyStep> read_body_steps(SQLite::Database& database, const std::string& file) {
  std::vector<fem::BodyStep> steps;
  if (!database.tableExists("body_steps")) return steps;
  SQLite::Statement query(database, "SELECT step, probe, digest, checksum FROM body_steps ORDER BY step");
  while (query.executeStep()) {
    const SQLite::Column blob = query.getColumn(1);
    const auto size = static_cast<std::size_t>(blob.getBytes());
    fem::BodyStep step;
    step.step = static_cast<std::uint64_t>(query.getColumn(0).getInt64());
    step.digest = std::bit_cast<std::uint64_t>(query.getColumn(2).getInt64());
    const std::span<const std::uint8_t> probe(static_cast<const std::uint8_t*>(blob.getBlob()), size);
    const bool fits = blob.isNull() ? size == 0 : size == pose_bytes;
    if (steps.size() >= most_body_rows || !fits || (!steps.empty() && step.step <= steps.back().step) ||
        query.getColumn(3).getInt64() != checksum_of_step(step.step, step.digest, probe))
      refuse_session(file, fmt::format("step {} of the moving body is damaged", step.step));
    if (!blob.isNull()) step.probe = pose_of_bytes(probe);
    steps.push_back(step);
  }
  return steps;
}

std::vector<AppliedBodyStep> read_applied_body_steps(SQLite::Database& database, const std::string& file) {
  std::vector<AppliedBodyStep> all;
  if (!database.tableExists("body_taken")) return all;
  SQLite::Statement query(database, "SELECT number, tick, step, checksum FROM body_taken ORDER BY number");
  while (query.executeStep()) {
    AppliedBodyStep step;
    step.number = static_cast<std::uint64_t>(query.getColumn(0).getInt64());
    step.tick = static_cast<std::uint64_t>(query.getColumn(1).getInt64());
    step.step = static_cast<std::uint64_t>(query.getColumn(2).getInt64());
    const bool in_order = all.empty() || (step.tick > all.back().tick && step.step > all.back().step);
    if (all.size() >= most_body_rows || !in_order || query.getColumn(3).getInt64() != checksum_of_applied_step(step))
      refuse_session(file, fmt::format("entry {} of what the needle met of the moving body is damaged", step.number));
    all.push_back(step);
  }
  return all;
}

}  // namespace bodkin::session
