#include "link/step_watch.h"

#include "session/tick_codec.h"

namespace bodkin::link {

std::size_t StepWatch::next() const noexcept {
  std::size_t at = reached_;
  while (at < steps_.size() && steps_[at].tissue.empty() && steps_[at].event.empty()) ++at;
  return at;
}

void StepWatch::update(std::span<const station::HandSample> samples, std::span<const session::SessionEvent> events,
                       const anatomy::TissueLibrary& library) {
  const auto shown_by_tissue = [&](const WatchedStep& step) {
    if (step.tissue.empty()) return false;
    for (const station::HandSample& sample : samples) {
      const anatomy::TissueProperties* const tissue = library.find(sample.tissue);
      if (tissue != nullptr && tissue->name == step.tissue) return true;
    }
    return false;
  };
  const auto shown_by_event = [&](const WatchedStep& step) {
    for (const session::SessionEvent& event : events) {
      if (!step.event.empty() && step.event == session::event_kind_name(event.event.kind)) return true;
    }
    return false;
  };
  for (std::size_t at = next(); at < steps_.size(); at = next()) {
    if (!shown_by_tissue(steps_[at]) && !shown_by_event(steps_[at])) return;
    reached_ = at + 1;
  }
}

}  // namespace bodkin::link
