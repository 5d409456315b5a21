#include "link/step_watch.h"

#include <algorithm>

#include "session/tick_codec.h"

namespace bodkin::link {

// Not awaited: nothing shows it, or only in patients with a place to palpate and fluid to measure.
bool StepWatch::may_be_left_out(std::size_t step) const {
  const WatchedStep& one = steps_[step];
  return one.tissue.empty() && (one.event.empty() || session::is_of_other_hand(one.event));
}

void StepWatch::update(std::span<const station::HandSample> samples, std::span<const session::SessionEvent> events,
                       const anatomy::TissueLibrary& library) {
  std::size_t used = 0;  // events that have shown a step
  // A step and its evidence; events only if they have not shown another step.
  const auto shows = [&](const WatchedStep& step) {
    if (!step.tissue.empty()) {
      return std::any_of(samples.begin(), samples.end(), [&](const station::HandSample& sample) {
        const anatomy::TissueProperties* const tissue = library.find(sample.tissue);
        return tissue != nullptr && tissue->name == step.tissue;
      });
    }
    if (step.event.empty()) return false;
    for (std::size_t i = used; i < events.size(); ++i) {
      if (step.event != session::event_kind_name(events[i].event.kind)) continue;
      used = i + 1;
      return true;
    }
    return false;
  };
  for (std::size_t step = reached_; step < steps_.size(); ++step) {
    if (shows(steps_[step]))
      reached_ = step + 1;
    else if (!may_be_left_out(step))
      return;
  }
}

}  // namespace bodkin::link
