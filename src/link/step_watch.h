#pragma once

#include <span>
#include <string>
#include <vector>

#include "session/session_file.h"
#include "station/hand_session.h"

#include "anatomy/tissue.h"

namespace bodkin::link {

// A stage of a procedure, and what shows that it was reached: a tissue at the tip, or an event.
struct WatchedStep {
  std::string title;
  std::string tissue;  // "fat"; empty: an event, or nothing, shows it
  std::string event;   // "contact"
};

// Which stages a session that runs has reached, each after the one before it; what nothing shows is passed over, and
// so is what only a second hand does, where it does not. The score of the recording (training/score.h) can do more:
// it also finds stages after one that was left out.
class StepWatch {
 public:
  explicit StepWatch(std::vector<WatchedStep> steps) : steps_(std::move(steps)) {}

  void update(std::span<const station::HandSample> samples, std::span<const session::SessionEvent> events,
              const anatomy::TissueLibrary& library);

  // How many there are, and the newest that was reached, from 1; 0: none yet.
  std::size_t count() const noexcept { return steps_.size(); }
  std::size_t number() const noexcept { return reached_; }
  // The title of that one; empty: none yet.
  std::string title() const { return reached_ == 0 ? std::string() : steps_[reached_ - 1].title; }

 private:
  bool may_be_left_out(std::size_t step) const;

  std::vector<WatchedStep> steps_;
  std::size_t reached_ = 0;
};

}  // namespace bodkin::link
