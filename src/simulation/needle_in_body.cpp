#include "simulation/needle_in_body.h"

#include <cmath>
#include <span>
#include <utility>

namespace bodkin::simulation {

namespace {

constexpr double same_line = 1.5;       // mm, between the planned line and the needle's
constexpr double same_aim = 1.0;        // mm, between the line asked for and that of a needle outside
constexpr double farthest_skin = 50.0;  // mm before the tip
constexpr double skin_step = 0.5;       // mm
constexpr int skin_bisections = 10;
constexpr double same_hole = 1.0;  // mm
constexpr double late = 1.0;       // mm past a point's place, at which it comes late
constexpr std::uint32_t ticks_from_look_to_look = 10;
constexpr std::uint64_t steps_at_rest = 12;  // of the body, after which a probe that holds the same nodes rests

double distance(const Vec3& point, const Vec3& entry, const Vec3& direction) noexcept {
  const Vec3 from = point - entry;
  return (from - from.dot(direction) * direction).norm();
}

// BodyField::held_since of the nodes that are held; 0: none are.
std::uint64_t held_by(const fem::BodyField* motion) noexcept {
  return motion == nullptr || motion->held_count == 0 ? 0 : motion->held_since;
}

bool runs_along(const anatomy::NeedlePath& path, const Vec3& entry, const Vec3& direction, double within) noexcept {
  return distance(path.entry, entry, direction) <= within && distance(path.target, entry, direction) <= within;
}

void tell_late(double past, const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept {
  events.push({forces::EventKind::points_late, needle.tissue, needle.motion.depth, past});
}

}  // namespace

NeedleInBody::NeedleInBody(const anatomy::Case& patient, const Settings& settings, double dt)
    : patient_(&patient),
      settings_(settings),
      dt_(dt),
      path_(patient.corridor.path),
      planned_(patient, settings, dt) {}

std::shared_ptr<fem::ContactLine> NeedleInBody::stream_points(bool as_recorded) {
  const fem::BodyField* const motion = newest_motion();
  line_ = std::make_shared<fem::ContactLine>(planned_.spring(), motion == nullptr ? 0 : motion->held.size());
  own_ = std::make_unique<DeformableShaft>(planned_, *patient_, *line_, settings_, dt_);
  as_recorded_ = as_recorded;
  return line_;
}

bool NeedleInBody::move_with(const std::shared_ptr<fem::BodyMotion>& motion) {
  motion_ = motion;
  return true;
}

void NeedleInBody::approach(const Vec3& tip, const Vec3& axis) noexcept {
  if (line_ == nullptr || ticks_outside_++ % ticks_from_look_to_look != 0) return;
  const std::optional<Vec3> entry = skin_ahead(tip, axis);
  if (!entry) return;
  const fem::BodyField* const motion = newest_motion();
  if (held_by(motion) == 0 && runs_along(path_, *entry, axis, same_line)) return;
  if (!is_asked(*entry, axis, same_aim, motion)) ask(*entry, axis, motion);
}

// While a probe moves, it takes and releases nodes in every step: the line asked for stays.
bool NeedleInBody::is_asked(const Vec3& entry, const Vec3& direction, double within,
                            const fem::BodyField* motion) const noexcept {
  if (!asked_ || !runs_along(*asked_, entry, direction, within)) return false;
  const bool rests = motion == nullptr || motion->step >= motion->held_since + steps_at_rest;
  return held_by(motion) == asked_held_ || !rests;
}

const fem::BodyField* NeedleInBody::newest_motion() noexcept {
  if (motion_ == nullptr) return nullptr;
  const fem::BodyField& newest = motion_->read();
  motion_taken_ = newest.step;
  return &newest;
}

void NeedleInBody::change_numbers(const fem::ContactNumbers& numbers) noexcept {
  if (!touches_) return set_numbers(numbers);
  change_.begin(planned_.numbers(), numbers, static_cast<int>(std::lround(contact_change_time / dt_)));
}

void NeedleInBody::set_numbers(const fem::ContactNumbers& numbers) noexcept {
  planned_.set_numbers(numbers);
  if (own_ != nullptr) own_->set_numbers(numbers);
}

fem::NodeForces NeedleInBody::node_forces() const noexcept {
  return touches_ ? model().node_forces() : fem::NodeForces{};
}

Vec3 NeedleInBody::needle_ahead() const noexcept {
  return touches_ ? model().ahead() : Vec3(Vec3::Zero());
}

Vec3 NeedleInBody::tissue_motion() const noexcept {
  return touches_ ? model().tissue_motion() : Vec3(Vec3::Zero());
}

void NeedleInBody::begin(const Vec3& entry, const Vec3& direction) noexcept {
  told_motion_ = false;
  if (change_.goes_on()) set_numbers(change_.last());
  const bool own =
      line_ != nullptr && (held_by(newest_motion()) != 0 || !runs_along(path_, entry, direction, same_line));
  if (own != on_own_line_) announced_ = false;
  on_own_line_ = own;
  if (own) {
    begin_own_line(entry, direction);
  } else {
    planned_.begin(entry, direction);
    open_holes();
  }
}

void NeedleInBody::begin_own_line(const Vec3& entry, const Vec3& direction) noexcept {
  points_ = 0;
  complete_ = false;
  begins_ = true;
  if (!asked_ || !runs_along(*asked_, entry, direction, same_line)) ask(entry, direction, newest_motion());
  own_->begin_growing(entry, direction, is_hole(entry));
}

forces::ResistanceForce NeedleInBody::step(const forces::NeedleInTissue& needle,
                                           forces::TickEvents& events) noexcept {
  if (change_.goes_on()) set_numbers(change_.next());
  if (!std::exchange(announced_, true)) {
    events.push(
        {forces::EventKind::corridor_taken, needle.tissue, needle.motion.depth, on_own_line_ ? own_line : -1.0});
  }
  if (on_own_line_) take_known_points(needle, events);
  if (motion_ != nullptr || breath_.field != nullptr) take_motion(needle, events);
  forces::ResistanceForce force = model().step(needle, events);
  touches_ = force.in_contact;
  remember_hole();
  return force;
}

void NeedleInBody::reset() noexcept {
  planned_.reset();
  if (own_ != nullptr) own_->reset();
  breath_ = {};
  on_own_line_ = touches_ = false;
  announced_ = told_motion_ = true;
  hole_count_ = 0;
  asked_.reset();
  asked_held_ = 0;
  ticks_outside_ = 0;
}

// Those that are there, or that were in the recording.
void NeedleInBody::take_known_points(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept {
  fem::ContactLine::Progress now{points_, complete_};
  if (!as_recorded_) {
    now = line_->progress();
  } else if (recorded_) {
    now.complete = *recorded_ < 0.0;
    const double count = now.complete ? -1.0 - *recorded_ : *recorded_;
    now.points = count > 0.0 && count <= fem::ContactLine::most_points ? static_cast<std::size_t>(count) : 0;
    line_->wait_for(now.points);
  }
  recorded_.reset();
  if (now.points != points_ || now.complete != complete_) {
    const std::size_t before = points_;
    points_ = now.points;
    complete_ = now.complete;
    own_->extend(points_, complete_);
    open_holes();
    const double past = needle.motion.depth - own_->point_depth(before);
    if (before > 0 && points_ > before && past > late) tell_late(past, needle, events);
    const auto count = static_cast<double>(points_);
    events.push(
        {forces::EventKind::points_taken, needle.tissue, needle.motion.depth, complete_ ? -1.0 - count : count});
  }
  // The needle touches a surface that is not there yet.
  if (std::exchange(begins_, false) && points_ == 0 && !complete_) tell_late(needle.motion.depth, needle, events);
}

void NeedleInBody::take_motion(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept {
  const fem::BodyField* const newest = newest_motion();
  const std::span<const float> of_mesh = newest == nullptr ? std::span<const float>() : newest->moved;
  const bool moves = model().move_with(of_mesh, breath_);
  if (!moves || motion_ == nullptr || std::exchange(told_motion_, true)) return;
  events.push({forces::EventKind::corridor_refreshed, needle.tissue, needle.motion.depth, 1.0});
}

void NeedleInBody::ask(const Vec3& entry, const Vec3& direction, const fem::BodyField* motion) noexcept {
  asked_ = anatomy::NeedlePath{entry, entry + path_.length() * direction};
  asked_held_ = held_by(motion);
  line_->ask(entry, direction, motion == nullptr ? std::span<const std::uint32_t>() : motion->held_nodes());
}

// Where a needle outside the body would meet the skin.
std::optional<Vec3> NeedleInBody::skin_ahead(const Vec3& tip, const Vec3& axis) const noexcept {
  const auto is_air = [this](const Vec3& place) {
    return anatomy::nearest<anatomy::TissueId>(patient_->tissues, place, anatomy::tissue::air) ==
           anatomy::tissue::air;
  };
  if (!is_air(tip)) return {};
  double inside = skin_step;
  while (inside <= farthest_skin && is_air(tip + inside * axis)) inside += skin_step;
  if (inside > farthest_skin) return {};
  double outside = inside - skin_step;
  for (int step = 0; step < skin_bisections; ++step) {
    const double middle = 0.5 * (outside + inside);
    (is_air(tip + middle * axis) ? outside : inside) = middle;
  }
  return tip + inside * axis;
}

bool NeedleInBody::is_hole(const Vec3& place) const noexcept {
  for (std::size_t i = 0; i < hole_count_; ++i)
    if ((holes_[i].place - place).squaredNorm() < same_hole * same_hole) return true;
  return false;
}

void NeedleInBody::remember_hole() noexcept {
  const auto& found = model().puncture();
  if (found && hole_count_ < most_holes) holes_[hole_count_++] = {found->place, found->tissue};
}

void NeedleInBody::open_holes() noexcept {
  for (std::size_t i = 0; i < hole_count_; ++i) model().open(holes_[i].place, holes_[i].tissue);
}

}  // namespace bodkin::simulation
