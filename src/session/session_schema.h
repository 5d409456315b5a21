#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace bodkin::session {

// The schema of a session file, version 5; docs/session-format.md explains it.
namespace session_schema {

inline constexpr std::int32_t application_id = 0x42444B4E;  // "BDKN"
inline constexpr std::int32_t version = 5;
inline constexpr std::int32_t oldest_version = 2;
inline constexpr std::int32_t with_diagnostics = 3;  // the first one with the table `diagnostics`
inline constexpr std::int32_t with_scans = 4;        // the first one with `scans` and `scanned`
inline constexpr std::int32_t with_volumes = 5;      // the first one with `volumes`

struct Table {
  const char* name;
  const char* sql;
};

// All of them are authoritative except `events`, which repeats the events of the chunks for SQL queries.
inline constexpr std::array<Table, 10> tables = {{
    {"header", "CREATE TABLE header(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID"},
    {"tissues", "CREATE TABLE tissues(id INTEGER PRIMARY KEY, name TEXT NOT NULL, title TEXT NOT NULL)"},
    {"chunks",
     "CREATE TABLE chunks(first_tick INTEGER PRIMARY KEY, ticks INTEGER NOT NULL, events INTEGER NOT NULL, "
     "checksum INTEGER NOT NULL, data BLOB NOT NULL)"},
    {"events",
     "CREATE TABLE events(tick INTEGER NOT NULL, kind TEXT NOT NULL, tissue INTEGER NOT NULL, depth_mm REAL, value "
     "REAL)"},
    {"second_hand",
     "CREATE TABLE second_hand(sample INTEGER PRIMARY KEY, time_s REAL NOT NULL, x_mm REAL NOT NULL, y_mm REAL NOT "
     "NULL, z_mm REAL NOT NULL, qw REAL NOT NULL, qx REAL NOT NULL, qy REAL NOT NULL, qz REAL NOT NULL, force_N REAL "
     "NOT NULL, pressure_MPa REAL, volume_mm3 REAL)"},
    {"scans",
     "CREATE TABLE scans(sample INTEGER PRIMARY KEY, time_s REAL NOT NULL, x_mm REAL NOT NULL, y_mm REAL NOT NULL, "
     "z_mm "
     "REAL NOT NULL, qw REAL NOT NULL, qx REAL NOT NULL, qy REAL NOT NULL, qz REAL NOT NULL, depth_mm REAL NOT NULL, "
     "gain_dB REAL NOT NULL, dynamic_range_dB REAL NOT NULL, focus_mm REAL NOT NULL, frequency_MHz REAL NOT NULL, "
     "slider_1_dB REAL NOT NULL, slider_2_dB REAL NOT NULL, slider_3_dB REAL NOT NULL, slider_4_dB REAL NOT NULL, "
     "slider_5_dB REAL NOT NULL, slider_6_dB REAL NOT NULL, slider_7_dB REAL NOT NULL, slider_8_dB REAL NOT NULL, "
     "gel "
     "INTEGER NOT NULL)"},
    {"scanned",
     "CREATE TABLE scanned(is_structure INTEGER NOT NULL, name TEXT NOT NULL, first_s REAL NOT NULL, PRIMARY "
     "KEY(is_structure, name)) WITHOUT ROWID"},
    {"diagnostics",
     "CREATE TABLE diagnostics(first_tick INTEGER PRIMARY KEY, ticks INTEGER NOT NULL, checksum INTEGER NOT NULL, "
     "data BLOB NOT NULL)"},
    {"volumes",
     "CREATE TABLE volumes(name TEXT PRIMARY KEY, checksum INTEGER NOT NULL, nrrd BLOB NOT NULL) WITHOUT ROWID"},
    {"timings", "CREATE TABLE timings(what TEXT NOT NULL, up_to_s REAL NOT NULL, count INTEGER NOT NULL)"},
}};

// Only in a session whose numbers were changed while it ran.
inline constexpr Table changes = {
    "changes",
    "CREATE TABLE changes(tick INTEGER PRIMARY KEY, from_tick INTEGER NOT NULL, haptics TEXT NOT NULL, tissues TEXT "
    "NOT NULL, checksum INTEGER NOT NULL)"};

// Only in a session whose body moved on its own.
inline constexpr std::array<Table, 2> moving_body = {{
    {"body_steps",
     "CREATE TABLE body_steps(step INTEGER PRIMARY KEY, probe BLOB, digest INTEGER NOT NULL, checksum INTEGER NOT "
     "NULL)"},
    {"body_taken",
     "CREATE TABLE body_taken(number INTEGER PRIMARY KEY, tick INTEGER NOT NULL, step INTEGER NOT NULL, checksum "
     "INTEGER NOT NULL)"},
}};

inline constexpr std::uint32_t most_changes = 10'000;
inline constexpr std::uint32_t most_ticks_of_a_chunk = 4096;
inline constexpr std::uint64_t most_second_samples = 1'000'000;  // almost three hours; of a second hand or a probe

}  // namespace session_schema

// Limits that no tool in a hand exceeds.
inline constexpr double last_time = 1e6;        // s
inline constexpr double furthest = 1e5;         // mm
inline constexpr double unit_tolerance = 1e-6;  // of a rotation's length

// Throws the InputError about an invalid or damaged session file: `fault` gives the reason.
[[noreturn]] void refuse_session(const std::string& file, const std::string& fault);

// XXH3 (64 bits) over the place and the content of a chunk, as SQLite stores integers.
std::int64_t chunk_checksum(std::uint64_t first_tick, std::uint32_t ticks, std::uint32_t events,
                            std::span<const std::uint8_t> data);

// XXH3 (64 bits) of any bytes, as SQLite stores integers.
std::int64_t data_checksum(std::span<const std::uint8_t> data);

// XXH3 (64 bits) of a text, as 16 hexadecimal digits.
std::string text_checksum(const std::string& text);

}  // namespace bodkin::session
