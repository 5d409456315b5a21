#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "session/body_log.h"

namespace SQLite {
class Database;
class Statement;
}  // namespace SQLite

namespace bodkin::session {

// The tables `body_steps` and `body_taken` of a session file, only in a session whose body moved on its own.
class BodyTables {
 public:
  // Creates them. Throws SQLite::Exception, as all functions below. `database` must outlive the object.
  explicit BodyTables(SQLite::Database& database);
  ~BodyTables();

  // Buffered until put(). Steps beyond the limit of a session are dropped.
  void add(const fem::BodyStep& step);
  void add(const AppliedBodyStep& step);
  bool empty() const noexcept { return steps_.empty() && applied_steps_.empty(); }
  // Inside the caller's transaction.
  void put();
  // Releases the database.
  void close();

 private:
  std::unique_ptr<SQLite::Statement> insert_step_, insert_applied_step_;
  std::vector<fem::BodyStep> steps_;
  std::vector<AppliedBodyStep> applied_steps_;
};

// In their order; none if the tables do not exist. `file`: prefix of messages. Throw InputError for invalid rows, and
// SQLite::Exception.
std::vector<fem::BodyStep> read_body_steps(SQLite::Database& database, const std::string& file);
std::vector<AppliedBodyStep> read_applied_body_steps(SQLite::Database& database, const std::string& file);

}  // namespace bodkin::session
