#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "training/store/attempt_record.h"
#include "training/store/sql_connection.h"

namespace bodkin::training {

// The data of an attempt for the table of a cohort and a learning curve.
struct AttemptSummary {
  std::string trainee;
  std::string procedure;
  std::string started_at;
  std::string digest;
  Grade verdict = Grade::fail;
  double score = 0.0;  // 0 to 100
  int stage = 0;       // of the plan, when requested by its plan
};

// Result of deleting a trainee.
struct Deletion {
  std::int64_t attempts = 0;
  std::vector<std::filesystem::path> deleted_files;  // sessions owned by the store
  std::vector<std::string> other_files;              // owned sessions on another station, or not removable
};

struct StoredPlan {
  std::string name, title, document;
};

// Results of trainees, stored in a database. Several programs and stations may use one at a time. All functions throw
// SystemError with one sentence when the database is locked, full or damaged, and StoreUnreachable when it does not
// respond; in these cases nothing was changed.
class ResultStore {
 public:
  static constexpr std::chrono::milliseconds usual_patience{5000};

  // `place`: a file, which is created if missing, or postgresql://... . Converts the tables to the newest version.
  // Throws InputError for other content, or a newer store.
  explicit ResultStore(const std::string& place, std::chrono::milliseconds patience = usual_patience);

  // Its address, without a password.
  const std::string& place() const { return connection_->place(); }

  // Stores an attempt; false: it was there already, and nothing was changed. Throws InputError for an invalid label.
  bool add(const AttemptRecord& record);
  // Stores many in one transaction. Returns the number of new ones.
  std::int64_t add(const std::vector<AttemptRecord>& records);

  std::vector<std::string> trainees();
  // In the order of trainee, procedure and time. `trainee`, `procedure`: only theirs; empty: all.
  std::vector<AttemptSummary> summaries(const std::string& trainee = {}, const std::string& procedure = {});
  // Of a plan, in the order of trainee and time. `trainee`: only that trainee's; empty: all.
  std::vector<AttemptSummary> summaries_of_plan(const std::string& plan, const std::string& trainee = {});
  // The full records of a trainee's attempts, in chronological order; empty: of all trainees.
  std::vector<AttemptRecord> attempts(const std::string& trainee = {});
  // The full record of one attempt.
  std::optional<AttemptRecord> attempt(const std::string& digest);

  // Removes one attempt, as after its delivery to another store, and trainees without any other.
  void remove(const std::string& digest);
  // Removes a trainee with all attempts, their sessions owned by the store, and their traces in the database's file.
  // Throws InputError when there is no such trainee.
  Deletion remove_trainee(const std::string& label);

  // Stores a plan, replacing an older one of its name.
  void put_plan(const StoredPlan& plan);
  std::vector<StoredPlan> plans();

 private:
  bool insert(const AttemptRecord& record);
  std::vector<AttemptRecord> read_attempts(const std::string& condition, const std::vector<SqlValue>& values);

  std::unique_ptr<SqlConnection> connection_;
};

// "postgresql://..." or "postgres://...": a server, not a file.
bool is_server(const std::string& place);

}  // namespace bodkin::training
