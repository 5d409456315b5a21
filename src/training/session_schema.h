#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace bodkin {

// The shape of a session file, version 1; docs/session-format.md explains it to people.
namespace session_schema {

inline constexpr std::int32_t application_id = 0x42444B4E;  // "BDKN"
inline constexpr std::int32_t version = 1;

struct Table {
  const char* name;
  const char* sql;
};

// The authority is `header`, `tissues` and `chunks`; `events` repeats the events of the chunks for those who ask in
// SQL.
inline constexpr std::array<Table, 4> tables = {{
    {"header", "CREATE TABLE header(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID"},
    {"tissues", "CREATE TABLE tissues(id INTEGER PRIMARY KEY, name TEXT NOT NULL, title TEXT NOT NULL)"},
    {"chunks",
     "CREATE TABLE chunks(first_tick INTEGER PRIMARY KEY, ticks INTEGER NOT NULL, events INTEGER NOT NULL, "
     "checksum INTEGER NOT NULL, data BLOB NOT NULL)"},
    {"events",
     "CREATE TABLE events(tick INTEGER NOT NULL, kind TEXT NOT NULL, tissue INTEGER NOT NULL, depth_mm REAL, value "
     "REAL)"},
}};

inline constexpr std::uint32_t most_ticks_of_a_chunk = 4096;

}  // namespace session_schema

// XXH3 (64 bits) over the place and the content of a chunk, as SQLite stores integers.
std::int64_t chunk_checksum(std::uint64_t first_tick, std::uint32_t ticks, std::uint32_t events,
                            std::span<const std::uint8_t> data);

// XXH3 (64 bits) of a text, as 16 hexadecimal digits.
std::string text_checksum(const std::string& text);

}  // namespace bodkin
