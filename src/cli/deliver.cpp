#include "cli/deliver.h"

#include <chrono>
#include <filesystem>
#include <stdexcept>

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
  training::Outbox outbox(training::store_place(store), training::outbox_folder());
  const training::Delivery delivery = outbox.add(record);
  if (delivery.state == training::Delivery::State::waiting) {
    console.note(fmt::format("the result of {} waits on this station: {}", trainee, delivery.reason));
    return;
  }
  console.note(fmt::format("the result of {} is in the store: {}, {:.0f}", trainee, training::name_of(record.verdict),
                           record.score));
}

void deliver_waiting(const std::string& store, Console& console) {
  constexpr std::chrono::milliseconds patience{2000};
  try {
    training::Outbox outbox(training::store_place(store), training::outbox_folder(), patience);
    if (outbox.waiting() == 0) return;
    console.note(fmt::format("{} results that waited on this station are now in the store", outbox.deliver()));
  } catch (const std::runtime_error& error) {
    console.note(fmt::format("results still wait on this station: {}", error.what()));
  }
}

}  // namespace bodkin::cli
