#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "training/store/plan_attempts.h"
#include "training/store/result_store.h"

namespace bodkin::training {

// Where an attempt has come to.
struct Delivery {
  enum class State { stored, known, waiting };
  State state = State::stored;
  std::string reason;          // why it waits: one sentence; empty where it does not
  std::int64_t delivered = 0;  // attempts that had waited and are in the store now
};

// Attempts that wait for a store.
struct WaitingFor {
  std::string store;  // its place, without a password
  std::int64_t attempts = 0;
};

// A station's way to a store: what the store cannot take now waits in a file here and is delivered later, to that
// store and no other. An attempt is removed from the outbox only when the store has it, and the store keeps none
// twice: a call that is killed in between does no harm.
//
// The folder has a file of attempts for each store that some have ever waited for, and a file with the store's name.
// A store is known by its address without the password, a file by its absolute path.
class Outbox {
 public:
  // `place`: the store, as ResultStore takes it. `folder`: where attempts wait; made when the first one does.
  Outbox(std::string place, std::filesystem::path folder,
         std::chrono::milliseconds patience = ResultStore::usual_patience);

  // Delivers what waits for this store, then the record. When the store refuses for whatever reason (unreachable,
  // locked, full, newer), the record waits. Throws InputError for a record that no store would take, and SystemError
  // when the outbox cannot be written either; the session is then to be added again.
  Delivery add(const AttemptRecord& record);
  // Puts attempts of one trainee in the stages of a plan, as put_in_stages() does, after delivering what waits. When
  // the store refuses, which stage the trainee has come to is not known: they get the plan without a stage, and are
  // put in one when they are delivered.
  void put_in_plan(const PlanInUse& plan, std::vector<AttemptRecord>& records);
  // Delivers what waits for this store. Throws what the store says when it refuses.
  std::int64_t deliver();
  // Delivers to this store what waits for another one, which has moved or is no more. Throws InputError when nothing
  // waits for `other`, and what the store says when it refuses.
  std::int64_t take_over(const std::string& other);
  // How many wait for this store.
  std::int64_t waiting() const;
  // The other stores for which some wait, in the order of their names.
  std::vector<WaitingFor> waiting_elsewhere() const;
  // Removes what a trainee has here that waits for this store.
  Deletion remove_trainee(const std::string& label);

 private:
  void name_store() const;
  std::int64_t deliver_to(ResultStore& store, const std::filesystem::path& file);

  std::string place_;
  std::filesystem::path folder_, file_;
  std::chrono::milliseconds patience_;
};

}  // namespace bodkin::training
