#pragma once

#include <cstdint>

#include "views/frame.h"

namespace bodkin::app {

using namespace views;

// Progress of the two-minute tour: look, aim, push, read. Each step ends when the user has done it.
class TourSteps {
 public:
  enum class Step : std::uint8_t { look, aim, push, read, done };
  static constexpr int count = 4;

  Step step() const noexcept { return step_; }
  // The patient was turned or zoomed.
  void looked() noexcept;
  void see(const Frame& frame) noexcept;

 private:
  Step step_ = Step::look;
  anatomy::TissueId tissue_ = anatomy::tissue::air;  // at the tip when reading began
};

}  // namespace bodkin::app
