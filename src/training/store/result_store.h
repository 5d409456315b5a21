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

// An attempt as the table of a cohort and a learning curve need it.
struct AttemptSummary {
  std::string trainee;
  std::string procedure;
  std::string started_at;
  std::string digest;
  Grade verdict = Grade::fail;
  double score = 0.0;  // 0 to 100
  int stage = 0;       // of the plan, where it was asked for by its plan
};

// What deleting a trainee did.
struct Deletion {
  std::int64_t attempts = 0;
  std::vector<std::filesystem::path> deleted_files;  // sessions that the store owned
  std::vector<std::string> other_files;  // owned sessions that are on another station, or could not be removed
};

struct StoredPlan {
  std::string name, title, document;
};

// Results of trainees, kept in a database. Several programs and stations may use one at a time. All functions throw
// SystemError with one sentence when the database is locked, full or damaged, and StoreUnreachable when it does not
// answer; then nothing was changed.
class ResultStore {
 public:
  static constexpr std::chrono::milliseconds usual_patience{5000};

  // `place`: a file, which is made when it is not there, or postgresql://... . Brings the tables to the newest
  // version. Throws InputError for a place that holds something else, or a newer store.
  explicit ResultStore(const std::string& place, std::chrono::milliseconds patience = usual_patience);

  // Where it is, without a password.
  const std::string& place() const { return connection_->place(); }

  // Keeps an attempt; false: it has been there before, and nothing was changed. Throws InputError for a label that is
  // none.
  bool add(const AttemptRecord& record);
  // The same for many, as one change. Returns how many are new.
  std::int64_t add(const std::vector<AttemptRecord>& records);

  std::vector<std::string> trainees();
  // In the order of trainee, procedure and time. `trainee`, `procedure`: only theirs; empty: all.
  std::vector<AttemptSummary> summaries(const std::string& trainee = {}, const std::string& procedure = {});
  // Of a plan, in the order of trainee and time. `trainee`: only his; empty: all.
  std::vector<AttemptSummary> summaries_of_plan(const std::string& plan, const std::string& trainee = {});
  // Everything of the attempts of a trainee, in the order of time; empty: of all.
  std::vector<AttemptRecord> attempts(const std::string& trainee = {});
  // Everything of one attempt.
  std::optional<AttemptRecord> attempt(const std::string& digest);

  // Removes one attempt, as after its delivery to another store, and trainees who have no other.
  void remove(const std::string& digest);
  // Removes a trainee with all attempts, their sessions that the store owns, and their traces in the database's file.
  // Throws InputError when there is no such trainee.
  Deletion remove_trainee(const std::string& label);

  // Keeps a plan, in place of an older one of its name.
  void put_plan(const StoredPlan& plan);
  std::vector<StoredPlan> plans();

 private:
  bool insert(const AttemptRecord& record);
  std::vector<AttemptRecord> read_attempts(const std::string& condition, const std::vector<SqlValue>& values);

  std::unique_ptr<SqlConnection> connection_;
};

// "postgresql://..." or "postgres://...": a server, no file.
bool is_server(const std::string& place);

}  // namespace bodkin::training
