#include "simulation/changing_tick.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bodkin::simulation {

namespace {

template <typename Value>
void mix(Value& now, const Value& before, double share) noexcept {
  now = share * now + (1.0 - share) * before;
}

void mix(Wrench& now, const Wrench& before, double share) noexcept {
  mix(now.force, before.force, share);
  mix(now.torque, before.torque, share);
}

}  // namespace

ChangingTick::ChangingTick(HapticTick& first) noexcept : now_(&first) {}

bool ChangingTick::switch_to(HapticTick& next) noexcept {
  if (is_settling()) return false;
  before_ = std::exchange(now_, &next);
  steps_ = std::max(1, static_cast<int>(std::lround(blend_time / next.dt())));
  step_ = 0;
  return true;
}

TickOutput ChangingTick::step(const TickInput& input) noexcept {
  TickOutput output = now_->step(input);
  if (before_ == nullptr) return output;
  const TickOutput before = before_->step(input);
  const double share = static_cast<double>(++step_) / steps_;
  mix(output.requested, before.requested, share);
  mix(output.applied, before.applied, share);
  mix(output.resistance, before.resistance, share);
  mix(output.constraint, before.constraint, share);
  if (step_ == steps_) before_ = nullptr;
  return output;
}

}  // namespace bodkin::simulation
