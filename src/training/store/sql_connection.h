#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace bodkin::training {

// The store of results is unreachable at the moment: no network, no server. Records wait in an outbox.
class StoreUnreachable : public SystemError {
 public:
  using SystemError::SystemError;
};

// A statement's parameter, as text: databases convert it to the type of its column. Empty is NULL.
using SqlValue = std::optional<std::string>;
// The values of one row as text; NULL is empty. Valid until the next row.
using SqlRow = std::span<const std::string_view>;

// A database that supports the small subset of SQL used by the store. Statements are the same for all databases; $1,
// $2, ... are parameters. Every function throws SystemError with one sentence when the database refuses: it is
// locked, full or damaged; StoreUnreachable when it does not respond.
class SqlConnection {
 public:
  SqlConnection() = default;
  SqlConnection(const SqlConnection&) = delete;
  SqlConnection& operator=(const SqlConnection&) = delete;
  virtual ~SqlConnection() = default;

  // Its address, for people: a path, or an address without a password.
  virtual const std::string& place() const = 0;
  // Whether it has the table of that name.
  virtual bool has_table(const std::string& name) = 0;
  // Initialises an empty database for Bodkin's results. Throws InputError when it contains anything else.
  virtual void claim() = 0;
  // Returns the number of changed rows.
  virtual std::int64_t change(const std::string& sql, const std::vector<SqlValue>& values = {}) = 0;
  virtual void read(const std::string& sql, const std::vector<SqlValue>& values,
                    const std::function<void(SqlRow)>& take) = 0;
  // Changes until commit() are one transaction, exclusive of other writers.
  virtual void begin() = 0;
  virtual void commit() = 0;
  virtual void roll_back() noexcept = 0;
  // Erases traces of deleted rows from the file. Not between begin() and commit().
  virtual void wipe() = 0;
};

// A file, which is created if missing. `patience`: how long it may be locked by another program.
std::unique_ptr<SqlConnection> connect_sqlite(const std::string& file, std::chrono::milliseconds patience);

// A server: postgresql://user@host:port/database; the tables lie in its schema `bodkin`. `patience`: for the
// connection and for each lock, at least a second.
std::unique_ptr<SqlConnection> connect_postgresql(const std::string& url, std::chrono::milliseconds patience);

// Runs `work` as one transaction: all of it or nothing.
template <typename Work>
void in_one_change(SqlConnection& connection, Work&& work) {
  connection.begin();
  try {
    work();
    connection.commit();
  } catch (...) {
    connection.roll_back();
    throw;
  }
}

}  // namespace bodkin::training
