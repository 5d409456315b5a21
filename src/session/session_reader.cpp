#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <system_error>

#include "session/body_table.h"
#include "session/change_table.h"
#include "session/left_needles.h"
#include "session/scan_table.h"
#include "session/second_table.h"
#include "session/session_end.h"
#include "session/session_file.h"
#include "session/session_schema.h"
#include "session/tick_codec.h"
#include "session/volume_table.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include "core/error.h"
#include "io/case_xml.h"
#include "io/haptics_xml.h"
#include "io/probe_library_file.h"
#include "io/xml_document.h"

namespace bodkin::session {

namespace {

namespace fs = std::filesystem;

constexpr int longest_value = 64 << 20;  // bytes of one cell; case.xml is the largest
constexpr int patience = 2'000'000;      // thousands of steps of the database engine
constexpr int busy_timeout = 3000;       // ms, for a session that is still being written
constexpr std::uint64_t last_tick = std::uint64_t{1} << 53;
constexpr std::size_t most_header_rows = 64;

// Keys written at the end of a session, which the header's checksum cannot cover.
bool is_written_last(const std::string& key) {
  return key == "checksum" || key == "finished_after_ticks" || key == "second_samples" || key == "scan_samples";
}

class Reader {
 public:
  explicit Reader(const fs::path& file) : file_(file) { check_first_bytes(); }

  Session read();
  bool read_finished();

 private:
  [[noreturn]] void fail(const std::string& fault) const { refuse_session(file_.string(), fault); }
  void check_first_bytes();
  static void restrict_database(SQLite::Database& database);
  void check_schema(SQLite::Database& database) const;
  void read_header(SQLite::Database& database, Session& session);
  void read_chunks(SQLite::Database& database, Session& session) const;
  void read_chunk(std::uint64_t first_tick, std::uint32_t ticks, std::uint32_t events,
                  std::span<const std::uint8_t> data, Session& session) const;
  std::vector<RecordedDiagnostic> diagnostics_of_header() const;
  void read_diagnostics(SQLite::Database& database, Session& session) const;
  void read_hands(SQLite::Database& database, Session& session) const;
  void read_timings(SQLite::Database& database, Session& session) const;
  // A required text of the header.
  const std::string& text(const std::string& key) const;
  template <typename Number>
  Number number(const std::string& key) const;
  Vec3 point(const std::string& key) const;

