#include <algorithm>
#include <regex>

#include <fmt/format.h>
#include <pqxx/pqxx>

#include "training/store/sql_connection.h"

namespace bodkin::training {

namespace {

constexpr const char* schema_name = "bodkin";
constexpr std::int64_t lock_number = 0x42444B52;  // shared by all who change a store; the number is arbitrary

// The first line of the server's message.
std::string first_line(const std::string& text) {
  std::string line = text.substr(0, text.find('\n'));
  while (!line.empty() && (line.back() == ' ' || line.back() == '.')) line.pop_back();
  return line;
}

class PostgresqlConnection final : public SqlConnection {
 public:
  PostgresqlConnection(const std::string& url, std::chrono::milliseconds patience)
      : place_(std::regex_replace(std::regex_replace(url, std::regex("://([^/@:]*):[^/@]*@"), "://$1@"),
                                  std::regex("([?&]password=)[^&]*"), "$1")) {
    const long long seconds = std::max<long long>(1, (patience.count() + 999) / 1000);
    guarded([&] {
      const std::string time =
          fmt::format("{}connect_timeout={}", url.find('?') == std::string::npos ? "?" : "&", seconds);
      connection_ = std::make_unique<pqxx::connection>(url + time);
      pqxx::nontransaction settings(*connection_);
      settings.exec(fmt::format("SET search_path TO {}", schema_name));
      settings.exec(fmt::format("SET lock_timeout TO '{}s'", seconds));
      settings.exec("SET client_min_messages TO error");
    });
  }

  const std::string& place() const override { return place_; }

  bool has_table(const std::string& name) override {
    bool found = false;
    read("SELECT tablename FROM pg_catalog.pg_tables WHERE schemaname = $1 AND tablename = $2",
         {std::string(schema_name), name}, [&](SqlRow) { found = true; });
    return found;
  }

  void claim() override { change(fmt::format("CREATE SCHEMA IF NOT EXISTS {}", schema_name), {}); }

  std::int64_t change(const std::string& sql, const std::vector<SqlValue>& values) override {
    return static_cast<std::int64_t>(perform(sql, values).affected_rows());
  }

  void read(const std::string& sql, const std::vector<SqlValue>& values,
            const std::function<void(SqlRow)>& take) override {
    const pqxx::result result = perform(sql, values);
    std::vector<std::string_view> row(result.columns());
    for (const pqxx::row& each : result) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        const pqxx::field field = each[static_cast<pqxx::row::size_type>(i)];
        row[i] = field.is_null() ? std::string_view() : std::string_view(field.c_str(), field.size());
      }
      take(row);
    }
  }

  void begin() override {
    guarded([&] {
      change_ = std::make_unique<pqxx::work>(*connection_);
      change_->exec(fmt::format("SELECT pg_advisory_xact_lock({})", lock_number));
    });
  }
  void commit() override {
    guarded([&] { change_->commit(); });
    change_.reset();
  }
  void roll_back() noexcept override { change_.reset(); }
  // The server reuses the space of deleted rows after its own cleaning; this requests it now.
  void wipe() override {
    guarded([&] {
      pqxx::nontransaction now(*connection_);
      now.exec("VACUUM FULL attempts");
      now.exec("VACUUM FULL trainees");
    });
  }

 private:
  pqxx::result perform(const std::string& sql, const std::vector<SqlValue>& values) {
    return guarded([&] {
      std::vector<const char*> texts;
      for (const SqlValue& value : values) texts.push_back(value ? value->c_str() : nullptr);
      const auto given = pqxx::prepare::make_dynamic_params(texts.begin(), texts.end());
      if (change_ != nullptr) return change_->exec_params(sql, given);
      pqxx::nontransaction alone(*connection_);
      return alone.exec_params(sql, given);
    });
  }

  template <typename Work>
  std::invoke_result_t<Work> guarded(Work&& work) {
    try {
      return work();
    } catch (const pqxx::broken_connection& error) {
      change_.reset();
      throw StoreUnreachable(fmt::format("the store {} cannot be reached: {}", place_, first_line(error.what())));
    } catch (const pqxx::in_doubt_error&) {
      change_.reset();
      throw StoreUnreachable(fmt::format(
          "the store {} disconnected while it saved; adding again is safe, because nothing is kept twice", place_));
    } catch (const pqxx::sql_error& error) {
      throw_sentence(error);
    } catch (const pqxx::failure& error) {
      throw SystemError(fmt::format("the store {}: {}", place_, first_line(error.what())));
    }
  }

  [[noreturn]] void throw_sentence(const pqxx::sql_error& error) const {
    const std::string& code = error.sqlstate();
    if (code == "55P03") {
      throw SystemError(
          fmt::format("the store {} is locked by another station; nothing was changed: try again", place_));
    }
    if (code == "53100") {
      throw SystemError(fmt::format(
          "the disk of the store {} is full; nothing was changed: free space there and try again", place_));
    }
    if (code == "42501") {
      throw SystemError(fmt::format("the store {} does not let this user write: {}; its owner can GRANT that", place_,
                                    first_line(error.what())));
    }
    if (code.starts_with("57P"))
      throw StoreUnreachable(fmt::format("the store {} is being stopped; nothing was changed", place_));
    throw SystemError(fmt::format("the store {}: {}", place_, first_line(error.what())));
  }

  std::string place_;
  std::unique_ptr<pqxx::connection> connection_;
  std::unique_ptr<pqxx::work> change_;
};

}  // namespace

std::unique_ptr<SqlConnection> connect_postgresql(const std::string& url, std::chrono::milliseconds patience) {
  return std::make_unique<PostgresqlConnection>(url, patience);
}

}  // namespace bodkin::training
