// EmbeddedNeedle: transfer of an inserted needle to another corridor.
#include <algorithm>

#include "fem/embedded_needle.h"

namespace bodkin::fem {

namespace {

constexpr double same_hole = 1.0;  // mm

}  // namespace

// Contact points of two lines are the same hole when they lie close together in one tissue.
void EmbeddedNeedle::take_punctures_of_points(const EmbeddedNeedle& other) noexcept {
  for (std::size_t old = 0; old < other.punctured_.size(); ++old) {
    if (other.punctured_[old] == 0) continue;
    for (std::size_t here = 0; here < punctured_.size(); ++here) {
      const double away = (body_.nodes[here] - other.body_.nodes[old]).squaredNorm();
      if (body_.tissues[here] == other.body_.tissues[old] && away < same_hole * same_hole) punctured_[here] = 1;
    }
  }
}

void EmbeddedNeedle::open(const Vec3& place, anatomy::TissueId tissue) noexcept {
  for (const ContactNode& node : line()) {
    if (node.tissue == tissue && (body_.nodes[node.index] - place).squaredNorm() < same_hole * same_hole)
      punctured_[node.index] = 1;
  }
}

void EmbeddedNeedle::take_punctures(const EmbeddedNeedle& other) noexcept {
  if (body_.has_contact_points() && other.body_.has_contact_points()) take_punctures_of_points(other);
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
  captured_ = 0;
  force_ = {};
  published_.count = 0;
  std::fill(forces_.begin(), forces_.end(), 0.0);
  if (!other.begun_ || other.captured_ == 0 || contacts_.size() != other.contacts_.size() ||
      beam_.has_value() != other.beam_.has_value())
    return false;
  entry_ = other.entry_;
  frame_ = other.frame_;
  constraints_.begin(frame_);
  contact_nodes_.clear();
  contact_nodes_.find_candidates(entry_, frame_.col(0));
  for (const ContactNode& node : other.line()) {
    const std::uint32_t name = other.body_.mesh_nodes[node.index];
    const auto found = std::lower_bound(names_.begin(), names_.end(), std::pair(name, std::uint32_t{0}));
    if (found == names_.end() || found->first != name) break;
    ContactNode here = node;
    here.index = found->second;
    if (!contact_nodes_.add(here)) break;
  }
  return line().size() >= other.captured_;
}

FollowState EmbeddedNeedle::follow(const EmbeddedNeedle& other) noexcept {
  if (!other.begun_ || other.captured_ == 0) return FollowState::impossible;
  if (other.force_.fault) return FollowState::under_way;
  while (captured_ > other.captured_) {
    constraints_.pop();
    --captured_;
  }
  if (captured_ < other.captured_) {
    if (captured_ >= line().size() || !constraints_.push(line()[captured_].index, line()[captured_].depth))
      return FollowState::impossible;
    ++captured_;
    return FollowState::under_way;
  }
  return take_state_of(other) ? FollowState::done : FollowState::impossible;
}

// The nodes that the tip has reached are those of `other`; those deeper are at this corridor's positions.
bool EmbeddedNeedle::take_line_of(const EmbeddedNeedle& other) noexcept {
  const bool reached = other.captured_ < other.line().size() && (other.tip_ >= other.line()[captured_].depth ||
                                                                 other.constraints_.constrained_along(captured_));
  if (reached && captured_ >= line().size()) return false;
  const std::size_t kept = captured_ + (reached ? 1 : 0);
  contact_nodes_.continue_from(kept, other.tip_, tissues_);
  if (constraints_.known() > captured_ &&
      !reached) {  // a node withdrawn during the transfer, which need not be the next one
    constraints_.pop();
    if (!constraints_.push(line()[captured_ - 1].index, line()[captured_ - 1].depth)) return false;
  }
  // A node that the tip has not reached has no force yet; step() adds it, which keeps this tick short.
  if (reached && captured_ < contacts_.size() && constraints_.known() == captured_)
    constraints_.add_before_tip(line()[captured_].index);
  return true;
}

// The same nodes stick as in `other`.
void EmbeddedNeedle::take_sticking_of(const EmbeddedNeedle& other) noexcept {
  if (other.constraints_.constrained_along(captured_)) constraints_.constrain_before_tip();
  constraints_.constrain_all_along();
  for (std::size_t i = 0; i < captured_; ++i) {
    if (!other.constraints_.constrained_along(i)) constraints_.release_along(i);
  }
}

// Each node keeps its force. Its hole and its position on the needle are set to where this corridor's compliance has
// the node under these forces.
bool EmbeddedNeedle::take_state_of(const EmbeddedNeedle& other) noexcept {
  if (!take_line_of(other)) return false;
  tip_ = other.tip_;
  offset_ = other.offset_;
  slope_ = other.slope_;
  root_ = other.root_;
  side_ = other.side_;
  turn_ = other.turn_;
  bevel_energy_ = other.bevel_energy_;
  const std::size_t known = constraints_.known();
  std::copy_n(other.forces_.begin(), 3 * captured_, forces_.begin());
  std::fill(forces_.begin() + static_cast<std::ptrdiff_t>(3 * captured_), forces_.end(), 0.0);
  const bool pushes = known > captured_ && other.constraints_.constrained_along(captured_);
  if (pushes) forces_[3 * captured_] = other.forces_[3 * captured_];
  constraints_.compliance().displace(forces_, displacements_);
  for (std::size_t i = 0; i < captured_; ++i) {
    const ContactNode& node = line()[i];
    const Eigen::Map<const Vec3> moved(displacements_.data() + 3 * i), force(forces_.data() + 3 * i);
    NodeContact& contact = contacts_[i];
    contact = other.contacts_[i];
    const ShaftCompliance& shaft = constraints_.compliance();
    contact.own_compliance = 0.5 * (shaft.row(i, 1)[3 * i + 1] + shaft.row(i, 2)[3 * i + 2]);
    if (contact.lateral_compliance > 0.0)
      contact.lateral_compliance *= contact.own_compliance / other.contacts_[i].own_compliance;
    contact.moved = moved(0);
    contact.slip = tip_ - moved(0);
    contact.aside.setZero();
    if (contact.lateral_compliance >= 0.0)
      contact.anchor = shaft_offset(node.depth) - moved.tail<2>() - contact.lateral_compliance * force.tail<2>();
  }
  const double last = contacts_[captured_ - 1].lateral_compliance;
  if (last >= 0.0 && !constraints_.constrain_last_across(last)) return false;
  if (known > captured_) {
    const double moved = displacements_[3 * captured_];
    place_tip_contact(moved);
    if (pushes) contacts_[captured_].slip = tip_ - moved;  // in contact with the tip, whatever its depth
  }
  take_sticking_of(other);
  take_punctures(other);
  begun_ = true;
  fresh_ = false;
  report();
  return true;
}

}  // namespace bodkin::fem