  fs::path file_;
  int version_ = 0;  // of the format
  std::map<std::string, std::string> header_;
};

std::uint32_t big_endian(const unsigned char* bytes) {
  return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 | bytes[3];
}

// SQLite's own header: the signature, then at 60 the user version and at 68 the application id, both big-endian.
void Reader::check_first_bytes() {
  std::error_code error;
  if (!fs::exists(file_, error)) fail("there is no such file");
  if (!fs::is_regular_file(file_, error)) fail("this is not a file");
  std::array<char, 100> bytes{};
  std::ifstream stream(file_, std::ios::binary);
  if (!stream) fail("the file cannot be read");
  stream.read(bytes.data(), bytes.size());
  const std::string_view signature("SQLite format 3\0", 16);
  if (stream.gcount() != bytes.size() || std::string_view(bytes.data(), 16) != signature)
    fail("this is not a session file");
  std::array<unsigned char, 100> raw{};
  for (std::size_t position = 0; position < raw.size(); ++position)
    raw[position] = static_cast<unsigned char>(bytes[position]);
  if (big_endian(&raw[68]) != static_cast<std::uint32_t>(session_schema::application_id)) {
    fail("this is a database of another program, not a session");
  }
  // Without a write-ahead log the file must have the stated length; with one, the rest may still be in the log.
  const std::uint64_t page = raw[16] == 0 && raw[17] == 1 ? 65536 : std::uint64_t{raw[16]} << 8 | raw[17];
  const bool has_log =
      fs::exists(file_.string() + "-wal", error) && fs::file_size(file_.string() + "-wal", error) > 0;
  if (!has_log && fs::file_size(file_, error) < page * big_endian(&raw[28])) fail("the end of the file is missing");
  const std::uint32_t version = big_endian(&raw[60]);
  if (version < static_cast<std::uint32_t>(session_schema::oldest_version) ||
      version > static_cast<std::uint32_t>(session_schema::version)) {
    throw InputError(
        fmt::format("{}: the session has format version {}, this Bodkin reads versions {} to {}; open it with the "
                    "version of Bodkin that wrote it",
                    file_.string(), version, session_schema::oldest_version, session_schema::version));
  }
  version_ = static_cast<int>(version);
}

// The file may come from anywhere: nothing in it may be executed or take for ever.
void Reader::restrict_database(SQLite::Database& database) {
  sqlite3* handle = database.getHandle();
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, longest_value);
  sqlite3_limit(handle, SQLITE_LIMIT_ATTACHED, 0);
  sqlite3_progress_handler(
      handle, 1000,
      [](void* steps) {
        int& count = *static_cast<int*>(steps);
        return ++count > patience ? 1 : 0;
      },
      [] {
        thread_local int steps = 0;
        steps = 0;
        return &steps;
      }());
  database.exec("PRAGMA cell_size_check=ON");
  database.exec("PRAGMA mmap_size=0");
}

// Exactly the tables that a writer makes, word for word: no view, trigger, index or generated column can hide there.
void Reader::check_schema(SQLite::Database& database) const {
  std::map<std::string, std::string> expected;
  for (const auto& table : session_schema::tables) expected[table.name] = table.sql;
  if (version_ < session_schema::with_diagnostics) expected.erase("diagnostics");
  if (version_ < session_schema::with_scans) {
    expected.erase("scans");
    expected.erase("scanned");
  }
  if (version_ < session_schema::with_volumes) expected.erase("volumes");
  const std::string changes = session_schema::changes.name;
  expected[changes] = session_schema::changes.sql;
  for (const auto& table : session_schema::moving_body) expected[table.name] = table.sql;
  SQLite::Statement query(database, "SELECT type, name, sql FROM sqlite_schema");
  while (query.executeStep()) {
    const std::string type = query.getColumn(0).getString();
    const std::string name = query.getColumn(1).getString();
    const auto found = expected.find(name);
    if (type != "table" || found == expected.end() || query.getColumn(2).getString() != found->second) {
      fail("the tables in the file are not those of a session");
    }
    expected.erase(found);
  }
  expected.erase(changes);  // a session without changes has none
  for (const auto& table : session_schema::moving_body) expected.erase(table.name);
  if (!expected.empty()) fail(fmt::format("the table '{}' is missing", expected.begin()->first));
}

const std::string& Reader::text(const std::string& key) const {
  const auto found = header_.find(key);
  if (found == header_.end()) fail(fmt::format("the header lacks '{}'", key));
  return found->second;
}

template <typename Number>
Number Reader::number(const std::string& key) const {
  const std::string& digits = text(key);
  Number value{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) {
    fail(fmt::format("'{}' of the header is not a number", key));
  }
  return value;
}

Vec3 Reader::point(const std::string& key) const {
  const std::string& digits = text(key);
  const char* cursor = digits.data();
  const char* last = digits.data() + digits.size();
  Vec3 value;
  for (int axis = 0; axis < 3; ++axis) {
    while (cursor != last && *cursor == ' ') ++cursor;
    const auto [end, error] = std::from_chars(cursor, last, value[axis]);
    if (error != std::errc() || !std::isfinite(value[axis]))
      fail(fmt::format("'{}' of the header is not a point", key));
    cursor = end;
  }
  return value;
}

void Reader::read_header(SQLite::Database& database, Session& session) {
  SQLite::Statement rows(database, "SELECT key, value FROM header ORDER BY key");
  std::string all;
  while (rows.executeStep()) {
    if (header_.size() >= most_header_rows) fail("the header has too many entries");
    header_[rows.getColumn(0).getString()] = rows.getColumn(1).getString();
  }
  for (const auto& [key, value] : header_) {
    if (!is_written_last(key)) all += key + '\n' + value + '\n';
  }
  SessionHeader& header = session.header;
  SQLite::Statement tissues(database, "SELECT id, name, title FROM tissues ORDER BY id");
  while (tissues.executeStep()) {
    const std::int64_t id = tissues.getColumn(0).getInt64();
    const bool in_order = header.tissues.empty() || header.tissues.back().id < id;
    if (id < 0 || id > 254 || !in_order) fail("the list of tissues is damaged");
    header.tissues.push_back(
        {static_cast<anatomy::TissueId>(id), tissues.getColumn(1).getString(), tissues.getColumn(2).getString()});
    all += fmt::format("{}\n{}\n{}\n", id, header.tissues.back().name, header.tissues.back().title);
  }
  if (text("checksum") != text_checksum(all)) fail("the header is damaged, its checksum does not fit");
  header.bodkin_version = text("bodkin_version");
  header.case_folder = text("case_folder");
  header.case_digest = text("case_digest");
  header.case_xml = text("case_xml");
  header.operator_name = text("operator_name");
  header.operator_settings = text("operator_settings");
  header.seed = number<std::uint64_t>("seed");
  header.dt = number<double>("dt_s");
  header.started_at = text("started_at");
  if (header_.contains("recording_id")) header.recording_id = text("recording_id");
  header.path = {point("entry_mm"), point("target_mm")};
  if (!(header.dt > 1e-5 && header.dt < 1.0)) fail(fmt::format("a tick of {} s is out of range", header.dt));
  header.haptics = io::parse_haptics_xml(
      text("haptics_xml"), fmt::format("{}: haptics_xml of the header", file_.string()), io::XmlSchema("case.xsd"));
  if (header_.contains("device_xml")) {
    header.device = io::parse_device_xml(
        text("device_xml"), fmt::format("{}: device_xml of the header", file_.string()), io::XmlSchema("case.xsd"));
  }
  if (header_.contains("second_role")) {
    const std::optional<SecondRole> role = second_role(text("second_role"));
    if (!role) fail(fmt::format("the second hand is a '{}', expected plunger or probe", text("second_role")));
    header.second = SecondHeader{*role, text("second_device")};
  }
  if (version_ >= session_schema::with_scans && header_.contains("ultrasound_xml")) {
    const std::vector<anatomy::UltrasoundProbe> probes =
        io::parse_probes(text("ultrasound_xml"), fmt::format("{}: ultrasound_xml of the header", file_.string()));
    header.ultrasound = probes.front();
  }
  if (header_.contains("moving_body")) header.moving_body = text("moving_body");
  if (header_.contains("left_needles_mm")) {
    const auto left = parse_left_needles(text("left_needles_mm"));
    if (!left) fail("the header's list of needles that were left in the body is damaged");
    header.left_needles = *left;
  }
  if (header_.contains("body_digest")) header.body_digest = text("body_digest");
  if (header_.contains("body_points")) header.body_points = text("body_points");
  if (header_.contains("case_parts")) header.case_parts = text("case_parts");
  if (version_ >= session_schema::with_diagnostics && header_.contains("diagnostics"))
    header.diagnostics = diagnostics_of_header();
  session.version = version_;
  session.finished = header_.contains("finished_after_ticks");
}

std::vector<RecordedDiagnostic> Reader::diagnostics_of_header() const {
  std::vector<RecordedDiagnostic> all;
  std::istringstream lines(text("diagnostics"));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t blank = line.find(' ');
    if (blank == 0 || blank == std::string::npos || all.size() == forces::most_diagnostics)
      fail("the header's list of diagnostics is damaged");
    all.push_back({line.substr(0, blank), line.substr(blank + 1)});
  }
  return all;
}

