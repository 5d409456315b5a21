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

// The tables `body_steps` and `body_taken` of a session file, which only a session has whose body moved by itself.
class BodyTables {
 public:
  // Makes them. Throws SQLite::Exception, as all below. `database` must outlive the object.
  explicit BodyTables(SQLite::Database& database);
  ~BodyTables();

  // Kept until put(). More than a session may have are left out.
  void add(const fem::BodyStep& step);
  void add(const BodyTaken& taken);
  bool empty() const noexcept { return steps_.empty() && taken_.empty(); }
  // Inside the caller's transaction.
  void put();
  // Lets go of the database.
  void close();

 private:
  std::unique_ptr<SQLite::Statement> insert_step_, insert_taken_;
  std::vector<fem::BodyStep> steps_;
  std::vector<BodyTaken> taken_;
};

// In their order; none where there are no such tables. `file`: how messages begin. Throw InputError for rows that no
// writer makes, and SQLite::Exception.
std::vector<fem::BodyStep> read_body_steps(SQLite::Database& database, const std::string& file);
std::vector<BodyTaken> read_body_taken(SQLite::Database& database, const std::string& file);

}  // namespace bodkin::session
