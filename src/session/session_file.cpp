#include "session/session_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "session/body_table.h"
#include "session/change_table.h"
#include "session/left_needles.h"
#include "session/scan_table.h"
#include "session/session_schema.h"
#include "session/tick_codec.h"
#include "session/volume_table.h"
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "core/error.h"
#include "io/case_xml.h"
#include "io/haptics_xml.h"
#include "io/probe_library_file.h"

namespace bodkin::session {

namespace {

namespace fs = std::filesystem;

constexpr double chunk_time = 0.25;      // s of simulated time in a chunk
constexpr int page_size = 4096;          // bytes
constexpr int checkpoint_pages = 16384;  // 64 MiB of log before SQLite tidies up

std::string point_text(const Vec3& point) {
  return fmt::format("{} {} {}", point.x(), point.y(), point.z());
}

// A line for each: name, blank, title.
std::string lines_of(const std::vector<RecordedDiagnostic>& diagnostics) {
  std::string text;
  for (const RecordedDiagnostic& one : diagnostics) text += one.name + ' ' + one.title + '\n';
  return text;
}

std::vector<std::pair<std::string, std::string>> header_rows(const SessionHeader& header) {
  std::vector<std::pair<std::string, std::string>> rows = {{"bodkin_version", header.bodkin_version},
                                                           {"case_digest", header.case_digest},
                                                           {"case_folder", header.case_folder},
                                                           {"case_xml", header.case_xml},
                                                           {"dt_s", fmt::format("{}", header.dt)},
                                                           {"entry_mm", point_text(header.path.entry)},
                                                           {"haptics_xml", io::haptics_xml(header.haptics)},
                                                           {"operator_name", header.operator_name},
                                                           {"operator_settings", header.operator_settings},
                                                           {"seed", fmt::format("{}", header.seed)},
                                                           {"started_at", header.started_at},
                                                           {"target_mm", point_text(header.path.target)}};
  if (header.device) rows.emplace_back("device_xml", io::device_xml(*header.device));
  if (header.second) {
    rows.emplace_back("second_device", header.second->device);
    rows.emplace_back("second_role", name_of(header.second->role));
  }
  if (header.ultrasound) rows.emplace_back("ultrasound_xml", io::probes_xml({&*header.ultrasound, 1}));
  if (!header.moving_body.empty()) rows.emplace_back("moving_body", header.moving_body);
  if (!header.left_needles.empty()) rows.emplace_back("left_needles_mm", left_needles_text(header.left_needles));
  if (!header.body_digest.empty()) rows.emplace_back("body_digest", header.body_digest);
  if (!header.case_parts.empty()) rows.emplace_back("case_parts", header.case_parts);
  if (!header.body_points.empty()) rows.emplace_back("body_points", header.body_points);
  if (!header.recording_id.empty()) rows.emplace_back("recording_id", header.recording_id);
  if (!header.diagnostics.empty()) rows.emplace_back("diagnostics", lines_of(header.diagnostics));
  // In the order of the keys, as in the checksum.
  std::sort(rows.begin(), rows.end());
  return rows;
}

// SQLite's files of a database; its log is found by name.
constexpr std::array<const char*, 4> file_endings = {"", "-wal", "-shm", "-journal"};

void remove_session(const fs::path& file) noexcept {
  std::error_code ignored;
  for (const char* ending : file_endings) fs::remove(file.string() + ending, ignored);
}

// Throws fs::filesystem_error when the file itself cannot be renamed.
void rename_session(const fs::path& from, const fs::path& to) {
  remove_session(to);
  fs::rename(from, to);
  std::error_code ignored;
  for (std::size_t i = 1; i < file_endings.size(); ++i)
    fs::rename(from.string() + file_endings[i], to.string() + file_endings[i], ignored);
}

// The file of a new session. An older session of that name is renamed until the new one can be read, and gets its
// name back if the new one could not be created.
class NewSessionFile {
 public:
  NewSessionFile(const fs::path& file, bool exists) : file_(file), aside_(file.string() + ".replaced") {
    if (exists) {
      rename_session(file_, aside_);
      is_aside_ = true;
    }
    remove_session(file_);  // a log without its database would be taken for a part of the new file
  }
  ~NewSessionFile() {
    if (stands_) {
      if (is_aside_) remove_session(aside_);
      return;
    }
    remove_session(file_);
    try {
      if (is_aside_) rename_session(aside_, file_);
    } catch (const fs::filesystem_error&) {
      // The older session keeps its new name: nothing is lost, and a destructor cannot report an error.
    }
  }
  NewSessionFile(const NewSessionFile&) = delete;
  NewSessionFile& operator=(const NewSessionFile&) = delete;

