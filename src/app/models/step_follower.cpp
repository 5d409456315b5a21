#include "app/models/step_follower.h"

#include <algorithm>
#include <utility>

#include "session/tick_codec.h"
#include "station/scan_thread.h"

namespace bodkin::app {

StepFollower::StepFollower(training::Procedure procedure, const anatomy::Case& patient)
    : procedure_(std::move(procedure)) {
  const anatomy::NeedlePath path = patient.description.procedure.path.value_or(anatomy::NeedlePath());
  for (const training::Step& step : procedure_.steps) {
    Watched watched;
    const anatomy::TissueProperties* const tissue = step.tissue.empty() ? nullptr : patient.library.find(step.tissue);
    if (tissue != nullptr) watched.tissue = tissue->id;
    if (!step.shown.empty()) watched.scan_target = training::find_scan_target(patient.description, path, step.shown);
    watched_.push_back(watched);
  }
}

void StepFollower::begin() {
  next_ = 0;
  has_probe_ = false;
  for (Watched& each : watched_) each.was_shown = false;
}

bool StepFollower::shows(const Frame& frame, std::size_t step) const {
  const anatomy::TissueId tissue = watched_[step].tissue;
  if (tissue != anatomy::tissue::air) {
    // A tip that jumps through a ligament is in it in no frame.
    const bool is_passed =
        std::any_of(frame.events.begin(), frame.events.end(), [tissue](const session::SessionEvent& event) {
          return event.event.kind == forces::EventKind::tissue_entered && event.event.tissue == tissue;
        });
    return frame.depth > 0.0 && (frame.tissue == tissue || is_passed);
  }
  const std::string& wanted = procedure_.steps[step].event;
  return !wanted.empty() &&
         std::any_of(frame.events.begin(), frame.events.end(), [&](const session::SessionEvent& event) {
           return session::event_kind_name(event.event.kind) == wanted;
         });
}

// A needle that only touched the skin was not withdrawn after the procedure: withdrawal counts only as the last step.
// Of two steps shown by the same event the earlier one comes first.
bool StepFollower::is_in_turn(std::size_t step) const {
  const std::string& wanted = procedure_.steps[step].event;
  for (std::size_t between = next_; between < step; ++between) {
    const std::string& event = procedure_.steps[between].event;
    if (!wanted.empty() && event == wanted) return false;
    const bool waits = !event.empty() && !session::is_of_other_hand(event);
    if (wanted == "withdrawn" && (watched_[between].tissue != anatomy::tissue::air || waits)) return false;
  }
  return true;
}

void StepFollower::look(const station::LiveImage& picture, const anatomy::UltrasoundProbe& probe) {
  has_probe_ = true;
  if (picture.frame.why != imaging::NoImage::none) return;  // it is black
  const training::ProbeState moment =
      training::probe_moment({.probe = picture.setup.probe, .settings = picture.setup.settings}, 0.0);
  for (Watched& each : watched_) {
    each.was_shown = each.was_shown || (each.scan_target &&
                                        training::is_shown(*each.scan_target, moment, &probe, procedure_.thresholds));
  }
}

void StepFollower::follow(const Frame& frame, const anatomy::UltrasoundProbe* probe) {
  if (frame.ultrasound != nullptr && probe != nullptr) look(*frame.ultrasound, *probe);
  // The farthest visible one.
  for (std::size_t step = watched_.size(); step > next_; --step) {
    if (!is_in_turn(step - 1) || !shows(frame, step - 1)) continue;
    next_ = step;
    break;
  }
  while (next_ < watched_.size() && watched_[next_].was_shown) ++next_;
}

const training::Step* StepFollower::next() const {
  if (next_ >= watched_.size()) return nullptr;
  for (std::size_t step = 0; has_probe_ && step < next_; ++step)
    if (watched_[step].scan_target && !watched_[step].was_shown) return &procedure_.steps[step];
  return &procedure_.steps[next_];
}

}  // namespace bodkin::app
