#pragma once

#include <filesystem>
#include <string>

#include "training/store/result_store.h"

namespace bodkin::training {

// Where an attempt has come to.
struct Delivery {
  enum class State { stored, known, waiting };
  State state = State::stored;
  std::string reason;          // why it waits: one sentence; empty where it does not
  std::int64_t delivered = 0;  // attempts that had waited and are in the store now
};

// A station's way to the store: what the store cannot take now waits in a file here and is delivered later. An
// attempt is removed from the outbox only when the store has it, and the store keeps none twice: a call that is
// killed in between does no harm.
class Outbox {
 public:
  // `place`: the store, as ResultStore takes it. `file`: where attempts wait; made when the first one does.
  Outbox(std::string place, std::filesystem::path file,
         std::chrono::milliseconds patience = ResultStore::usual_patience);

  // Delivers what waits, then the record. When the store refuses for whatever reason (unreachable, locked, full,
  // newer), the record waits. Throws InputError for a record that no store would take, and SystemError when the
  // outbox cannot be written either; the session is then to be added again.
  Delivery add(const AttemptRecord& record);
  // Delivers what waits. Throws what the store says when it refuses.
  std::int64_t deliver();
  // How many wait.
  std::int64_t waiting() const;
  // Removes what a trainee has here.
  Deletion remove_trainee(const std::string& label);

 private:
  std::int64_t deliver_to(ResultStore& store);

  std::string place_;
  std::filesystem::path file_;
  std::chrono::milliseconds patience_;
};

}  // namespace bodkin::training
