#include "fem/embedded_needle.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Geometry>

#include "core/error.h"
#include "core/shortest_turn.h"
#include "fem/upper_triangular.h"

namespace bodkin::fem {

namespace {

constexpr double farthest_pose = 1e4;         // mm; a position farther away is a sensor fault
constexpr double least_cosine = 0.2;          // between needle and line; below it, the needle is not being inserted
constexpr double least_friction = 1e-9;       // N; less counts as no friction
constexpr double least_captured_part = 1e-6;  // of the full-capture length; below it there is no lateral constraint
constexpr double same_hole = 1.0;             // mm
constexpr std::size_t bevelled_nodes = 4;     // behind the tip, whose holes a bevel can move
constexpr int most_captures = 2;              // per tick; the others follow in later ticks
constexpr double carry_time = 0.02;           // s, in which tissue that moves by itself covers most of a step

const anatomy::CondensedBody& checked_body(const anatomy::CondensedBody& body) {
  const std::size_t nodes = body.nodes.size();
  if (nodes > 0 && body.tissues.size() == nodes && static_cast<std::size_t>(body.compliance.rows()) == 3 * nodes &&
      (!body.has_contact_points() || body.in_mesh.size() == nodes)) {
    return body;
  }
  throw InputError("needle contact: the body has " + std::to_string(nodes) + " points, " +
                   std::to_string(body.tissues.size()) + " tissues and a compliance of " +
                   std::to_string(body.compliance.rows()) +
                   " rows; expected as many tissues as points and 3 rows for each");
}

std::size_t checked_room(const anatomy::EmbeddedNeedleSettings& settings) {
  check(settings, "embedded_needle");
  check_range("embedded_needle", "most nodes", static_cast<double>(settings.most_nodes),
              {1.0, static_cast<double>(NodeForces::most_contacts - 1)}, "");
  return settings.most_nodes;
}

}  // namespace

EmbeddedNeedle::EmbeddedNeedle(const anatomy::CondensedBody& body, const ContactTissues& tissues,
                               const anatomy::EmbeddedNeedleSettings& settings, double dt,
                               const std::optional<NeedleBeam>& beam, const Eigen::MatrixXd* other,
                               const NeedleRelaxation& relaxation)
    : body_(checked_body(body)),
      tissues_(tissues),
      settings_(settings),
      dt_(dt),
      beam_(beam),
      contact_nodes_(body),
      constraints_(body.compliance, checked_room(settings), beam_),
      relaxing_(relaxation.terms, dt, settings.most_nodes + 1, relaxation.spring),
      other_(other == nullptr ? nullptr : std::make_unique<ShaftConstraints>(*other, settings.most_nodes, beam_)),
      contacts_(settings.most_nodes + 1),
      displacements_(upper_triangular::padded(3 * settings.most_nodes + 3), 0.0),
      forces_(3 * settings.most_nodes + 3, 0.0),
      punctured_(body.nodes.size(), 0),
      carried_(body.nodes.size(), Vec3::Zero()) {
  check_contact_tissues(tissues);
  check_tick("embedded_needle", dt);
}

ContactNumbers EmbeddedNeedle::numbers() const noexcept {
  return {tissues_, settings_.capture_radius, settings_.puncture_time, 0.0};
}

void EmbeddedNeedle::set_numbers(const ContactNumbers& numbers) noexcept {
  tissues_ = numbers.tissues;
  settings_.capture_radius = numbers.capture_radius;
  settings_.puncture_time = numbers.time;
}

void EmbeddedNeedle::reset() noexcept {
  std::fill(punctured_.begin(), punctured_.end(), std::uint8_t{0});
  start(Vec3::Zero(), Vec3::UnitZ());  // reads no data of the body, which may be growing
  contact_nodes_.clear();
  begun_ = false;
  field_ = {};
  breath_ = {};
}

// mm, LPS, displacement of a point by the body's own motion.
Vec3 EmbeddedNeedle::goal(std::uint32_t point) const noexcept {
  Vec3 breathed = Vec3::Zero();
  if (breath_.field != nullptr)
    breathed = breath_.field->moved(body_.nodes[point], breath_.drawn_in) - breath_.of_frame;
  if (field_.empty() || point >= body_.in_mesh.size()) return breathed;
  const anatomy::PlaceInElement& place = body_.in_mesh[point];
  Vec3 moved = Vec3::Zero();
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const std::size_t at = 3 * std::size_t{place.nodes[corner]};
    if (at + 3 > field_.size()) return breathed;
    moved += place.weights[corner] * Eigen::Map<const Eigen::Vector3f>(field_.data() + at).cast<double>();
  }
  return breathed + moved;
}

