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

// Which step of a procedure comes next, while it is done: the one after the farthest that the needle has reached. A
// step that the ultrasound shows is over once the picture has shown it: before its turn too, and no sooner where the
// needle is ahead of the probe. A step that nothing shows is over when a later one is reached, and so is one of the
// ultrasound without a probe, or of something that this patient has no landmark for.
class StepFollower {
 public:
  StepFollower() = default;
  StepFollower(training::Procedure procedure, const anatomy::Case& patient);

  // A new attempt.
  void begin();
  // `probe`: of the machine whose pictures the frame has; null: none.
  void follow(const Frame& frame, const anatomy::UltrasoundProbe* probe);
  // Null: there are no steps, or the last one is done.
  const training::Step* next() const;

 private:
  // By what a step is known to be over, besides an event.
  struct Watched {
    anatomy::TissueId tissue = anatomy::tissue::air;  // air: none
    std::optional<training::Sought> sought;           // by the ultrasound
    bool was_shown = false;
  };

  bool is_in_turn(std::size_t step) const;
  bool shows(const Frame& frame, std::size_t step) const;
  void look(const station::LivePicture& picture, const anatomy::UltrasoundProbe& probe);

  training::Procedure procedure_;
  std::vector<Watched> watched_;  // of each step
  std::size_t next_ = 0;
  bool has_probe_ = false;  // there were pictures
};

}  // namespace bodkin::app
