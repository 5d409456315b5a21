#pragma once

#include <string>
#include <vector>

#include "session/number_change.h"

namespace SQLite {
class Database;
}

namespace bodkin::session {

// The table `changes` of a session file, only in a session whose numbers were changed while it ran.

// Throws SQLite::Exception.
void append_change(SQLite::Database& database, const NumberChange& change);
// In the order of their ticks; none if the table does not exist. `file`: prefix of messages. Throws InputError and
// SQLite::Exception.
std::vector<NumberChange> read_changes(SQLite::Database& database, const std::string& file);

}  // namespace bodkin::session
