#include "training/store/outbox.h"

#include <algorithm>

namespace bodkin::training {

namespace fs = std::filesystem;

Outbox::Outbox(std::string place, fs::path file, std::chrono::milliseconds patience)
    : place_(std::move(place)), file_(std::move(file)), patience_(patience) {}

Delivery Outbox::add(const AttemptRecord& record) {
  check_label(record.trainee, "the trainee");
  Delivery delivery;
  try {
    ResultStore store(place_, patience_);
    delivery.delivered = deliver_to(store);
    delivery.state = store.add(record) ? Delivery::State::stored : Delivery::State::known;
  } catch (const std::runtime_error& refused) {
    if (dynamic_cast<const InputError*>(&refused) == nullptr && dynamic_cast<const SystemError*>(&refused) == nullptr)
      throw;
    ResultStore(file_.string(), patience_).add(record);
    delivery.state = Delivery::State::waiting;
    delivery.reason = refused.what();
  }
  return delivery;
}

std::int64_t Outbox::deliver() {
  ResultStore store(place_, patience_);
  return deliver_to(store);
}

std::int64_t Outbox::deliver_to(ResultStore& store) {
  if (!fs::exists(file_)) return 0;
  ResultStore outbox(file_.string(), patience_);
  const std::vector<AttemptRecord> waiting = outbox.attempts();
  for (const AttemptRecord& each : waiting) {
    store.add(each);
    outbox.remove(each.digest);
  }
  return static_cast<std::int64_t>(waiting.size());
}

std::int64_t Outbox::waiting() const {
  if (!fs::exists(file_)) return 0;
  return static_cast<std::int64_t>(ResultStore(file_.string(), patience_).summaries().size());
}

Deletion Outbox::remove_trainee(const std::string& label) {
  if (!fs::exists(file_)) return {};
  ResultStore outbox(file_.string(), patience_);
  const std::vector<std::string> labels = outbox.trainees();
  return std::find(labels.begin(), labels.end(), label) == labels.end() ? Deletion{} : outbox.remove_trainee(label);
}

}  // namespace bodkin::training