void Reader::read_diagnostics(SQLite::Database& database, Session& session) const {
  const std::size_t count = session.header.diagnostics.size();
  if (count == 0) return;
  SQLite::Statement query(database, "SELECT first_tick, ticks, checksum, data FROM diagnostics ORDER BY first_tick");
  auto record = session.ticks.begin();
  while (query.executeStep()) {
    const std::int64_t first = query.getColumn(0).getInt64();
    const std::int64_t ticks = query.getColumn(1).getInt64();
    const SQLite::Column data = query.getColumn(3);
    const auto size = static_cast<std::size_t>(data.getBytes());
    const bool sound = ticks >= 1 && ticks <= session_schema::most_ticks_of_a_chunk &&
                       session.ticks.end() - record >= ticks && first == static_cast<std::int64_t>(record->tick) &&
                       size == static_cast<std::size_t>(ticks) * count * 8;
    if (!sound) fail(fmt::format("the diagnostics at tick {} do not fit the ticks", first));
    const std::span<const std::uint8_t> bytes(static_cast<const std::uint8_t*>(data.getBlob()), size);
    if (query.getColumn(2).getInt64() != chunk_checksum(record->tick, static_cast<std::uint32_t>(ticks), 0, bytes)) {
      fail(fmt::format("the diagnostics at tick {} are damaged, their checksum does not fit", first));
    }
    for (std::int64_t tick = 0; tick < ticks; ++tick, ++record)
      decode_diagnostics(bytes.subspan(static_cast<std::size_t>(tick) * count * 8, count * 8), count, *record);
  }
  if (record != session.ticks.end()) fail(fmt::format("the diagnostics from tick {} on are missing", record->tick));
}

