#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "session/session_file.h"
#include "session/session_schema.h"
#include "session/tick_codec.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
using namespace bodkin::haptics;
using namespace bodkin::session;
using namespace bodkin::simulation;

// A session file of a test's own, removed with its log when the test ends.
class ScratchSession {
 public:
  ScratchSession()
      : path_(std::filesystem::temp_directory_path() /
              ("bodkin_" + std::to_string(getpid()) + "_" + test_name() + ".bodkin")) {
    remove();
  }
  ~ScratchSession() { remove(); }
  ScratchSession(const ScratchSession&) = delete;
  ScratchSession& operator=(const ScratchSession&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  static std::string test_name() {
    std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
  }
  void remove() const {
    std::error_code ignored;
    for (const char* ending : {"", "-wal", "-shm", "-journal"})
      std::filesystem::remove(path_.string() + ending, ignored);
  }
  std::filesystem::path path_;
};

// Makes of a finished session one of format version 4, which kept no volumes of the patient.
inline void make_version_4(const std::filesystem::path& file) {
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
  database.exec("DROP TABLE volumes");
  database.exec("PRAGMA user_version=4");
}

// Makes of a finished session without ultrasound one of format version 3, which lacks its tables.
inline void make_version_3(const std::filesystem::path& file) {
  make_version_4(file);
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
  database.exec("DROP TABLE scans");
  database.exec("DROP TABLE scanned");
  database.exec("PRAGMA user_version=3");
}

// Makes of it one as Bodkin wrote it until 0.1: format version 2, without diagnostics.
inline void make_version_2(const std::filesystem::path& file) {
  make_version_3(file);
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
  database.exec("DROP TABLE diagnostics");
  database.exec("DELETE FROM header WHERE key IN ('diagnostics', 'recording_id')");
  std::string all;
  SQLite::Statement rows(database,
                         "SELECT key || char(10) || value || char(10) FROM header WHERE key NOT IN ('checksum', "
                         "'finished_after_ticks', 'second_samples') ORDER BY key");
  while (rows.executeStep()) all += rows.getColumn(0).getString();
  SQLite::Statement tissues(
      database, "SELECT id || char(10) || name || char(10) || title || char(10) FROM tissues ORDER BY id");
  while (tissues.executeStep()) all += tissues.getColumn(0).getString();
  SQLite::Statement checksum(database, "UPDATE header SET value=? WHERE key='checksum'");
  checksum.bind(1, text_checksum(all));
  checksum.exec();
  database.exec("PRAGMA user_version=2");
}

inline SessionHeader sample_header() {
  SessionHeader header;
  header.bodkin_version = "9.9";
  header.case_folder = "/somewhere/a patient";
  header.case_digest = "0123456789abcdef";
  header.body_digest = "fedcba9876543210";
  header.case_xml = "<case name=\"ö\">\n  'quoted'\n</case>";
  header.operator_name = "expert";
  header.operator_settings = "{\"a\":1}";
  header.seed = std::numeric_limits<std::uint64_t>::max();
  header.dt = 0.001;
  header.started_at = "2026-01-02T03:04:05Z";
  header.recording_id = "00112233445566778899aabbccddeeff";
  header.path = {{0.1, -2.5e-7, 1e9}, {4, 5, 6}};
  TrackingWallSettings wall;
  wall.catch_up = 0.1;  // which has no finite binary form
  wall.layers = {{0.0, {0.5, 1.0 / 3.0}}};
  header.haptics.resistance = wall;
  header.haptics.constraint = NoConstraint{};
  header.haptics.parts.relaxation = {{0.3, 2.0}};
  header.tissues = {
      {tissue::air, "air", "air"}, {tissue::skin, "skin", "skin, \"thick\""}, {200, "own", "an own one"}};
  return header;
}

// A record full of awkward numbers, different for every tick.
inline TickRecord sample_record(std::uint64_t tick) {
  Random random(tick + 1);
  const auto number = [&] {
    switch (random.next() % 12) {
      case 0:
        return -0.0;
      case 1:
        return std::numeric_limits<double>::infinity();
      case 2:
        return std::bit_cast<double>(0x7FF8000000000123ULL);  // a NaN with a payload
      case 3:
        return std::numeric_limits<double>::denorm_min();
      default:
        return random.normal();
    }
  };
  TickRecord record;
  record.tick = tick;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) record.input.needle.matrix()(row, column) = number();
  }
  for (Wrench* wrench : {&record.output.requested, &record.output.applied}) {
    wrench->force = Vec3(number(), number(), number());
    wrench->torque = Vec3(number(), number(), number());
  }
  record.output.depth = number();
  record.output.velocity = number();
  record.output.resistance = number();
  record.output.constraint = number();
  record.output.energy = number();
  record.output.tissue = static_cast<TissueId>(random.next() % 255);
  record.output.in_contact = random.next() % 2 == 0;
  record.output.limits = static_cast<std::uint8_t>(random.next());
  for (std::uint64_t event = 0; event < tick % 3; ++event) {
    record.output.events.push({static_cast<EventKind>(random.next() % 9), tissue::skin, number(), number()});
  }
  return record;
}

inline std::vector<std::uint8_t> bytes_of(const TickRecord& record) {
  std::vector<std::uint8_t> bytes;
  encode_tick(record, bytes);
  return bytes;
}

inline std::vector<std::uint8_t> bytes_of(const Event& event) {
  std::vector<std::uint8_t> bytes;
  encode_event(0, event, bytes);
  return bytes;
}

// The sentence with which a file is refused.
inline std::string refusal_of(const std::filesystem::path& file) {
  try {
    read_session(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "it was accepted";
}

}  // namespace bodkin
