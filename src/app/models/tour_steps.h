#pragma once

#include <cstdint>

#include "views/frame.h"

namespace bodkin::app {

using namespace views;

// How far somebody is on the two-minute tour: look, aim, push, read. Each ends by being done.
class TourSteps {
 public:
  enum class Step : std::uint8_t { look, aim, push, read, done };
  static constexpr int count = 4;

  Step step() const noexcept { return step_; }
  // The patient was turned or brought nearer.
  void looked() noexcept;
  void see(const Frame& frame) noexcept;

 private:
  Step step_ = Step::look;
  anatomy::TissueId tissue_ = anatomy::tissue::air;  // at the tip when reading began
};

}  // namespace bodkin::app
