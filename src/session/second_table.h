#pragma once

#include <optional>
#include <string>
#include <vector>

#include "session/second_sample.h"

namespace SQLite {
class Database;
}

namespace bodkin::session {

// The table `second_hand` of a session file, in the order of its samples. `second`: of the header; empty: no second
// hand, so that rows are invalid. `file`: prefix of messages. Throws InputError for invalid rows, and
// SQLite::Exception.
std::vector<SecondSample> read_second_hand(SQLite::Database& database, const std::string& file,
                                           const std::optional<SecondHeader>& second);

}  // namespace bodkin::session
