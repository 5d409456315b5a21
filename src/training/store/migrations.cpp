#include "training/store/migrations.h"

#include <array>
#include <charconv>

#include <fmt/format.h>

namespace bodkin::training {

namespace {

constexpr const char* first_tables[] = {
    "CREATE TABLE trainees(label TEXT PRIMARY KEY, added_at TEXT NOT NULL)",
    "CREATE TABLE attempts(digest TEXT PRIMARY KEY, trainee TEXT NOT NULL REFERENCES trainees(label), "
    "procedure_name TEXT NOT NULL, patient TEXT NOT NULL, station TEXT NOT NULL, started_at TEXT NOT NULL, "
    "duration_s DOUBLE PRECISION NOT NULL, verdict TEXT NOT NULL, reached INTEGER NOT NULL, "
    "score DOUBLE PRECISION NOT NULL, headline TEXT NOT NULL, metrics TEXT NOT NULL, findings TEXT NOT NULL, "
    "file TEXT NOT NULL, owns_file INTEGER NOT NULL)",
    // Contains all columns of a cohort table, so that the long rows need not be read.
    "CREATE INDEX attempts_of_trainees ON attempts(trainee, procedure_name, started_at, digest, verdict, score)",
};

constexpr const char* plans[] = {
    "CREATE TABLE plans(name TEXT PRIMARY KEY, title TEXT NOT NULL, document TEXT NOT NULL)",
    "ALTER TABLE attempts ADD COLUMN plan TEXT NOT NULL DEFAULT ''",
    "ALTER TABLE attempts ADD COLUMN stage INTEGER NOT NULL DEFAULT 0",
    "CREATE INDEX attempts_of_plans ON attempts(plan, trainee, stage, started_at, digest, verdict, score)",
};

constexpr std::array<Migration, 2> all_migrations = {Migration(first_tables), Migration(plans)};

}  // namespace

std::span<const Migration> migrations() {
  return all_migrations;
}

int newest_store_version() {
  return static_cast<int>(all_migrations.size());
}

int store_version(SqlConnection& connection) {
  int version = 0;
  if (!connection.has_table("store_version")) return version;
  connection.read("SELECT version FROM store_version", {},
                  [&](SqlRow row) { std::from_chars(row[0].data(), row[0].data() + row[0].size(), version); });
  return version;
}

void migrate(SqlConnection& connection, int wanted) {
  const auto refuse_newer = [&](int version) {
    if (version <= newest_store_version()) return;
    throw InputError(fmt::format(
        "the store {} has version {}, made by a newer Bodkin, and this one knows up to {}; update Bodkin here",
        connection.place(), version, newest_store_version()));
  };
  const int seen = store_version(connection);
  refuse_newer(seen);
  if (seen >= wanted) return;
  in_one_change(connection, [&] {
    // Another station may have been faster.
    const int version = store_version(connection);
    refuse_newer(version);
    if (version == 0) {
      connection.claim();
      connection.change("CREATE TABLE store_version(version INTEGER NOT NULL)");
      connection.change("INSERT INTO store_version VALUES(0)");
    }
    for (int next = version; next < wanted; ++next)
      for (const char* statement : all_migrations[static_cast<std::size_t>(next)]) connection.change(statement);
    if (version < wanted) connection.change("UPDATE store_version SET version = $1", {std::to_string(wanted)});
  });
}

}  // namespace bodkin::training
