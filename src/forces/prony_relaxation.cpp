#include "forces/prony_relaxation.h"

#include <cmath>

#include "core/repeatable.h"
#include "forces/model_input.h"

namespace bodkin::forces {

PronyRelaxation::PronyRelaxation(std::span<const anatomy::PronyTerm> terms, double dt) : count_(terms.size()) {
  constexpr auto model = "prony_relaxation";
  check_tick(model, dt);
  check_range(model, "number of terms", static_cast<double>(terms.size()), {0.0, static_cast<double>(capacity)}, "");
  double sum = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    check(terms[i], model);
    sum += terms[i].share;
    decay_[i] = repeatable::exp(-dt / terms[i].time);
    gain_[i] = -terms[i].share * terms[i].time / dt * repeatable::expm1(-dt / terms[i].time);
  }
  check_range(model, "sum of the shares", sum, {0.0, 1.0}, "");
  rest_ = 1.0 - sum;
}

double PronyRelaxation::step(double elastic) noexcept {
  if (!(std::abs(elastic) <= 1e6)) return 0.0;
  double force = rest_ * elastic;
  for (std::size_t i = 0; i < count_; ++i) {
    part_[i] = decay_[i] * part_[i] + gain_[i] * (elastic - last_);
    force += part_[i];
  }
  last_ = elastic;
  return force;
}

void PronyRelaxation::reset() noexcept {
  part_.fill(0.0);
  last_ = 0.0;
}

}  // namespace bodkin::forces
