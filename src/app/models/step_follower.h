#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "views/frame.h"

#include "anatomy/case.h"
#include "training/procedure.h"
#include "training/scan_guide.h"

namespace bodkin::app {

using namespace views;

// Determines the next step of a procedure: the one after the farthest step that the needle has reached. A step shown
// by ultrasound is complete once the image has shown it: even early, and no sooner if the needle is ahead of the
// probe. A step without such a sign is complete when a later one is reached; so is an ultrasound step without a
// probe, or one whose landmark this patient lacks.
class StepFollower {
 public:
  StepFollower() = default;
  StepFollower(training::Procedure procedure, const anatomy::Case& patient);

  // Begins a new attempt.
  void begin();
  // `probe`: of the machine whose images the frame has; null: none.
  void follow(const Frame& frame, const anatomy::UltrasoundProbe* probe);
  // Null: there are no steps, or the last one is complete.
  const training::Step* next() const;

 private:
  // The sign of a completed step, besides an event.
  struct Watched {
    anatomy::TissueId tissue = anatomy::tissue::air;  // air: none
    std::optional<training::ScanTarget> scan_target;  // by ultrasound
    bool was_shown = false;
  };

  bool is_in_turn(std::size_t step) const;
  bool shows(const Frame& frame, std::size_t step) const;
  void look(const station::LiveImage& picture, const anatomy::UltrasoundProbe& probe);

  training::Procedure procedure_;
  std::vector<Watched> watched_;  // of each step
  std::size_t next_ = 0;
  bool has_probe_ = false;  // there were images
};

}  // namespace bodkin::app