  void keep() noexcept { stands_ = true; }

 private:
  fs::path file_, aside_;
  bool is_aside_ = false, stands_ = false;
};

}  // namespace

struct SessionWriter::Impl {
  Impl(const fs::path& path, const SessionHeader& header);

  void flush();
  void put_chunk();
  void put_samples();
  void put_header(const std::string& key, const std::string& value);
  void put_timings(const SessionTimings& timings);
  // The meaning of a database failure for the person at the terminal.
  [[noreturn]] void fail(const SQLite::Exception& error) const {
    throw SystemError(
        fmt::format("cannot write the session {}: {}; what was recorded until then is safe, free space on its disk "
                    "before you continue",
                    file.string(), error.what()));
  }

  fs::path file;
  SQLite::Database database;
  std::unique_ptr<SQLite::Statement> insert_chunk;
  std::unique_ptr<SQLite::Statement> insert_diagnostics;
  std::unique_ptr<SQLite::Statement> insert_event;
  std::unique_ptr<SQLite::Statement> insert_sample;
  std::unique_ptr<ScanTables> scans;  // null: there is no ultrasound machine
  std::unique_ptr<BodyTables> body;   // null: it did not move by itself
  std::uint32_t chunk_ticks;          // ticks of a full chunk
  std::uint64_t first_tick = 0;       // of the chunk being filled
  std::uint64_t total_ticks = 0;      // written or waiting
  std::uint32_t ticks = 0;            // in the chunk being filled
  std::vector<std::uint8_t> data;
  std::size_t diagnostic_count;  // of a tick
  std::vector<std::uint8_t> diagnostics;
  std::vector<SessionEvent> events;
  bool has_second;
  bool pressure_is_kept = false;      // of a plunger
  std::uint64_t total_samples = 0;    // of the second hand, written
  std::vector<SecondSample> samples;  // waiting
  bool finished = false;
};

SessionWriter::Impl::Impl(const fs::path& path, const SessionHeader& header)
    : file(path),
      database(path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE),
      chunk_ticks(static_cast<std::uint32_t>(
          std::clamp(std::round(chunk_time / header.dt), 1.0, double{session_schema::most_ticks_of_a_chunk}))),
      diagnostic_count(std::min(header.diagnostics.size(), forces::most_diagnostics)),
      has_second(header.second.has_value()) {
  database.exec(fmt::format("PRAGMA page_size={}", page_size));
  database.exec("PRAGMA synchronous=OFF");  // an empty session is not worth waiting for the disk
  {
    SQLite::Transaction transaction(database);
    // In the main file before the log begins, so that a reader recognises the file by its first bytes at any time.
    database.exec(fmt::format("PRAGMA application_id={}", session_schema::application_id));
    database.exec(fmt::format("PRAGMA user_version={}", session_schema::version));
    for (const auto& table : session_schema::tables) database.exec(table.sql);
    std::string all;
    for (const auto& [key, value] : header_rows(header)) {
      put_header(key, value);
      all += key + '\n' + value + '\n';
    }
    SQLite::Statement insert_tissue(database, "INSERT INTO tissues VALUES(?, ?, ?)");
    for (const TissueName& tissue : header.tissues) {
      insert_tissue.bind(1, static_cast<int>(tissue.id));
      insert_tissue.bind(2, tissue.name);
      insert_tissue.bind(3, tissue.title);
      insert_tissue.exec();
      insert_tissue.reset();
      all += fmt::format("{}\n{}\n{}\n", tissue.id, tissue.name, tissue.title);
    }
    put_header("checksum", text_checksum(all));
    put_volumes(database, header.volumes);
    transaction.commit();
  }
  database.exec("PRAGMA journal_mode=WAL");
  database.exec("PRAGMA synchronous=NORMAL");
  database.exec(fmt::format("PRAGMA wal_autocheckpoint={}", checkpoint_pages));
  insert_chunk = std::make_unique<SQLite::Statement>(database, "INSERT INTO chunks VALUES(?, ?, ?, ?, ?)");
  insert_diagnostics = std::make_unique<SQLite::Statement>(database, "INSERT INTO diagnostics VALUES(?, ?, ?, ?)");
  insert_event = std::make_unique<SQLite::Statement>(database, "INSERT INTO events VALUES(?, ?, ?, ?, ?)");
  insert_sample = std::make_unique<SQLite::Statement>(
      database, "INSERT INTO second_hand VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  if (header.ultrasound) scans = std::make_unique<ScanTables>(database);
  if (!header.moving_body.empty()) body = std::make_unique<BodyTables>(database);
  pressure_is_kept = header.second && header.second->role == SecondRole::plunger;
  data.reserve(chunk_ticks * encoded_tick_size() + 1024);
}

void SessionWriter::Impl::put_header(const std::string& key, const std::string& value) {
  SQLite::Statement insert(database, "INSERT INTO header VALUES(?, ?)");
  insert.bind(1, key);
  insert.bind(2, value);
  insert.exec();
}

void SessionWriter::Impl::put_timings(const SessionTimings& timings) {
  SQLite::Transaction transaction(database);
  SQLite::Statement insert(database, "INSERT INTO timings VALUES(?, ?, ?)");
  const auto put = [&insert](const char* what, const TimeBin& bin) {
    insert.bind(1, what);
    insert.bind(2, bin.up_to);
    insert.bind(3, static_cast<std::int64_t>(bin.count));
    insert.exec();
    insert.reset();
  };
  for (const TimeBin& bin : timings.lateness) put("lateness", bin);
  for (const TimeBin& bin : timings.compute) put("compute", bin);
  put("overruns", {0.0, timings.overruns});
  transaction.commit();
}

void SessionWriter::Impl::flush() {
  const bool has_scans = scans != nullptr && !scans->empty();
  const bool has_body = body != nullptr && !body->empty();
  if (ticks == 0 && samples.empty() && !has_scans && !has_body) return;
  SQLite::Transaction transaction(database);
  if (ticks > 0) put_chunk();
  put_samples();
  if (has_scans) scans->put();
  if (has_body) body->put();
  transaction.commit();
  total_samples += samples.size();
  samples.clear();
  ticks = 0;
  data.clear();
  diagnostics.clear();
  events.clear();
}

void SessionWriter::Impl::put_chunk() {
  for (const SessionEvent& event : events) {
    encode_event(static_cast<std::uint32_t>(event.tick - first_tick), event.event, data);
  }
  const auto event_count = static_cast<std::uint32_t>(events.size());
  insert_chunk->reset();
  insert_chunk->bind(1, static_cast<std::int64_t>(first_tick));
  insert_chunk->bind(2, ticks);
  insert_chunk->bind(3, event_count);
  insert_chunk->bind(4, chunk_checksum(first_tick, ticks, event_count, data));
  insert_chunk->bindNoCopy(5, data.data(), static_cast<int>(data.size()));
  insert_chunk->exec();
  if (diagnostic_count > 0) {
    insert_diagnostics->reset();
    insert_diagnostics->bind(1, static_cast<std::int64_t>(first_tick));
    insert_diagnostics->bind(2, ticks);
    insert_diagnostics->bind(3, chunk_checksum(first_tick, ticks, 0, diagnostics));
    insert_diagnostics->bindNoCopy(4, diagnostics.data(), static_cast<int>(diagnostics.size()));
    insert_diagnostics->exec();
  }
  for (const SessionEvent& event : events) {
    insert_event->reset();
    insert_event->bind(1, static_cast<std::int64_t>(event.tick));
    insert_event->bind(2, std::string(event_kind_name(event.event.kind)));
    insert_event->bind(3, static_cast<int>(event.event.tissue));
    insert_event->bind(4, event.event.depth);
    insert_event->bind(5, event.event.value);
    insert_event->exec();
  }
}

void SessionWriter::Impl::put_samples() {
  auto number = static_cast<std::int64_t>(total_samples);
  for (const SecondSample& sample : samples) {
    const Eigen::Quaterniond& turn = sample.rotation;
    insert_sample->reset();
    insert_sample->bind(1, number++);
    int column = 2;
    for (const double value : {sample.time, sample.position.x(), sample.position.y(), sample.position.z(), turn.w(),
                               turn.x(), turn.y(), turn.z(), sample.force, sample.pressure, sample.volume}) {
      if (column > 10 && !pressure_is_kept) {
        insert_sample->bind(column++);
      } else {
        insert_sample->bind(column++, value);
      }
    }
    insert_sample->exec();
  }
}

SessionWriter::SessionWriter(const fs::path& file, const SessionHeader& header, bool overwrite) {
  if (!(header.dt > 0.0))
    throw InputError(fmt::format("the tick of a session is {} s, expected more than 0", header.dt));
  std::error_code ignored;
  const bool exists = fs::exists(fs::symlink_status(file, ignored));
  if (exists && !overwrite) {
    throw InputError(
        fmt::format("the session file {} exists already; give another --output, or --overwrite", file.string()));
  }
  if (exists && !fs::is_regular_file(file, ignored)) {
    throw InputError(fmt::format("{} is not a file that a session could replace", file.string()));
  }
  try {
    NewSessionFile place(file, exists);
    impl_ = std::make_unique<Impl>(file, header);
    place.keep();
  } catch (const SQLite::Exception& error) {
    throw SystemError(fmt::format("cannot create the session file {}: {}; free space on its disk, or write elsewhere",
                                  file.string(), error.what()));
  } catch (const fs::filesystem_error& error) {
    throw SystemError(fmt::format("cannot replace the session file {}: {}", file.string(), error.code().message()));
  }
}

SessionWriter::~SessionWriter() {
  if (!impl_ || impl_->finished) return;
  try {
    impl_->flush();
  } catch (const SQLite::Exception&) {
    // Nothing more can be saved here, and a destructor cannot report errors; commit() and finish() do.
  }
}

SessionWriter::SessionWriter(SessionWriter&&) noexcept = default;
SessionWriter& SessionWriter::operator=(SessionWriter&&) noexcept = default;

void SessionWriter::append(const simulation::TickRecord& record) {
  Impl& writer = *impl_;
  const bool gap = writer.ticks > 0 && record.tick != writer.first_tick + writer.ticks;
  if (gap) commit();
  if (writer.ticks == 0) writer.first_tick = record.tick;
  encode_tick(record, writer.data);
  encode_diagnostics(record, writer.diagnostic_count, writer.diagnostics);
  for (const forces::Event& event : record.output.events) writer.events.push_back({record.tick, event});
  ++writer.ticks;
  ++writer.total_ticks;
  if (writer.ticks == writer.chunk_ticks) commit();
}

void SessionWriter::append(const SecondSample& sample) {
  Impl& writer = *impl_;
  if (writer.has_second && writer.total_samples + writer.samples.size() < session_schema::most_second_samples) {
    writer.samples.push_back(sample);
  }
}

void SessionWriter::append(const ScanSample& sample) {
  if (impl_->scans != nullptr) impl_->scans->add(sample);
}

void SessionWriter::append(const ScannedPart& part) {
  if (impl_->scans != nullptr) impl_->scans->add(part);
}

void SessionWriter::append(const fem::BodyStep& step) {
  if (impl_->body != nullptr) impl_->body->add(step);
}

void SessionWriter::append(const AppliedBodyStep& applied) {
  if (impl_->body != nullptr) impl_->body->add(applied);
}

void SessionWriter::append(const NumberChange& change) {
  commit();
  try {
    append_change(impl_->database, change);
  } catch (const SQLite::Exception& error) {
    impl_->fail(error);
  }
}

void SessionWriter::commit() {
  try {
    impl_->flush();
  } catch (const SQLite::Exception& error) {
    impl_->fail(error);
  }
}

void SessionWriter::finish(const std::optional<SessionTimings>& timings) {
  commit();
  try {
    if (timings) impl_->put_timings(*timings);
    impl_->put_header("finished_after_ticks", fmt::format("{}", impl_->total_ticks));
    if (impl_->has_second) impl_->put_header("second_samples", fmt::format("{}", impl_->total_samples));
    if (impl_->scans != nullptr) {
      impl_->put_header("scan_samples", fmt::format("{}", impl_->scans->samples()));
      impl_->scans->close();
    }
    if (impl_->body != nullptr) impl_->body->close();
    impl_->insert_chunk.reset();
    impl_->insert_diagnostics.reset();
    impl_->insert_event.reset();
    impl_->insert_sample.reset();
    // Back to a single file: the log is merged and removed.
    impl_->database.exec("PRAGMA journal_mode=DELETE");
    impl_->finished = true;
  } catch (const SQLite::Exception& error) {
    impl_->fail(error);
  }
}

}  // namespace bodkin::session