void Reader::read_chunks(SQLite::Database& database, Session& session) const {
  SQLite::Statement query(database,
                          "SELECT first_tick, ticks, events, checksum, data FROM chunks ORDER BY first_tick");
  // Most of the file is ticks, and a session of minutes has hundreds of thousands.
  std::error_code unknown;
  const std::uintmax_t bytes_of_file = std::filesystem::file_size(file_, unknown);
  if (!unknown) session.ticks.reserve(static_cast<std::size_t>(bytes_of_file) / encoded_tick_size());
  std::uint64_t next = 0;
  while (query.executeStep()) {
    const std::int64_t first = query.getColumn(0).getInt64();
    const std::int64_t ticks = query.getColumn(1).getInt64();
    const std::int64_t events = query.getColumn(2).getInt64();
    const SQLite::Column data = query.getColumn(4);
    const auto size = static_cast<std::size_t>(data.getBytes());
    if (first < 0 || static_cast<std::uint64_t>(first) < next || static_cast<std::uint64_t>(first) > last_tick) {
      fail("the chunks are not in order");
    }
    if (ticks < 1 || ticks > session_schema::most_ticks_of_a_chunk || events < 0 ||
        events > ticks * static_cast<std::int64_t>(forces::TickEvents::capacity) ||
        size != static_cast<std::size_t>(ticks) * encoded_tick_size() +
                    static_cast<std::size_t>(events) * encoded_event_size) {
      fail(fmt::format("the chunk at tick {} has the wrong size", first));
    }
    const std::span<const std::uint8_t> bytes(static_cast<const std::uint8_t*>(data.getBlob()), size);
    const auto tick_count = static_cast<std::uint32_t>(ticks);
    const auto event_count = static_cast<std::uint32_t>(events);
    const auto first_tick = static_cast<std::uint64_t>(first);
    if (query.getColumn(3).getInt64() != chunk_checksum(first_tick, tick_count, event_count, bytes)) {
      fail(fmt::format("the chunk at tick {} is damaged, its checksum does not fit", first));
    }
    read_chunk(first_tick, tick_count, event_count, bytes, session);
    next = first_tick + tick_count;
  }
}

void Reader::read_chunk(std::uint64_t first_tick, std::uint32_t ticks, std::uint32_t events,
                        std::span<const std::uint8_t> data, Session& session) const {
  const std::size_t tick_size = encoded_tick_size();
  for (std::uint32_t tick = 0; tick < ticks; ++tick) {
    simulation::TickRecord& record = session.ticks.emplace_back();
    record.tick = first_tick + tick;
    if (!decode_tick(data.subspan(tick * tick_size, tick_size), record)) {
      fail(fmt::format("tick {} holds an invalid value", record.tick));
    }
  }
  std::span<const std::uint8_t> rest = data.subspan(ticks * tick_size);
  std::uint32_t earlier = 0;
  for (std::uint32_t event = 0; event < events; ++event, rest = rest.subspan(encoded_event_size)) {
    SessionEvent& found = session.events.emplace_back();
    std::uint32_t tick_of_chunk = 0;
    const bool valid = decode_event(rest.first(encoded_event_size), tick_of_chunk, found.event);
    if (!valid || tick_of_chunk >= ticks || tick_of_chunk < earlier) {
      fail(fmt::format("an event of the chunk at tick {} is invalid", first_tick));
    }
    earlier = tick_of_chunk;
    found.tick = first_tick + tick_of_chunk;
  }
}

