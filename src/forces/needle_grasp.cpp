#include "forces/needle_grasp.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/repeatable.h"
#include "forces/model_input.h"

namespace bodkin::forces {

NeedleGrasp::NeedleGrasp(const anatomy::NeedleGraspSettings& settings) : settings_(settings) {
  check(settings, "needle_grasp");
}

double NeedleGrasp::factor() const noexcept {
  const auto wound = [this](double turns) {
    return turns > 0.0 ? -repeatable::expm1(-turns / settings_.turns_to_wind) : 0.0;
  };
  const double net = std::abs(net_), back = std::max(0.0, total_ - net);
  return settings_.point * (1.0 + std::max(settings_.one_way * wound(net), settings_.two_way * wound(back)));
}

double NeedleGrasp::step(double roll) noexcept {
  if (!(std::abs(roll) <= 1e6)) return factor();
  constexpr double turn = 2.0 * std::numbers::pi;
  if (started_) {
    // The remainder of less than half a turn is itself, and to compute it takes as long as all the rest.
    const double moved =
        std::abs(roll - last_) < 0.5 * turn ? (roll - last_) / turn : std::remainder(roll - last_, turn) / turn;
    net_ += moved;
    total_ += std::abs(moved);
  }
  started_ = true;
  last_ = roll;
  return factor();
}

void NeedleGrasp::reset() noexcept {
  started_ = false;
  last_ = net_ = total_ = 0.0;
}

}  // namespace bodkin::forces