void EmbeddedNeedle::place_new_points() noexcept {
  for (; placed_ < line().size(); ++placed_) {
    Vec3& here = carried_[line()[placed_].index];
    here = goal(line()[placed_].index);
    moves_ = moves_ || here != Vec3::Zero();
  }
}

bool EmbeddedNeedle::move_with(std::span<const float> of_mesh, const BodyBreath& breath) noexcept {
  field_ = of_mesh;
  breath_ = breath;
  if (field_.empty() && breath_.field == nullptr && !moves_) return false;
  const double share = std::min(1.0, dt_ / carry_time);
  moves_ = false;
  for (const ContactNode& node : line()) {
    Vec3& here = carried_[node.index];
    here += share * (goal(node.index) - here);
    moves_ = moves_ || here != Vec3::Zero();
  }
  return moves_;
}

Pose EmbeddedNeedle::carried_along_shaft() const noexcept {
  Pose motion = Pose::Identity();
  if (!begun_ || captured_ == 0 || !moves_) return motion;
  const auto count = static_cast<double>(captured_);
  double middle = 0.0;  // mm, depth
  Vec3 moved = Vec3::Zero();
  for (std::size_t i = 0; i < captured_; ++i) {
    middle += line()[i].depth / count;
    moved += carried_[line()[i].index] / count;
  }
  // Points at s from their middle: the closest of all lines runs along the sum of s x.
  const Vec3 along = frame_.col(0);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < captured_; ++i) {
    const double from_middle = line()[i].depth - middle;
    sum += from_middle * (from_middle * along + carried_[line()[i].index]);
  }
  if (sum.dot(along) > least_cosine * sum.norm()) motion.linear() = shortest_turn(along, sum).toRotationMatrix();
  const Vec3 place = entry_ + middle * along;
  motion.translation() = place + moved - motion.linear() * place;
  return motion;
}

void EmbeddedNeedle::open(const Vec3& place, anatomy::TissueId tissue) noexcept {
  for (const ContactNode& node : line()) {
    if (node.tissue == tissue && (body_.nodes[node.index] - place).squaredNorm() < same_hole * same_hole)
      punctured_[node.index] = punctured_before;
  }
}

void EmbeddedNeedle::begin(const Vec3& entry, const Vec3& direction) noexcept {
  start(entry, direction);
  std::replace(punctured_.begin(), punctured_.end(), punctured_now, punctured_before);
  contact_nodes_.begin(entry, direction, tissues_);
  place_new_points();
  if (!line().empty()) constraints_.add_before_tip(line()[0].index);
  relaxing_.added(constraints_.compliance());
}

void EmbeddedNeedle::begin_growing(const Vec3& entry, const Vec3& direction,
                                   const ProvisionalSurface& surface) noexcept {
  start(entry, direction);
  surface_ = surface;
  contact_nodes_.begin_growing(entry, direction);
  std::fill(punctured_.begin(), punctured_.end(), std::uint8_t{0});
}

