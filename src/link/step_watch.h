#pragma once

#include <span>
#include <string>
#include <vector>

#include "session/session_file.h"
#include "station/hand_session.h"

#include "anatomy/tissue.h"

namespace bodkin::link {

// A step of a procedure, and its evidence: a tissue at the tip, or an event.
struct WatchedStep {
  std::string title;
  std::string tissue;  // "fat"; empty: shown by an event, or not detectable
  std::string event;   // "contact"
};

// Which steps a running session has reached, each after the previous one; steps without evidence are skipped, and so
// are those of a second hand, if there is none. The score of the recording (training/score.h) is more complete: it
// also finds steps after one that was left out.
class StepWatch {
 public:
  explicit StepWatch(std::vector<WatchedStep> steps) : steps_(std::move(steps)) {}

  void update(std::span<const station::HandSample> samples, std::span<const session::SessionEvent> events,
              const anatomy::TissueLibrary& library);

  // Their number, and the newest one reached, from 1; 0: none yet.
  std::size_t count() const noexcept { return steps_.size(); }
  std::size_t number() const noexcept { return reached_; }
  // The title of the newest one reached; empty: none yet.
  std::string title() const { return reached_ == 0 ? std::string() : steps_[reached_ - 1].title; }

 private:
  bool may_be_left_out(std::size_t step) const;

  std::vector<WatchedStep> steps_;
  std::size_t reached_ = 0;
};

}  // namespace bodkin::link
