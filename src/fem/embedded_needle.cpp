#include "fem/embedded_needle.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.h"
#include "fem/upper_triangular.h"

namespace bodkin {

namespace {

constexpr double farthest_pose = 1e4;    // mm; beyond, a sensor failed
constexpr double least_cosine = 0.2;     // between needle and line; a needle that lies across is no insertion
constexpr double least_friction = 1e-9;  // N; below, there is none
constexpr double least_grip = 1e-6;      // part of its length from which on a node is held across
constexpr std::size_t last_cuts = 4;     // nodes behind the tip whose hole a bevel may move aside
constexpr int most_captures = 2;         // a tick; the others wait for the next

void check_contact_setting(double value, double low, double high, const char* name, const char* unit) {
  if (value >= low && value <= high) return;
  throw InputError("needle contact: " + std::string(name) + " is " + std::to_string(value) + " " + unit +
                   ", expected " + std::to_string(low) + " to " + std::to_string(high));
}

const CondensedBody& checked_body(const CondensedBody& body) {
  const std::size_t nodes = body.nodes.size();
  if (nodes > 0 && body.tissues.size() == nodes && static_cast<std::size_t>(body.compliance.rows()) == 3 * nodes) {
    return body;
  }
  throw InputError("needle contact: the corridor has " + std::to_string(nodes) + " nodes, " +
                   std::to_string(body.tissues.size()) + " tissues and a compliance of " +
                   std::to_string(body.compliance.rows()) +
                   " rows; expected as many tissues as nodes and 3 rows for each");
}

std::size_t checked_room(const EmbeddedNeedleSettings& settings) {
  check_contact_setting(settings.capture_radius, 0.05, 20.0, "capture radius", "mm");
  check_contact_setting(settings.spacing, 0.05, 20.0, "spacing", "mm");
  check_contact_setting(settings.puncture_time, 0.001, 1.0, "puncture time", "s");
  check_contact_setting(static_cast<double>(settings.most_nodes), 1.0, static_cast<double>(NodeForces::capacity - 1),
                        "most nodes", "");
  return settings.most_nodes;
}

}  // namespace

EmbeddedNeedle::EmbeddedNeedle(const CondensedBody& body, const ContactTissues& tissues,
                               const EmbeddedNeedleSettings& settings, double dt,
                               const std::optional<NeedleBeam>& beam)
    : body_(checked_body(body)),
      tissues_(tissues),
      settings_(settings),
      dt_(dt),
      beam_(beam),
      stations_(body, settings.capture_radius, settings.spacing),
      constraints_(body.compliance, checked_room(settings), beam_),
      holds_(settings.most_nodes + 1),
      displacements_(upper_triangular::padded(3 * settings.most_nodes + 3), 0.0),
      forces_(3 * settings.most_nodes + 3, 0.0),
      punctured_(body.nodes.size(), 0) {
  check_contact_tissues(tissues);
  check_contact_setting(dt, 1e-6, 0.1, "tick", "s");
  if (body.mesh_nodes.size() != body.nodes.size()) return;  // nameless: it can follow no other
  for (const std::uint32_t name : body.mesh_nodes)
    names_.emplace_back(name, static_cast<std::uint32_t>(names_.size()));
  std::sort(names_.begin(), names_.end());
}

void EmbeddedNeedle::reset() noexcept {
  std::fill(punctured_.begin(), punctured_.end(), std::uint8_t{0});
  begin(Vec3::Zero(), Vec3::UnitZ());
  stations_.clear();
  begun_ = false;
}

void EmbeddedNeedle::begin(const Vec3& entry, const Vec3& direction) noexcept {
  entry_ = entry;
  frame_.col(0) = direction;
  const Vec3 other = std::abs(direction.x()) < 0.6 ? Vec3::UnitX() : Vec3::UnitY();
  frame_.col(1) = direction.cross(other).normalized();
  frame_.col(2) = direction.cross(frame_.col(1));
  stations_.begin(entry, direction, tissues_);
  constraints_.begin(frame_);
  std::fill(forces_.begin(), forces_.end(), 0.0);
  turn_.setZero();
  spare_ = 0.0;
  held_ = 0;
  begun_ = fresh_ = true;
  if (!line().empty()) constraints_.face(line()[0].node);
  force_ = {};
  published_.count = 0;
}

// Whether the node before the tip still has to be punctured.
bool EmbeddedNeedle::blocked() const noexcept {
  return held_ < line().size() && line()[held_].resists && punctured_[line()[held_].node] == 0;
}

// Nodes that the tip has drawn back beyond.
void EmbeddedNeedle::let_go() noexcept {
  while (held_ > 0 && tip_ < line()[held_ - 1].depth) {
    std::fill_n(forces_.begin() + static_cast<std::ptrdiff_t>(3 * held_ - 3), 6, 0.0);
    constraints_.pop();  // it is before the tip again
    --held_;
  }
}

// Where the tip will meet the node before it: at its depth, or here if the tip is beyond that already.
void EmbeddedNeedle::face_next(double moved) noexcept {
  holds_[held_].slip = std::max(line()[held_].depth, tip_ - moved);
  holds_[held_].moved = moved;
}

// The next node comes before the tip. One that does not resist is not needed there until it is taken: it waits for
// the tick after that in which another was taken, which had enough to do.
void EmbeddedNeedle::face_ahead() noexcept {
  if (constraints_.known() > held_ || held_ >= line().size() || held_ >= holds_.size()) return;
  if (constraints_.face(line()[held_].node)) face_next(displacement(held_)(0));
}

bool EmbeddedNeedle::take(std::size_t index) noexcept {
  face_ahead();
  const InsertionStation& station = line()[index];
  Hold& hold = holds_[index];
  const Vec3 moved = displacement(index);
  if (index > 0 && holds_[index - 1].softness != 0.0) soften(0.0);
  if (!constraints_.push(station.node, station.depth)) return false;
  const auto place = static_cast<Eigen::Index>(3) * static_cast<Eigen::Index>(station.node);
  const Mat3 own = frame_.transpose() * body_.compliance.block<3, 3>(place, place) * frame_;
  hold = {};
  hold.compliance = 0.5 * (own(1, 1) + own(2, 2));
  hold.whole = std::min(station.length, settings_.capture_radius);
  hold.moved = moved(0);
  hold.slip = tip_ - moved(0);
  hold.anchor = shaft_offset(station.depth) - moved.tail<2>();
  held_ = index + 1;
  if (blocked()) face_ahead();
  return true;
}

void EmbeddedNeedle::capture() noexcept {
  force_.full = false;
  for (int i = 0; i < most_captures; ++i) {
    if (held_ >= line().size() || blocked() || tip_ < line()[held_].depth) return;
    const InsertionStation& station = line()[held_];
    if (!take(held_)) {
      force_.full = true;
      return;
    }
    // One that the tip has left behind while tissue held it back sticks where it is; a fresh one slides, with as
    // little friction as there is shaft in it.
    const bool rubs = tissues_[station.tissue].friction * station.length > least_friction;
    if (rubs && tip_ >= station.depth + station.length) constraints_.hold_along(held_ - 1);
  }
}

// Another softness of the last node across the needle. One that grows does so where the node is, one that shrinks
// with the force that the node has: either way energy is lost, not won.
void EmbeddedNeedle::soften(double softness) noexcept {
  Hold& hold = holds_[held_ - 1];
  if (softness == hold.softness) return;
  if (softness < 0.0) {
    constraints_.release_last_across();
    forces_[3 * held_ - 2] = forces_[3 * held_ - 1] = 0.0;
  } else {
    const Eigen::Vector2d force(forces_[3 * held_ - 2], forces_[3 * held_ - 1]);
    if (hold.softness < 0.0) {
      const Vec3 moved = displacement(held_ - 1);
      hold.anchor = shaft_offset(line()[held_ - 1].depth) - moved.tail<2>();
    } else if (softness < hold.softness) {
      hold.anchor += (hold.softness - softness) * force;
    }
    if (!constraints_.hold_last_across(softness)) softness = -1.0;
  }
  hold.softness = softness;
}

// How much of the needle each node has got hold of.
void EmbeddedNeedle::grip() noexcept {
  for (std::size_t i = 0; i < held_; ++i) {
    const InsertionStation& station = line()[i];
    const double length = std::clamp(tip_ - station.depth, 0.0, station.length);
    Hold& hold = holds_[i];
    hold.tear = std::max(0.0, hold.tear - tissues_[station.tissue].puncture_force * dt_ / settings_.puncture_time);
    hold.limit = tissues_[station.tissue].friction * length + hold.tear;
  }
  if (held_ == 0) return;
  const InsertionStation& last = line()[held_ - 1];
  const double part = std::clamp((tip_ - last.depth) / holds_[held_ - 1].whole, 0.0, 1.0);
  soften(part < least_grip ? -1.0 : holds_[held_ - 1].compliance * (1.0 / part - 1.0));
}

// The bevel: the hole of a node that is firmly held moves aside while the tip goes through the part of the next, as
// far as friction has paid for it.
void EmbeddedNeedle::cut_aside(double advance) noexcept {
  if (!beam_ || beam_->settings().cut_offset == 0.0 || !(advance > 0.0)) return;
  double used = 0.0;
  for (std::size_t i = held_ - std::min(held_, last_cuts); i + 1 < held_; ++i) {
    Hold& hold = holds_[i];
    const InsertionStation& next = line()[i + 1];
    const double whole = std::min(next.length, settings_.capture_radius);
    const double cut = std::clamp((tip_ - next.depth) / whole, hold.cut, 1.0);
    const Eigen::Vector2d aside = beam_->settings().cut_offset * (cut - hold.cut) * side_;
    const double force = Eigen::Vector2d(forces_[3 * i + 1], forces_[3 * i + 2]).norm();
    used += force * aside.norm() + 2.0 * aside.squaredNorm() / hold.compliance;
    if (used > spare_) continue;
    hold.anchor += aside;
    hold.aside = aside;
    hold.cut = cut;
  }
}

void EmbeddedNeedle::puncture() noexcept {
  if (!blocked() || !constraints_.held_along(held_)) return;
  const InsertionStation& station = line()[held_];
  const double strength = tissues_[station.tissue].puncture_force;
  const double force = forces_[3 * held_];
  if (force < strength) return;
  const double slip = holds_[held_].slip;
  if (!take(held_)) {
    force_.full = true;
    return;
  }
  punctured_[station.node] = 1;
  Hold& hold = holds_[held_ - 1];
  hold.slip = slip;
  hold.tear = hold.limit = force;
  force_.puncture = TissuePuncture{station.tissue, tip_, force};
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
    published_.count = 0;
    return force_;
  }
  const Vec3 place = frame_.transpose() * from_entry;
  const Vec3 lean = frame_.transpose() * axis;
  const double advance = fresh_ ? 0.0 : place(0) - tip_;
  tip_ = place(0);
  offset_ = place.tail<2>();
  slope_ = lean.tail<2>() / lean(0);
  if (beam_) {
    root_ = beam_->root(tip_ + pressed);
    const Vec3 across = needle.linear().col(1);
    const bool known = std::abs(across.squaredNorm() - 1.0) < 1e-6;
    side_ = known ? Eigen::Vector2d(-(frame_.transpose() * across).tail<2>()) : Eigen::Vector2d(0.0, 0.0);
  }
  if (begun_) {
    if (fresh_ && !line().empty()) face_next(0.0);
    fresh_ = false;
    // After a take-over nothing is before the tip yet.
    if (held_ > 0 && held_ < std::min(line().size(), holds_.size()) && constraints_.known() == held_ &&
        constraints_.face(line()[held_].node))
      face_next(displacement(held_)(0));
    let_go();
    face_ahead();
    capture();
    grip();
    cut_aside(advance);
    settle();
    puncture();
  }
  report();
  return force_;
}

}  // namespace bodkin
