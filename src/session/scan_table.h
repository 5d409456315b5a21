#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "session/scan_sample.h"

#include "anatomy/ultrasound_probe.h"

namespace SQLite {
class Database;
class Statement;
}  // namespace SQLite

namespace bodkin::session {

// The tables `scans` and `scanned` of a session file: the settings and findings of its ultrasound machine.
class ScanTables {
 public:
  // Throws SQLite::Exception, as all functions below. `database` must outlive the object.
  explicit ScanTables(SQLite::Database& database);
  ~ScanTables();

  // Buffered until put(). Times of samples must ascend strictly; samples beyond the limit of a session are dropped.
  void add(const ScanSample& sample);
  // Each part once.
  void add(const ScannedPart& part);
  bool empty() const noexcept { return samples_.empty() && parts_.empty(); }
  // Inside the caller's transaction.
  void put();
  std::uint64_t samples() const noexcept { return total_; }  // put so far
  // Releases the database.
  void close();

 private:
  std::unique_ptr<SQLite::Statement> insert_sample_, insert_part_;
  std::vector<ScanSample> samples_;
  std::vector<ScannedPart> parts_;
  std::uint64_t total_ = 0;
};

// In the order of their times. `probe`: of the header; null: no machine, so that rows are invalid. `file`: prefix of
// messages. Throws InputError for invalid rows, and SQLite::Exception.
std::vector<ScanSample> read_scans(SQLite::Database& database, const std::string& file,
                                   const anatomy::UltrasoundProbe* probe);
std::vector<ScannedPart> read_scanned(SQLite::Database& database, const std::string& file,
                                      const anatomy::UltrasoundProbe* probe);

}  // namespace bodkin::session