// The first point takes over the force of the provisional surface, as far as the tip is deep enough.
void EmbeddedNeedle::extend(std::size_t points, bool complete) noexcept {
  surface_.is_missing = complete && points == 0;
  const bool first = line().empty();
  const bool grew = contact_nodes_.grow(points, tissues_);
  place_new_points();
  if (!grew || !first || line().empty()) return;
  constraints_.add_before_tip(line()[0].index);
  relaxing_.added(constraints_.compliance());
  if (!fresh_) place_tip_contact(constraints_.compliance().row(0, 0)[0] * provisional_ + carried(0)(0));
  provisional_ = 0.0;
}

void EmbeddedNeedle::keep_first(std::size_t points) noexcept {
  contact_nodes_.keep_first(std::max(points, constraints_.known()));
  relaxing_.drop_removed();
  placed_ = std::min(placed_, line().size());
  std::fill(punctured_.begin() + static_cast<std::ptrdiff_t>(line().size()), punctured_.end(), std::uint8_t{0});
}

// N, of a surface whose contact point is not available yet. If there will be none, it fades.
double EmbeddedNeedle::provisional_force() noexcept {
  if (!line().empty() || !(surface_.compliance > 0.0)) return 0.0;
  if (surface_.is_missing)
    surface_.strength = std::max(0.0, surface_.strength - surface_.strength * dt_ / settings_.puncture_time);
  return std::clamp(tip_ / surface_.compliance, 0.0, surface_.strength);
}

void EmbeddedNeedle::start(const Vec3& entry, const Vec3& direction) noexcept {
  entry_ = entry;
  frame_.col(0) = direction;
  const Vec3 other = std::abs(direction.x()) < 0.6 ? Vec3::UnitX() : Vec3::UnitY();
  frame_.col(1) = direction.cross(other).normalized();
  frame_.col(2) = direction.cross(frame_.col(1));
  constraints_.begin(frame_);
  relaxing_.clear();
  std::fill(forces_.begin(), forces_.end(), 0.0);
  turn_.setZero();
  bevel_energy_ = provisional_ = cut_ = 0.0;
  surface_ = {};
  captured_ = placed_ = 0;
  moves_ = false;
  exchanging_ = false;
  begun_ = fresh_ = true;
  force_ = {};
  published_.count = elastic_.count = 0;
}

// Whether the node in front of the tip still has to be punctured.
bool EmbeddedNeedle::blocked() const noexcept {
  return captured_ < line().size() && line()[captured_].resists && punctured_[line()[captured_].index] == 0;
}

// Removes the nodes from which the tip has been withdrawn.
void EmbeddedNeedle::release_withdrawn() noexcept {
  while (captured_ > 0 && tip_ < depth_now(captured_ - 1)) {
    std::fill_n(forces_.begin() + static_cast<std::ptrdiff_t>(3 * captured_ - 3), 6, 0.0);
    if (constraints_.known() > captured_) relaxing_.removing_last(constraints_.compliance());
    constraints_.pop();  // the node is in front of the tip again
    --captured_;
  }
}

// Sets the contact of the tip with the node in front: at the node's depth, or here if the tip is deeper already.
void EmbeddedNeedle::place_tip_contact(double moved) noexcept {
  contacts_[captured_].slip = std::max(line()[captured_].depth, tip_ - moved);
  contacts_[captured_].moved = moved;
}

// Adds the next node in front of the tip. A node without a puncture is not used before its capture; it is added in
// the tick after another capture, which bounds the cost of a tick.
void EmbeddedNeedle::add_next_before_tip() noexcept {
  if (constraints_.known() > captured_ || captured_ >= line().size() || captured_ >= contacts_.size()) return;
  if (!constraints_.add_before_tip(line()[captured_].index)) return;
  relaxing_.added(constraints_.compliance());
  place_tip_contact(displacement(captured_)(0));
}

