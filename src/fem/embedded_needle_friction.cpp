// Which nodes of an EmbeddedNeedle stick and which slide, and the forces of all.
#include <algorithm>
#include <cmath>

#include "fem/embedded_needle.h"

namespace bodkin {

namespace {

constexpr double slip_tolerance = 1e-9;        // mm that rounding may move a node that slides
constexpr double force_tolerance = 1e-9;       // N and relative, above a limit
constexpr int most_rounds = 6;                 // of sticking and slipping a tick
constexpr int slip_rounds = 1;                 // the first of them, in which nodes may begin to slide
constexpr int few_turns = 6;                   // nodes that are made to stick one by one
constexpr std::size_t release_budget = 50000;  // numbers of the factor to be turned a tick, beyond the first release

}  // namespace

void EmbeddedNeedle::place() noexcept {
  double* d = displacements_.data();
  for (std::size_t i = 0; i < constraints_.known(); ++i) {
    d[3 * i] = tip_ - holds_[i].slip;
    Eigen::Map<Eigen::Vector2d>(d + 3 * i + 1) = axis_offset(line()[i].depth) - holds_[i].anchor;
  }
  constraints_.place(displacements_, root_);
}

// What slides is a load: the others are held as far from where it would leave them.
void EmbeddedNeedle::solve() noexcept {
  const std::size_t known = constraints_.known();
  for (std::size_t i = 0; i < known; ++i) {
    if (!constraints_.held_along(i)) forces_[3 * i] = i < held_ ? holds_[i].sense * holds_[i].limit : 0.0;
  }
  constraints_.solve_along(forces_);
  for (std::size_t i = 0; i < known; ++i) {
    holds_[i].moved = constraints_.held_along(i) ? tip_ - holds_[i].slip : constraints_.moved(i);
  }
}

// Nodes that would slide against the friction that drives them stick where they were at the last tick.
bool EmbeddedNeedle::stick_where_slip_turned(bool last_round) noexcept {
  std::size_t turned = 0;
  const auto turns = [this](std::size_t i) {
    const Hold& hold = holds_[i];
    return hold.limit > force_tolerance && hold.sense * (tip_ - hold.moved - hold.slip) < -slip_tolerance &&
           !constraints_.held_along(i);
  };
  for (std::size_t i = 0; i < held_; ++i) turned += turns(i) ? 1 : 0;
  if (turned == 0) return false;
  if (turned > few_turns || last_round) {
    constraints_.hold_all_along();
    return true;
  }
  for (std::size_t i = 0; i < held_; ++i) {
    if (turns(i)) constraints_.hold_along(i);
  }
  return true;
}

// Nodes that are held by more than their friction begin to slide, the worst first and as many as the tick can bear.
// One that waits is held a little longer: that is elastic and gives no energy.
bool EmbeddedNeedle::slip_where_friction_ends(std::size_t& budget) noexcept {
  double worst = 0.0;
  const auto excess = [this](std::size_t i) {
    return std::abs(forces_[3 * i]) - holds_[i].limit * (1.0 + force_tolerance) - force_tolerance;
  };
  for (std::size_t i = 0; i < held_; ++i) {
    if (constraints_.held_along(i)) worst = std::max(worst, excess(i));
  }
  if (worst <= 0.0) return false;
  bool released = false;
  for (std::size_t i = held_; i > 0;) {
    --i;
    if (!constraints_.held_along(i) || excess(i) < 0.25 * worst) continue;
    const std::size_t cost = constraints_.release_cost(i);
    if (budget < cost && released) continue;
    if (budget == 0) break;
    budget -= std::min(budget, cost);
    holds_[i].sense = forces_[3 * i] < 0.0 ? -1.0 : 1.0;
    constraints_.let_slide(i);
    released = true;
  }
  return released;
}

// The tip and the tissue before it touch where they would overlap, and part where they would pull.
bool EmbeddedNeedle::meet_tip() noexcept {
  if (constraints_.held_along(held_)) {
    if (forces_[3 * held_] >= 0.0) return false;
    constraints_.let_slide(held_);
    return true;
  }
  if (!blocked() || constraints_.known() <= held_) return false;
  if (!(tip_ > holds_[held_].slip + holds_[held_].moved)) return false;
  return constraints_.hold_before_tip();
}

void EmbeddedNeedle::settle() noexcept {
  std::size_t budget = release_budget;
  place();
  for (int round = 1;; ++round) {
    solve();
    if (round == most_rounds) break;
    const bool last = round + 1 == most_rounds;
    bool changed = stick_where_slip_turned(last);
    if (!changed && round <= slip_rounds) changed = slip_where_friction_ends(budget);
    if (meet_tip()) changed = true;
    if (!changed) break;
  }
  turn_ = constraints_.solve_across(forces_);
  for (std::size_t i = 0; i < held_; ++i) {
    Hold& hold = holds_[i];
    spare_ -= std::max(0.0, -Eigen::Vector2d(forces_[3 * i + 1], forces_[3 * i + 2]).dot(hold.aside));
    hold.aside.setZero();
    if (constraints_.held_along(i)) continue;
    const double slip = tip_ - hold.moved;
    spare_ += forces_[3 * i] * (slip - hold.slip);
    hold.slip = slip;
  }
  if (constraints_.known() > held_ && !constraints_.held_along(held_)) {
    Hold& next = holds_[held_];
    next.slip = std::max(line()[held_].depth, std::min(next.slip, tip_ - next.moved));
  }
}

}  // namespace bodkin
