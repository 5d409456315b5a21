#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include "training/store/sql_connection.h"

namespace bodkin::training {

namespace {

constexpr int store_application_id = 0x42444B52;  // "BDKR"

class SqliteConnection final : public SqlConnection {
 public:
  SqliteConnection(const std::string& file, std::chrono::milliseconds patience)
      : file_(file), database_(opened(file, patience)) {
    guarded([&] {
      database_.exec("PRAGMA secure_delete=ON");  // deleted data are overwritten
      database_.exec("PRAGMA foreign_keys=ON");
    });
  }

  const std::string& place() const override { return file_; }

  bool has_table(const std::string& name) override {
    bool found = false;
    read("SELECT name FROM sqlite_master WHERE type = 'table' AND name = $1", {name}, [&](SqlRow) { found = true; });
    return found;
  }

  void claim() override {
    guarded([&] {
      const int tables = database_.execAndGet("SELECT count(*) FROM sqlite_master").getInt();
      const int id = database_.execAndGet("PRAGMA application_id").getInt();
      if (tables > 0 && id != store_application_id) {
        throw InputError(fmt::format("{} is a database, but not of results; name another file with --store", file_));
      }
      database_.exec(fmt::format("PRAGMA application_id={}", store_application_id));
    });
  }

  std::int64_t change(const std::string& sql, const std::vector<SqlValue>& values) override {
    return guarded([&]() -> std::int64_t {
      SQLite::Statement statement(database_, sql);
      bind(statement, values);
      return statement.exec();
    });
  }

  void read(const std::string& sql, const std::vector<SqlValue>& values,
            const std::function<void(SqlRow)>& take) override {
    guarded([&] {
      SQLite::Statement statement(database_, sql);
      bind(statement, values);
      std::vector<std::string_view> row(static_cast<std::size_t>(statement.getColumnCount()));
      while (statement.executeStep()) {
        for (std::size_t i = 0; i < row.size(); ++i) {
          const SQLite::Column column = statement.getColumn(static_cast<int>(i));
          const char* const text = column.getText();
          row[i] = {text, static_cast<std::size_t>(column.getBytes())};
        }
        take(row);
      }
    });
  }

  void begin() override {
    guarded([&] { database_.exec("BEGIN IMMEDIATE"); });
  }
  void commit() override {
    guarded([&] { database_.exec("COMMIT"); });
  }
  void roll_back() noexcept override { database_.tryExec("ROLLBACK"); }  // SQLite may have done so itself
  void wipe() override {
    guarded([&] { database_.exec("VACUUM"); });
  }

 private:
  SQLite::Database opened(const std::string& file, std::chrono::milliseconds patience) const {
    return guarded([&] {
      return SQLite::Database(file, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, static_cast<int>(patience.count()));
    });
  }

  static void bind(SQLite::Statement& statement, const std::vector<SqlValue>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string name = fmt::format("${}", i + 1);
      if (values[i])
        statement.bind(name, *values[i]);
      else
        statement.bind(name);
    }
  }

  template <typename Work>
  std::invoke_result_t<Work> guarded(Work&& work) const {
    try {
      return work();
    } catch (const SQLite::Exception& error) {
      throw_sentence(error);
    }
  }

  [[noreturn]] void throw_sentence(const SQLite::Exception& error) const {
    switch (error.getErrorCode()) {
      case SQLITE_BUSY:
      case SQLITE_LOCKED:
        throw SystemError(fmt::format(
            "the store {} is locked by another program; nothing was changed: try again when that has ended", file_));
      case SQLITE_FULL:
      case SQLITE_IOERR:
        throw SystemError(fmt::format(
            "the store {} cannot be written; nothing was changed: free space on its disk and try again", file_));
      case SQLITE_READONLY:
      case SQLITE_PERM:
        throw SystemError(
            fmt::format("you may only read the store {}; change the rights of the file and of its folder", file_));
      case SQLITE_CANTOPEN:
        throw SystemError(
            fmt::format("the store {} cannot be opened; its folder must exist and be yours to write", file_));
      case SQLITE_NOTADB:
        throw InputError(fmt::format("{} is not a store of results; name another file with --store", file_));
      case SQLITE_CORRUPT:
        throw SystemError(fmt::format(
            "the store {} is damaged; put it aside and add the sessions again with 'bodkin results add'", file_));
      default:
        throw SystemError(fmt::format("the store {}: {}", file_, error.what()));
    }
  }

  std::string file_;
  SQLite::Database database_;
};

}  // namespace

std::unique_ptr<SqlConnection> connect_sqlite(const std::string& file, std::chrono::milliseconds patience) {
  return std::make_unique<SqliteConnection>(file, patience);
}

}  // namespace bodkin::training
