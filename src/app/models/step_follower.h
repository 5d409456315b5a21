#pragma once

#include <cstddef>

#include "views/frame.h"

#include "anatomy/tissue.h"
#include "training/procedure.h"

namespace bodkin::app {

using namespace views;

// Which step of a procedure comes next, while it is done: the one after the farthest that the needle has reached. A
// step that nothing shows (neither a tissue nor an event) is over when a later one is reached.
class StepFollower {
 public:
  StepFollower() = default;
  StepFollower(training::Procedure procedure, const anatomy::TissueLibrary& tissues);

  // A new attempt.
  void begin() { next_ = 0; }
  void follow(const Frame& frame);
  // Null: there are no steps, or all are done.
  const training::Step* next() const;

 private:
  bool is_in_turn(std::size_t step) const;
  bool shows(const Frame& frame, std::size_t step) const;

  training::Procedure procedure_;
  std::vector<anatomy::TissueId> tissues_;  // of each step; air: none
  std::size_t next_ = 0;
};

}  // namespace bodkin::app
