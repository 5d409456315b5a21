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

// The store of results cannot be reached at the moment: no network, no server. What is to be kept waits in an outbox.
class StoreUnreachable : public SystemError {
 public:
  using SystemError::SystemError;
};

// A value that a statement is given, as text: databases turn it into the type of its column. Nothing is NULL.
using SqlValue = std::optional<std::string>;
// The values of one row as text; NULL is empty. Valid until the next row.
using SqlRow = std::span<const std::string_view>;

// A database that understands the little SQL of the store. Statements are the same for all of them; what is given
// stands for $1, $2, ... Every function throws SystemError with one sentence when the database refuses: it is locked,
// full or damaged; StoreUnreachable when it does not answer.
class SqlConnection {
 public:
  SqlConnection() = default;
  SqlConnection(const SqlConnection&) = delete;
  SqlConnection& operator=(const SqlConnection&) = delete;
  virtual ~SqlConnection() = default;

  // Where it is, for people: a path, or an address without a password.
  virtual const std::string& place() const = 0;
  // Whether it has the table of that name.
  virtual bool has_table(const std::string& name) = 0;
  // Makes an empty database one of Bodkin's results. Throws InputError when it is something else.
  virtual void claim() = 0;
  // Returns how many rows were changed.
  virtual std::int64_t change(const std::string& sql, const std::vector<SqlValue>& values = {}) = 0;
  virtual void read(const std::string& sql, const std::vector<SqlValue>& values,
                    const std::function<void(SqlRow)>& take) = 0;
  // What is changed until commit() is changed as one, and by nobody else meanwhile.
  virtual void begin() = 0;
  virtual void commit() = 0;
  virtual void roll_back() noexcept = 0;
  // Leaves nothing of deleted rows in the file. Not within begin() and commit().
  virtual void wipe() = 0;
};

// A file, which is made when it is not there. `patience`: how long it may be locked by another program.
std::unique_ptr<SqlConnection> connect_sqlite(const std::string& file, std::chrono::milliseconds patience);

// A server: postgresql://user@host:port/database; the tables lie in its schema `bodkin`. `patience`: for the
// connection and for each lock, at least a second.
std::unique_ptr<SqlConnection> connect_postgresql(const std::string& url, std::chrono::milliseconds patience);

// `work` as one change: all of it or nothing.
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
