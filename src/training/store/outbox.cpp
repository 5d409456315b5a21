#include "training/store/outbox.h"

#include <algorithm>
#include <regex>
#include <system_error>

#include "session/session_schema.h"
#include <fmt/format.h>

#include "core/files.h"
#include "io/resources.h"

namespace bodkin::training {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view attempts_suffix = ".sqlite", name_suffix = ".store";
constexpr std::size_t longest_name = 1 << 16;  // bytes

// Identity of a store, and its name for people.
std::string name_of_store(const std::string& place) {
  if (!is_server(place)) return fs::absolute(place).lexically_normal().string();
  const std::string address = "postgresql://" + place.substr(place.find("://") + 3);
  const std::string bare = std::regex_replace(address, std::regex("://([^/@:]*):[^/@]*@"), "://$1@");
  return std::regex_replace(bare, std::regex("([?&]password=)[^&]*"), "$1");
}

fs::path file_for(const fs::path& folder, const std::string& name) {
  return folder / (session::text_checksum(name) + std::string(attempts_suffix));
}

std::int64_t count_of(const fs::path& file, std::chrono::milliseconds patience) {
  if (!fs::exists(file)) return 0;
  return static_cast<std::int64_t>(ResultStore(file.string(), patience).summaries().size());
}

// An error reported by a store, as opposed to a fault of the program.
bool is_refusal(const std::runtime_error& error) {
  return dynamic_cast<const InputError*>(&error) != nullptr || dynamic_cast<const SystemError*>(&error) != nullptr;
}

// Finds the stage of an attempt queued without one, by the plan queued with it.
void put_in_stage(AttemptRecord& record, ResultStore& outbox, ResultStore& store) {
  std::vector<AttemptRecord> records = {record};
  records.front().plan.clear();
  for (const StoredPlan& plan : outbox.plans())
    if (plan.name == record.plan)
      put_in_stages({parse_plan(plan.document, plan.name), plan.document}, store, records);
  record = records.front();
}

}  // namespace

Outbox::Outbox(std::string place, fs::path folder, std::chrono::milliseconds patience)
    : place_(std::move(place)),
      folder_(std::move(folder)),
      file_(file_for(folder_, name_of_store(place_))),
      patience_(patience) {}

Delivery Outbox::add(const AttemptRecord& record) {
  check_label(record.trainee, "the trainee");
  Delivery delivery;
  try {
    ResultStore store(place_, patience_);
    delivery.delivered = deliver_to(store, file_);
    delivery.state = store.add(record) ? Delivery::State::stored : Delivery::State::known;
  } catch (const std::runtime_error& refused) {
    if (!is_refusal(refused)) throw;
    name_store();
    ResultStore(file_.string(), patience_).add(record);
    delivery.state = Delivery::State::waiting;
    delivery.reason = refused.what();
  }
  return delivery;
}

void Outbox::put_in_plan(const PlanInUse& plan, std::vector<AttemptRecord>& records) {
  try {
    ResultStore store(place_, patience_);
    deliver_to(store, file_);
    put_in_stages(plan, store, records);
  } catch (const std::runtime_error& refused) {
    if (!is_refusal(refused)) throw;
    name_store();
    ResultStore(file_.string(), patience_).put_plan({plan.plan.name, plan.plan.title, plan.document});
    for (AttemptRecord& each : records) {
      each.plan = plan.plan.name;
      each.stage = 0;
    }
  }
}

// Before anything is queued: attempts without it could not be distinguished from those for another store.
void Outbox::name_store() const {
  const fs::path name_file = fs::path(file_).replace_extension(name_suffix);
  if (!fs::exists(name_file)) write_file(name_file, name_of_store(place_));
}

std::int64_t Outbox::deliver() {
  ResultStore store(place_, patience_);
  return deliver_to(store, file_);
}

std::int64_t Outbox::take_over(const std::string& other) {
  const std::string name = name_of_store(other);
  const fs::path file = file_for(folder_, name);
  if (count_of(file, patience_) == 0) {
    throw InputError(
        fmt::format("nothing on this station waits for the store {}; 'bodkin results list' names the stores that "
                    "something waits for",
                    name));
  }
  ResultStore store(place_, patience_);
  return deliver_to(store, file);
}

std::int64_t Outbox::deliver_to(ResultStore& store, const fs::path& file) {
  if (!fs::exists(file)) return 0;
  ResultStore outbox(file.string(), patience_);
  std::vector<AttemptRecord> waiting = outbox.attempts();
  for (AttemptRecord& each : waiting) {
    if (!each.plan.empty() && each.stage == 0) put_in_stage(each, outbox, store);
    store.add(each);
    outbox.remove(each.digest);
  }
  return static_cast<std::int64_t>(waiting.size());
}

std::int64_t Outbox::waiting() const {
  return count_of(file_, patience_);
}

std::vector<PendingAttempts> Outbox::waiting_elsewhere() const {
  std::vector<PendingAttempts> found;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(folder_, failure)) {
    if (entry.path().extension() != name_suffix) continue;
    const fs::path file = fs::path(entry.path()).replace_extension(attempts_suffix);
    if (file.filename() == file_.filename()) continue;
    const std::int64_t attempts = count_of(file, patience_);
    if (attempts > 0) found.push_back({io::read_text_file(entry.path(), longest_name), attempts});
  }
  std::sort(found.begin(), found.end(),
            [](const PendingAttempts& a, const PendingAttempts& b) { return a.store < b.store; });
  return found;
}

Deletion Outbox::remove_trainee(const std::string& label) {
  if (!fs::exists(file_)) return {};
  ResultStore outbox(file_.string(), patience_);
  const std::vector<std::string> labels = outbox.trainees();
  return std::find(labels.begin(), labels.end(), label) == labels.end() ? Deletion{} : outbox.remove_trainee(label);
}

}  // namespace bodkin::training
