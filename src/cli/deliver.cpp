#include "cli/deliver.h"

#include <filesystem>

#include <fmt/format.h>

#include "training/recorded_score.h"
#include "training/store/outbox.h"
#include "training/store/store_place.h"

namespace bodkin::cli {

void deliver_result(const std::string& session, const std::string& trainee, const std::string& store,
                    Console& console) {
  const training::RecordedScore judged = training::score_recording(session, {}, {}, console.progress());
  console.clear_bar();
  training::AttemptRecord record = training::record_of(judged.session, judged.description.name, judged.score);
  record.trainee = trainee;
  record.file = std::filesystem::absolute(session).lexically_normal().string();
  training::Outbox outbox(training::store_place(store), training::outbox_file());
  const training::Delivery delivery = outbox.add(record);
  if (delivery.state == training::Delivery::State::waiting) {
    console.note(fmt::format("the result of {} waits on this station: {}", trainee, delivery.reason));
    return;
  }
  console.note(fmt::format("the result of {} is in the store: {}, {:.0f}", trainee, training::name_of(record.verdict),
                           record.score));
}

}  // namespace bodkin::cli
