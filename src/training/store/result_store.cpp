#include "training/store/result_store.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "core/parameter_value.h"
#include "core/utc_time.h"
#include "io/xml_document.h"
#include "training/store/migrations.h"

namespace bodkin::training {

namespace {

namespace fs = std::filesystem;

constexpr const char* attempt_columns =
    "digest, trainee, procedure_name, patient, station, started_at, duration_s, verdict, reached, score, headline, "
    "metrics, findings, file, owns_file, plan, stage";

std::unique_ptr<SqlConnection> connect(const std::string& place, std::chrono::milliseconds patience) {
  if (!is_server(place)) return connect_sqlite(place, patience);
#ifdef BODKIN_POSTGRESQL
  return connect_postgresql(place, patience);
#else
  throw InputError(
      "this Bodkin was built without PostgreSQL; install libpqxx-dev and build it again, or name a file");
#endif
}

double store_number(std::string_view text) {
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::string truth(bool value) {
  return value ? "1" : "0";
}

}  // namespace

bool is_server(const std::string& place) {
  return place.starts_with("postgresql://") || place.starts_with("postgres://");
}

ResultStore::ResultStore(const std::string& place, std::chrono::milliseconds patience)
    : connection_(connect(place, patience)) {
  migrate(*connection_, newest_store_version());
}

bool ResultStore::insert(const AttemptRecord& record) {
  check_label(record.trainee, "the trainee");
  connection_->change("INSERT INTO trainees VALUES($1, $2) ON CONFLICT(label) DO NOTHING",
                      {record.trainee, utc_now()});
  return connection_->change(
             fmt::format(
                 "INSERT INTO attempts({}) VALUES($1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, $12, $13, $14, "
                 "$15, $16, $17) ON CONFLICT(digest) DO NOTHING",
                 attempt_columns),
             {record.digest, record.trainee, record.procedure, record.patient, record.station, record.started_at,
              number_text(record.duration), std::string(name_of(record.verdict)), truth(record.reached),
              number_text(record.score), record.headline, metrics_json(record), findings_json(record), record.file,
              truth(record.owns_file), record.plan, std::to_string(record.stage)}) > 0;
}

bool ResultStore::add(const AttemptRecord& record) {
  bool is_new = false;
  in_one_change(*connection_, [&] { is_new = insert(record); });
  return is_new;
}

std::int64_t ResultStore::add(const std::vector<AttemptRecord>& records) {
  std::int64_t added = 0;
  in_one_change(*connection_, [&] {
    for (const AttemptRecord& each : records) added += insert(each) ? 1 : 0;
  });
  return added;
}

std::vector<std::string> ResultStore::trainees() {
  std::vector<std::string> labels;
  connection_->read("SELECT label FROM trainees", {}, [&](SqlRow row) { labels.emplace_back(row[0]); });
  std::sort(labels.begin(), labels.end());
  return labels;
}

std::vector<AttemptSummary> ResultStore::summaries(const std::string& trainee, const std::string& procedure) {
  std::string conditions;
  std::vector<SqlValue> values;
  const auto only = [&](const char* column, const std::string& value) {
    if (value.empty()) return;
    values.emplace_back(value);
    conditions += fmt::format("{} {} = ${}", conditions.empty() ? " WHERE" : " AND", column, values.size());
  };
  only("trainee", trainee);
  only("procedure_name", procedure);
  std::vector<AttemptSummary> found;
  connection_->read(fmt::format("SELECT trainee, procedure_name, started_at, digest, verdict, score FROM attempts{} "
                                "ORDER BY trainee, procedure_name, started_at, digest",
                                conditions),
                    values, [&](SqlRow row) {
                      found.push_back({.trainee = std::string(row[0]),
                                       .procedure = std::string(row[1]),
                                       .started_at = std::string(row[2]),
                                       .digest = std::string(row[3]),
                                       .verdict = grade_of_name(row[4], place()),
                                       .score = store_number(row[5])});
                    });
  return found;
}

std::vector<AttemptSummary> ResultStore::summaries_of_plan(const std::string& plan, const std::string& trainee) {
  std::vector<SqlValue> values = {plan};
  if (!trainee.empty()) values.emplace_back(trainee);
  std::vector<AttemptSummary> found;
  connection_->read(
      fmt::format(
          "SELECT trainee, procedure_name, started_at, digest, verdict, score, stage FROM attempts WHERE plan "
          "= $1{} ORDER BY trainee, started_at, digest",
          trainee.empty() ? "" : " AND trainee = $2"),
      values, [&](SqlRow row) {
        found.push_back({.trainee = std::string(row[0]),
                         .procedure = std::string(row[1]),
                         .started_at = std::string(row[2]),
                         .digest = std::string(row[3]),
                         .verdict = grade_of_name(row[4], place()),
                         .score = store_number(row[5]),
                         .stage = static_cast<int>(store_number(row[6]))});
      });
  return found;
}

std::vector<AttemptRecord> ResultStore::read_attempts(const std::string& condition,
                                                      const std::vector<SqlValue>& values) {
  std::vector<AttemptRecord> found;
  connection_->read(
      fmt::format("SELECT {} FROM attempts{} ORDER BY trainee, started_at, digest", attempt_columns, condition),
      values, [&](SqlRow row) {
        AttemptRecord record;
        record.digest = row[0];
        record.trainee = row[1];
        record.procedure = row[2];
        record.patient = row[3];
        record.station = row[4];
        record.started_at = row[5];
        record.duration = store_number(row[6]);
        record.verdict = grade_of_name(row[7], place());
        record.reached = row[8] == "1";
        record.score = store_number(row[9]);
        record.headline = row[10];
        read_metrics(record, row[11], place());
        read_findings(record, row[12], place());
        record.file = row[13];
        record.owns_file = row[14] == "1";
        record.plan = row[15];
        record.stage = static_cast<int>(store_number(row[16]));
        found.push_back(std::move(record));
      });
  return found;
}

std::vector<AttemptRecord> ResultStore::attempts(const std::string& trainee) {
  return trainee.empty() ? read_attempts("", {}) : read_attempts(" WHERE trainee = $1", {trainee});
}

std::optional<AttemptRecord> ResultStore::attempt(const std::string& digest) {
  std::vector<AttemptRecord> found = read_attempts(" WHERE digest = $1", {digest});
  return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
}

void ResultStore::remove(const std::string& digest) {
  in_one_change(*connection_, [&] {
    connection_->change("DELETE FROM attempts WHERE digest = $1", {digest});
    connection_->change("DELETE FROM trainees WHERE NOT EXISTS (SELECT 1 FROM attempts WHERE trainee = label)");
  });
}

Deletion ResultStore::remove_trainee(const std::string& label) {
  Deletion done;
  std::vector<std::pair<std::string, std::string>> owned;  // station, file
  in_one_change(*connection_, [&] {
    connection_->read("SELECT station, file FROM attempts WHERE trainee = $1 AND owns_file = 1", {label},
                      [&](SqlRow row) { owned.emplace_back(row[0], row[1]); });
    done.attempts = connection_->change("DELETE FROM attempts WHERE trainee = $1", {label});
    if (connection_->change("DELETE FROM trainees WHERE label = $1", {label}) == 0) {
      throw InputError(fmt::format("the store {} has no trainee {}; 'bodkin results list' names them", place(),
                                   io::in_quotes(label)));
    }
  });
  connection_->wipe();
  for (const auto& [station, file] : owned) {
    std::error_code failure;
    if (station == station_name() && (fs::remove(file, failure) || !failure)) {
      done.deleted_files.emplace_back(file);
    } else {
      done.other_files.push_back(fmt::format("{} on {}", file, station));
    }
  }
  return done;
}

void ResultStore::put_plan(const StoredPlan& plan) {
  connection_->change(
      "INSERT INTO plans VALUES($1, $2, $3) ON CONFLICT(name) DO UPDATE SET title = excluded.title, document = "
      "excluded.document",
      {plan.name, plan.title, plan.document});
}

std::vector<StoredPlan> ResultStore::plans() {
  std::vector<StoredPlan> found;
  connection_->read("SELECT name, title, document FROM plans ORDER BY name", {}, [&](SqlRow row) {
    found.push_back({std::string(row[0]), std::string(row[1]), std::string(row[2])});
  });
  return found;
}

}  // namespace bodkin::training