bool EmbeddedNeedle::capture_node(std::size_t index) noexcept {
  add_next_before_tip();
  const ContactNode& node = line()[index];
  NodeContact& contact = contacts_[index];
  const Vec3 moved = displacement(index);
  if (index > 0 && contacts_[index - 1].lateral_compliance != 0.0) set_lateral_compliance(0.0);
  const bool pushed = constraints_.push(node.index, node.depth);
  relaxing_.added(constraints_.compliance());
  if (!pushed) return false;
  const ShaftCompliance& compliance = constraints_.compliance();
  contact = {};
  contact.whole = is_whole(index);
  contact.own_compliance = 0.5 * (compliance.row(index, 1)[3 * index + 1] + compliance.row(index, 2)[3 * index + 2]);
  contact.full_capture_length = std::min(node.length, settings_.capture_radius);
  contact.moved = moved(0);
  contact.slip = tip_ - advance_ - moved(0);  // before this tick, as `moved` is: what sticks moves with the needle
  contact.anchor = shaft_offset(index) - moved.tail<2>();
  captured_ = index + 1;
  if (blocked()) add_next_before_tip();
  return true;
}

void EmbeddedNeedle::capture() noexcept {
  force_.full = false;
  for (int i = 0; i < most_captures; ++i) {
    if (captured_ >= line().size() || blocked() || !comes_to_next()) return;
    const ContactNode& node = line()[captured_];
    const bool at_cut = is_at_cut();
    if (!capture_node(captured_)) {
      force_.full = true;
      return;
    }
    if (at_cut) cut_ = contacts_[captured_ - 1].slip;
    // A node that the tip passed while a puncture was pending starts sticking; a newly reached node starts sliding,
    // with the friction of the short piece of shaft in its part of the line.
    const bool rubs = tissues_[node.tissue].friction * node.length > least_friction;
    if (rubs && tip_ >= depth_now(captured_ - 1) + node.length) constraints_.constrain_along(captured_ - 1);
  }
}

// Changes the lateral compliance of the last node: a growing one at constant displacement, a shrinking one at
// constant force. Both dissipate energy.
void EmbeddedNeedle::set_lateral_compliance(double lateral_compliance) noexcept {
  NodeContact& contact = contacts_[captured_ - 1];
  if (lateral_compliance == contact.lateral_compliance) return;
  if (lateral_compliance < 0.0) {
    constraints_.release_last_across();
    forces_[3 * captured_ - 2] = forces_[3 * captured_ - 1] = 0.0;
  } else {
    const Eigen::Vector2d force(forces_[3 * captured_ - 2], forces_[3 * captured_ - 1]);
    if (contact.lateral_compliance < 0.0) {
      const Vec3 moved = displacement(captured_ - 1);
      contact.anchor = shaft_offset(captured_ - 1) - moved.tail<2>();
    } else if (lateral_compliance < contact.lateral_compliance) {
      contact.anchor += (contact.lateral_compliance - lateral_compliance) * force;
    }
    if (!constraints_.constrain_last_across(lateral_compliance)) lateral_compliance = -1.0;
  }
  contact.lateral_compliance = lateral_compliance;
}

// Updates each node's friction limit, and the lateral compliance of the last node.
void EmbeddedNeedle::update_capture() noexcept {
  for (std::size_t i = 0; i < captured_; ++i) {
    const ContactNode& node = line()[i];
    const double length = std::clamp(tip_ - depth_now(i), 0.0, node.length);
    NodeContact& contact = contacts_[i];
    contact.puncture_residual =
        std::max(0.0, contact.puncture_residual - contact.fading * dt_ / settings_.puncture_time);
    contact.limit = tissues_[node.tissue].friction * length + contact.puncture_residual;
  }
  update_cutting();
  if (captured_ == 0) return;
  const double part =
      std::clamp((tip_ - depth_now(captured_ - 1)) / contacts_[captured_ - 1].full_capture_length, 0.0, 1.0);
  set_lateral_compliance(part < least_captured_part ? -1.0
                                                    : contacts_[captured_ - 1].own_compliance * (1.0 / part - 1.0));
}

