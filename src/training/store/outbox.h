#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "training/store/plan_attempts.h"
#include "training/store/result_store.h"

namespace bodkin::training {

// The result of delivering an attempt.
struct Delivery {
  enum class State { stored, known, waiting };
  State state = State::stored;
  std::string reason;          // why it waits: one sentence; empty if it does not
  std::int64_t delivered = 0;  // attempts that had waited and are now in the store
};

// Attempts that wait for a store.
struct PendingAttempts {
  std::string store;  // its address, without a password
  std::int64_t attempts = 0;
};

// A station's connection to a store: attempts that the store cannot accept now wait in a file here and are delivered
// later, to that store and no other. An attempt is removed from the outbox only when the store has it, and the store
// keeps none twice: a call that is killed in between does no harm.
//
// The folder has a file of attempts for each store for which attempts have ever waited, and a file with the store's
// name. A store is identified by its address without the password, a file by its absolute path.
class Outbox {
 public:
  // `place`: the store, as for ResultStore. `folder`: of waiting attempts; created when the first one waits.
  Outbox(std::string place, std::filesystem::path folder,
         std::chrono::milliseconds patience = ResultStore::usual_patience);

  // Delivers the attempts waiting for this store, then the record. When the store refuses for any reason
  // (unreachable, locked, full, newer), the record waits. Throws InputError for a record that no store would accept,
  // and SystemError when the outbox cannot be written either; the session must then be added again.
  Delivery add(const AttemptRecord& record);
  // Assigns attempts of one trainee to the stages of a plan, as put_in_stages() does, after delivering waiting ones.
  // When the store refuses, the trainee's stage is unknown: they get the plan without a stage, and are assigned to
  // one when they are delivered.
  void put_in_plan(const PlanInUse& plan, std::vector<AttemptRecord>& records);
  // Delivers the attempts waiting for this store. Rethrows the store's error when it refuses.
  std::int64_t deliver();
  // Delivers the attempts waiting for another store, which has moved or no longer exists, to this one. Throws
  // InputError when none wait for `other`, and the store's error when it refuses.
  std::int64_t take_over(const std::string& other);
  // Number of attempts waiting for this store.
  std::int64_t waiting() const;
  // The other stores with waiting attempts, in the order of their names.
  std::vector<PendingAttempts> waiting_elsewhere() const;
  // Removes a trainee's attempts waiting here for this store.
  Deletion remove_trainee(const std::string& label);

 private:
  void name_store() const;
  std::int64_t deliver_to(ResultStore& store, const std::filesystem::path& file);

  std::string place_;
  std::filesystem::path folder_, file_;
  std::chrono::milliseconds patience_;
};

}  // namespace bodkin::training
