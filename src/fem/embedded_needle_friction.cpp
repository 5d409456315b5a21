// EmbeddedNeedle: sticking and sliding nodes, and the forces of all nodes.
#include <algorithm>
#include <cmath>

#include "fem/embedded_needle.h"

namespace bodkin::fem {

namespace {

constexpr double slip_tolerance = 1e-9;        // mm, that a sliding node may move by rounding
constexpr double force_tolerance = 1e-9;       // N and relative, above a limit
constexpr int most_rounds = 6;                 // of sticking and slipping in a tick
constexpr int slip_rounds = 1;                 // first rounds, in which nodes may begin to slide
constexpr int most_single_sticks = 6;          // nodes made to stick one by one; more are done together
constexpr std::size_t release_budget = 50000;  // rotated numbers of the factor in a tick, after the first release

}  // namespace

void EmbeddedNeedle::place() noexcept {
  double* d = displacements_.data();
  for (std::size_t i = 0; i < constraints_.known(); ++i) {
    const Vec3 by_itself = moved_otherwise(i);
    d[3 * i] = tip_ - contacts_[i].slip - by_itself(0);
    Eigen::Map<Eigen::Vector2d>(d + 3 * i + 1) =
        axis_offset(depth_now(i)) - contacts_[i].anchor - by_itself.tail<2>();
  }
  constraints_.place(displacements_, root_);
}

// Solves for the constraint forces; the friction of the sliding nodes is a given load.
void EmbeddedNeedle::solve() noexcept {
  const std::size_t known = constraints_.known();
  for (std::size_t i = 0; i < known; ++i) {
    if (!constraints_.constrained_along(i))
      forces_[3 * i] = i < captured_ ? contacts_[i].sense * contacts_[i].limit_towards(contacts_[i].sense) : 0.0;
  }
  constraints_.solve_along(forces_);
  for (std::size_t i = 0; i < known; ++i) {
    contacts_[i].moved =
        constraints_.constrained_along(i) ? tip_ - contacts_[i].slip : constraints_.moved(i) + moved_otherwise(i)(0);
  }
}

// A node that would slide against its friction force sticks at its position of the last tick.
bool EmbeddedNeedle::stick_where_slip_reverses(bool last_round) noexcept {
  std::size_t turning = 0;
  const auto slip_reverses = [this](std::size_t i) {
    const NodeContact& contact = contacts_[i];
    return contact.limit_towards(contact.sense) > force_tolerance &&
           contact.sense * (tip_ - contact.moved - contact.slip) < -slip_tolerance &&
           !constraints_.constrained_along(i);
  };
  for (std::size_t i = 0; i < captured_; ++i) turning += slip_reverses(i) ? 1 : 0;
  if (turning == 0) return false;
  if (turning > most_single_sticks || last_round) {
    constraints_.constrain_all_along();
    return true;
  }
  for (std::size_t i = 0; i < captured_; ++i) {
    if (slip_reverses(i)) constraints_.constrain_along(i);
  }
  return true;
}

// Nodes whose force exceeds their friction limit begin to slide, those with the greatest excess first, as many as the
// budget of the tick allows. The others stick for one more tick, which is elastic and generates no energy.
bool EmbeddedNeedle::slip_where_friction_ends(std::size_t& budget) noexcept {
  double worst = 0.0;
  const auto excess = [this](std::size_t i) {
    const double force = forces_[3 * i], limit = contacts_[i].limit_towards(force);
    return std::abs(force) - limit * (1.0 + force_tolerance) - force_tolerance;
  };
  for (std::size_t i = 0; i < captured_; ++i) {
    if (constraints_.constrained_along(i)) worst = std::max(worst, excess(i));
  }
  if (worst <= 0.0) return false;
  bool released = false;
  for (std::size_t i = captured_; i > 0;) {
    --i;
    if (!constraints_.constrained_along(i) || excess(i) < 0.25 * worst) continue;
    const std::size_t cost = constraints_.release_cost(i);
    if (budget < cost && released) continue;
    if (budget == 0) break;
    budget -= std::min(budget, cost);
    contacts_[i].sense = forces_[3 * i] < 0.0 ? -1.0 : 1.0;
    constraints_.release_along(i);
    released = true;
  }
  return released;
}

// Tip and tissue in front: contact if they would overlap, none if the force would pull.
bool EmbeddedNeedle::update_tip_contact() noexcept {
  if (constraints_.constrained_along(captured_)) {
    if (forces_[3 * captured_] >= 0.0) return false;
    constraints_.release_along(captured_);
    return true;
  }
  if (!blocked() || constraints_.known() <= captured_) return false;
  if (!(tip_ > contacts_[captured_].slip + contacts_[captured_].moved)) return false;
  return constraints_.constrain_before_tip();
}

void EmbeddedNeedle::solve_contacts() noexcept {
  std::size_t budget = release_budget;
  place();
  for (int round = 1;; ++round) {
    solve();
    if (round == most_rounds) break;
    const bool last = round + 1 == most_rounds;
    bool changed = stick_where_slip_reverses(last);
    if (!changed && round <= slip_rounds) changed = slip_where_friction_ends(budget);
    if (update_tip_contact()) changed = true;
    if (!changed) break;
  }
  turn_ = constraints_.solve_across(forces_);
  for (std::size_t i = 0; i < captured_; ++i) {
    NodeContact& contact = contacts_[i];
    bevel_energy_ -= std::max(0.0, -Eigen::Vector2d(forces_[3 * i + 1], forces_[3 * i + 2]).dot(contact.aside));
    contact.aside.setZero();
    if (constraints_.constrained_along(i)) continue;
    const double slip = tip_ - contact.moved;
    bevel_energy_ += forces_[3 * i] * (slip - contact.slip);
    contact.slip = slip;
  }
  if (captured_ > 0) cut_ = std::max(cut_, contacts_[captured_ - 1].slip);
  if (constraints_.known() > captured_ && !constraints_.constrained_along(captured_)) {
    NodeContact& next = contacts_[captured_];
    next.slip = std::max(line()[captured_].depth, std::min(next.slip, tip_ - next.moved));
  }
}

}  // namespace bodkin::fem