void Reader::read_hands(SQLite::Database& database, Session& session) const {
  const std::string file = file_.string();
  session.second = read_second_hand(database, file, session.header.second);
  if (session.header.second && session.finished && number<std::uint64_t>("second_samples") != session.second.size())
    fail("samples of the second hand are missing from a session that was finished");
  if (version_ < session_schema::with_scans) return;
  const anatomy::UltrasoundProbe* const probe = session.header.ultrasound ? &*session.header.ultrasound : nullptr;
  session.scans = read_scans(database, file, probe);
  session.scanned = read_scanned(database, file, probe);
  if (probe != nullptr && session.finished && number<std::uint64_t>("scan_samples") != session.scans.size())
    fail("samples of the ultrasound probe are missing from a session that was finished");
}

void Reader::read_timings(SQLite::Database& database, Session& session) const {
  SQLite::Statement query(database, "SELECT what, up_to_s, count FROM timings ORDER BY what, up_to_s");
  SessionTimings timings;
  bool any = false;
  for (std::size_t rows = 0; query.executeStep(); ++rows) {
    const std::string what = query.getColumn(0).getString();
    const double up_to = query.getColumn(1).getDouble();
    const std::int64_t count = query.getColumn(2).getInt64();
    const bool known = what == "lateness" || what == "compute" || what == "overruns";
    if (!known || rows > 2 * haptics::LatencyHistogram::bins || !(up_to >= 0.0) || !std::isfinite(up_to) ||
        count < 0 || static_cast<std::uint64_t>(count) > last_tick) {
      fail("the timings are damaged");
    }
    any = true;
    if (what == "overruns") {
      timings.overruns = static_cast<std::uint64_t>(count);
    } else {
      (what == "lateness" ? timings.lateness : timings.compute).push_back({up_to, static_cast<std::uint64_t>(count)});
    }
  }
  if (any) session.timings = std::move(timings);
}

Session Reader::read() {
  Session session;
  try {
    SQLite::Database database(file_.string(), SQLite::OPEN_READONLY, busy_timeout);
    restrict_database(database);
    // One transaction: a consistent snapshot of a session that is still being written.
    SQLite::Transaction moment(database);
    check_schema(database);
    read_header(database, session);
    read_chunks(database, session);
    if (version_ >= session_schema::with_diagnostics) read_diagnostics(database, session);
    read_hands(database, session);
    if (version_ >= session_schema::with_volumes) session.header.volumes = read_volumes(database, file_.string());
    session.changes = read_changes(database, file_.string());
    session.body_steps = read_body_steps(database, file_.string());
    session.applied_body_steps = read_applied_body_steps(database, file_.string());
    read_timings(database, session);
  } catch (const SQLite::Exception& error) {
    fail(fmt::format("the file is damaged ({})", error.what()));
  }
  if (session.finished && number<std::uint64_t>("finished_after_ticks") != session.ticks.size()) {
    fail("ticks are missing from a session that was finished");
  }
  return session;
}

bool Reader::read_finished() {
  try {
    SQLite::Database database(file_.string(), SQLite::OPEN_READONLY, busy_timeout);
    restrict_database(database);
    check_schema(database);
    SQLite::Statement query(database, "SELECT count(*) FROM header WHERE key = 'finished_after_ticks'");
    return query.executeStep() && query.getColumn(0).getInt() == 1;
  } catch (const SQLite::Exception& error) {
    fail(fmt::format("the file is damaged ({})", error.what()));
  }
}

}  // namespace

bool is_finished(const std::filesystem::path& file) {
  return Reader(file).read_finished();
}

Session read_session(const std::filesystem::path& file) {
  return Reader(file).read();
}

}  // namespace bodkin::session
