// How an inserted EmbeddedNeedle moves to another corridor.
#include <algorithm>

#include "fem/embedded_needle.h"

namespace bodkin {

void EmbeddedNeedle::take_punctures(const EmbeddedNeedle& other) noexcept {
  auto old = other.names_.begin();
  for (const auto& [name, node] : names_) {
    while (old != other.names_.end() && old->first < name) ++old;
    if (old == other.names_.end()) return;
    if (old->first == name && other.punctured_[old->second] != 0) punctured_[node] = 1;
  }
}

bool EmbeddedNeedle::begin_to_follow(const EmbeddedNeedle& other) noexcept {
  begun_ = false;
  fresh_ = true;
  held_ = 0;
  force_ = {};
  published_.count = 0;
  std::fill(forces_.begin(), forces_.end(), 0.0);
  if (!other.begun_ || other.held_ == 0 || holds_.size() != other.holds_.size() ||
      beam_.has_value() != other.beam_.has_value())
    return false;
  entry_ = other.entry_;
  frame_ = other.frame_;
  constraints_.begin(frame_);
  stations_.clear();
  stations_.look_along(entry_, frame_.col(0));
  for (const InsertionStation& station : other.line()) {
    const std::uint32_t name = other.body_.mesh_nodes[station.node];
    const auto found = std::lower_bound(names_.begin(), names_.end(), std::pair(name, std::uint32_t{0}));
    if (found == names_.end() || found->first != name) break;
    InsertionStation here = station;
    here.node = found->second;
    if (!stations_.add(here)) break;
  }
  return line().size() >= other.held_;
}

FollowState EmbeddedNeedle::follow(const EmbeddedNeedle& other) noexcept {
  if (!other.begun_ || other.held_ == 0) return FollowState::impossible;
  if (other.force_.fault) return FollowState::under_way;
  while (held_ > other.held_) {
    constraints_.pop();
    --held_;
  }
  if (held_ < other.held_) {
    if (held_ >= line().size() || !constraints_.push(line()[held_].node, line()[held_].depth))
      return FollowState::impossible;
    ++held_;
    return FollowState::under_way;
  }
  return take_state_of(other) ? FollowState::done : FollowState::impossible;
}

// The line from here on: what the tip has reached is what it was, what lies before it is where this corridor has it.
bool EmbeddedNeedle::take_line_of(const EmbeddedNeedle& other) noexcept {
  const bool reached = other.held_ < other.line().size() &&
                       (other.tip_ >= other.line()[held_].depth || other.constraints_.held_along(held_));
  if (reached && held_ >= line().size()) return false;
  const std::size_t kept = held_ + (reached ? 1 : 0);
  stations_.go_on(kept, other.tip_, tissues_);
  if (constraints_.known() > held_ && !reached) {  // a node that was let go on the way: it need not be the next
    constraints_.pop();
    if (!constraints_.push(line()[held_ - 1].node, line()[held_ - 1].depth)) return false;
  }
  // One that the tip has not reached has no force yet: step() sees to it, so that this tick has less to do.
  if (reached && held_ < holds_.size() && constraints_.known() == held_) constraints_.face(line()[held_].node);
  return true;
}

// Which nodes stick, as in the other.
void EmbeddedNeedle::take_sticking_of(const EmbeddedNeedle& other) noexcept {
  if (other.constraints_.held_along(held_)) constraints_.hold_before_tip();
  constraints_.hold_all_along();
  for (std::size_t i = 0; i < held_; ++i) {
    if (!other.constraints_.held_along(i)) constraints_.let_slide(i);
  }
}

// Every node keeps its force: its hole and its place on the needle are put to where this corridor has it under the
// forces that there are.
bool EmbeddedNeedle::take_state_of(const EmbeddedNeedle& other) noexcept {
  if (!take_line_of(other)) return false;
  tip_ = other.tip_;
  offset_ = other.offset_;
  slope_ = other.slope_;
  root_ = other.root_;
  side_ = other.side_;
  turn_ = other.turn_;
  spare_ = other.spare_;
  const std::size_t known = constraints_.known();
  std::copy_n(other.forces_.begin(), 3 * held_, forces_.begin());
  std::fill(forces_.begin() + static_cast<std::ptrdiff_t>(3 * held_), forces_.end(), 0.0);
  const bool pushes = known > held_ && other.constraints_.held_along(held_);
  if (pushes) forces_[3 * held_] = other.forces_[3 * held_];
  constraints_.compliance().displace(forces_, displacements_);
  for (std::size_t i = 0; i < held_; ++i) {
    const InsertionStation& station = line()[i];
    const Eigen::Map<const Vec3> moved(displacements_.data() + 3 * i), force(forces_.data() + 3 * i);
    Hold& hold = holds_[i];
    hold = other.holds_[i];
    const ShaftCompliance& shaft = constraints_.compliance();
    hold.compliance = 0.5 * (shaft.row(i, 1)[3 * i + 1] + shaft.row(i, 2)[3 * i + 2]);
    if (hold.softness > 0.0) hold.softness *= hold.compliance / other.holds_[i].compliance;
    hold.moved = moved(0);
    hold.slip = tip_ - moved(0);
    hold.aside.setZero();
    if (hold.softness >= 0.0)
      hold.anchor = shaft_offset(station.depth) - moved.tail<2>() - hold.softness * force.tail<2>();
  }
  const double last = holds_[held_ - 1].softness;
  if (last >= 0.0 && !constraints_.hold_last_across(last)) return false;
  if (known > held_) {
    const double moved = displacements_[3 * held_];
    face_next(moved);
    if (pushes) holds_[held_].slip = tip_ - moved;  // whatever its depth is: it touches the tip
  }
  take_sticking_of(other);
  take_punctures(other);
  begun_ = true;
  fresh_ = false;
  report();
  return true;
}

}  // namespace bodkin
