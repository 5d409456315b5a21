#include "session/change_table.h"

#include <utility>

#include "session/session_schema.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::session {

void append_change(SQLite::Database& database, const NumberChange& change) {
  SQLite::Transaction transaction(database);
  if (!database.tableExists(session_schema::changes.name)) database.exec(session_schema::changes.sql);
  const NumberChangeTexts texts = texts_of(change);
  SQLite::Statement insert(database, "INSERT INTO changes VALUES(?, ?, ?, ?, ?)");
  insert.bind(1, static_cast<std::int64_t>(change.tick));
  insert.bind(2, static_cast<std::int64_t>(change.from_tick));
  insert.bind(3, texts.haptics);
  insert.bind(4, texts.tissues);
  insert.bind(5, checksum_of(change, texts));
  insert.exec();
  transaction.commit();
}

std::vector<NumberChange> read_changes(SQLite::Database& database, const std::string& file) {
  std::vector<NumberChange> changes;
  if (!database.tableExists(session_schema::changes.name)) return changes;
  SQLite::Statement query(database, "SELECT tick, from_tick, haptics, tissues, checksum FROM changes ORDER BY tick");
  while (query.executeStep()) {
    NumberChange change;
    const std::int64_t tick = query.getColumn(0).getInt64(), from = query.getColumn(1).getInt64();
    change.tick = static_cast<std::uint64_t>(tick);
    change.from_tick = static_cast<std::uint64_t>(from);
    const NumberChangeTexts texts{query.getColumn(2).getString(), query.getColumn(3).getString()};
    if (changes.size() >= session_schema::most_changes || from < 0 || tick < from ||
        query.getColumn(4).getInt64() != checksum_of(change, texts)) {
      throw InputError(fmt::format(
          "{}: the change of numbers at tick {} is damaged; give a session file as it was written", file, tick));
    }
    read_texts(texts, fmt::format("{}: the change of numbers at tick {}", file, tick), change);
    changes.push_back(std::move(change));
  }
  return changes;
}

}  // namespace bodkin::session