// The bevel moves the hole of a node with a rigid constraint sideways while the tip passes through the next node's
// part of the line, as far as friction has dissipated enough energy.
void EmbeddedNeedle::cut_aside() noexcept {
  if (!beam_ || beam_->settings().cut_offset == 0.0 || !(advance_ > 0.0)) return;
  double used = 0.0;
  for (std::size_t i = captured_ - std::min(captured_, bevelled_nodes); i + 1 < captured_; ++i) {
    NodeContact& contact = contacts_[i];
    const ContactNode& next = line()[i + 1];
    const double full_capture_length = std::min(next.length, settings_.capture_radius);
    const double cut = std::clamp((tip_ - depth_now(i + 1)) / full_capture_length, contact.cut, 1.0);
    const Eigen::Vector2d aside = beam_->settings().cut_offset * (cut - contact.cut) * side_;
    const double force = Eigen::Vector2d(forces_[3 * i + 1], forces_[3 * i + 2]).norm();
    used += force * aside.norm() + 2.0 * aside.squaredNorm() / contact.own_compliance;
    if (used > bevel_energy_) continue;
    contact.anchor += aside;
    contact.aside = aside;
    contact.cut = cut;
  }
}

void EmbeddedNeedle::puncture() noexcept {
  if (!blocked() || !constraints_.constrained_along(captured_)) return;
  const ContactNode& node = line()[captured_];
  const double strength = tissues_[node.tissue].puncture_force;
  const double force = forces_[3 * captured_];
  if (force < strength) return;
  const double slip = contacts_[captured_].slip;
  if (!capture_node(captured_)) {
    force_.full = true;
    return;
  }
  punctured_[node.index] = punctured_now;
  NodeContact& contact = contacts_[captured_ - 1];
  contact.slip = cut_ = slip;
  contact.puncture_residual = contact.limit = force;
  contact.fading = strength;
  force_.puncture = TissuePuncture{node.tissue, tip_, force, body_.nodes[node.index]};
}

const EmbeddedNeedleForce& EmbeddedNeedle::step(const Pose& needle, double pressed) noexcept {
  force_.fault = false;
  force_.puncture.reset();
  const Vec3 axis = needle.linear().col(2);
  const Vec3 from_entry = needle.translation() - entry_;
  const double cosine = axis.dot(frame_.col(0));
  if (!(from_entry.squaredNorm() <= farthest_pose * farthest_pose) || !(cosine >= least_cosine) ||
      !(std::abs(axis.squaredNorm() - 1.0) < 1e-6)) {
    force_ = {};
    force_.fault = true;
    published_.count = elastic_.count = 0;
    return force_;
  }
  const Vec3 place = frame_.transpose() * from_entry;
  const Vec3 tilted = frame_.transpose() * axis;
  advance_ = fresh_ ? 0.0 : place(0) - tip_;
  tip_ = place(0);
  offset_ = place.tail<2>();
  slope_ = tilted.tail<2>() / tilted(0);
  if (beam_) {
    root_ = beam_->root(tip_ + pressed);
    const Vec3 across = needle.linear().col(1);
    const bool known = std::abs(across.squaredNorm() - 1.0) < 1e-6;
    side_ = known ? Eigen::Vector2d(-(frame_.transpose() * across).tail<2>()) : Eigen::Vector2d(0.0, 0.0);
  }
  if (begun_) {
    relaxing_.step(constraints_.compliance(), forces_);
    if (exchanging_) prepare_exchange();
    if (fresh_ && !line().empty()) place_tip_contact(carried(0)(0));
    fresh_ = false;
    release_withdrawn();
    add_next_before_tip();
    capture();
    update_capture();
    cut_aside();
    solve_contacts();
    puncture();
    provisional_ = provisional_force();
  }
  report();
  return force_;
}

}  // namespace bodkin::fem
