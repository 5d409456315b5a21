#include "app/models/step_follower.h"

#include <algorithm>
#include <utility>

#include "session/tick_codec.h"

namespace bodkin::app {

StepFollower::StepFollower(training::Procedure procedure, const anatomy::TissueLibrary& tissues)
    : procedure_(std::move(procedure)) {
  for (const training::Step& step : procedure_.steps) {
    const anatomy::TissueProperties* const tissue = step.tissue.empty() ? nullptr : tissues.find(step.tissue);
    tissues_.push_back(tissue == nullptr ? anatomy::tissue::air : tissue->id);
  }
}

bool StepFollower::shows(const Frame& frame, std::size_t step) const {
  if (tissues_[step] != anatomy::tissue::air) return frame.depth > 0.0 && frame.tissue == tissues_[step];
  const std::string& wanted = procedure_.steps[step].event;
  return !wanted.empty() &&
         std::any_of(frame.events.begin(), frame.events.end(), [&](const session::SessionEvent& event) {
           return session::event_kind_name(event.event.kind) == wanted;
         });
}

// A needle that has only touched the skin was not withdrawn after the procedure: that counts as the last step alone.
// Of two steps that show by the same event the earlier one comes first.
bool StepFollower::is_in_turn(std::size_t step) const {
  const std::string& wanted = procedure_.steps[step].event;
  for (std::size_t between = next_; between < step; ++between) {
    const std::string& event = procedure_.steps[between].event;
    if (!wanted.empty() && event == wanted) return false;
    const bool waits = !event.empty() && !session::is_of_other_hand(event);
    if (wanted == "withdrawn" && (tissues_[between] != anatomy::tissue::air || waits)) return false;
  }
  return true;
}

void StepFollower::follow(const Frame& frame) {
  // The farthest that shows.
  for (std::size_t step = tissues_.size(); step > next_; --step) {
    if (!is_in_turn(step - 1) || !shows(frame, step - 1)) continue;
    next_ = step;
    return;
  }
}

const training::Step* StepFollower::next() const {
  return next_ < procedure_.steps.size() ? &procedure_.steps[next_] : nullptr;
}

}  // namespace bodkin::app
