#include "app/models/tour_steps.h"

namespace bodkin::app {

void TourSteps::looked() noexcept {
  if (step_ == Step::look) step_ = Step::aim;
}

void TourSteps::see(const Frame& frame) noexcept {
  const bool in_body = needle_is_down(frame.state) && frame.state != State::touching;
  switch (step_) {
    case Step::look:
      if (needle_is_down(frame.state)) step_ = Step::push;  // whoever inserts at once has aimed
      return;
    case Step::aim:
      if (needle_is_down(frame.state)) step_ = Step::push;
      return;
    case Step::push:
      if (!in_body) return;
      step_ = Step::read;
      tissue_ = frame.tissue;
      return;
    case Step::read:
      if (in_body && frame.tissue != tissue_) step_ = Step::done;
      return;
    case Step::done:
      return;
  }
}

}  // namespace bodkin::app
