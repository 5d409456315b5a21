#include "simulation/needle_in_body.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace bodkin::simulation {

namespace {

constexpr double same_line = 1.5;       // mm, between the planned line and the needle's
constexpr double same_aim = 1.0;        // mm, between the requested line and that of a needle outside
constexpr double farthest_skin = 50.0;  // mm before the tip
constexpr double skin_step = 0.5;       // mm
constexpr int skin_bisections = 10;
constexpr double same_hole = 1.0;      // mm
constexpr double late = 1.0;           // mm past a point's place, beyond which it is late
constexpr double required_lead = 3.0;  // mm
constexpr std::size_t points_in_time = 8;
constexpr double look_ahead = 10.0;  // mm before the tip, within which the needle may leave its line
constexpr std::uint32_t ticks_between_checks = 10, least_ticks_per_line = 50;
constexpr std::uint64_t steps_at_rest = 12;  // of the body, after which a probe that holds the same nodes is at rest

double distance(const Vec3& point, const Vec3& entry, const Vec3& direction) noexcept {
  const Vec3 from = point - entry;
  return (from - from.dot(direction) * direction).norm();
}

// BodyField::held_since of the nodes that are held; 0: none are.
std::uint64_t held_by(const fem::BodyField* motion) noexcept {
  return motion == nullptr || motion->held_count == 0 ? 0 : motion->held_since;
}

bool rests(const fem::BodyField* motion) noexcept {
  return motion == nullptr || motion->step >= motion->held_since + steps_at_rest;
}

bool runs_along(const anatomy::NeedlePath& path, const Vec3& entry, const Vec3& direction, double within) noexcept {
  return distance(path.entry, entry, direction) <= within && distance(path.target, entry, direction) <= within;
}

void report_late_points(double past, const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept {
  events.push({forces::EventKind::points_late, needle.tissue, needle.motion.depth, past});
}

}  // namespace

NeedleInBody::NeedleInBody(const anatomy::Case& patient, const Settings& settings, double dt)
    : patient_(&patient),
      settings_(settings),
      dt_(dt),
      path_(patient.prepared.path),
      planned_(patient, settings, dt) {}

std::shared_ptr<fem::ContactLine> NeedleInBody::stream_points(PointTiming timing) {
  const fem::BodyField* const motion = newest_motion();
  line_ = std::make_shared<fem::ContactLine>(planned_.spring(), motion == nullptr ? 0 : motion->held.size());
  own_ = std::make_unique<DeformableShaft>(planned_, *patient_, *line_, settings_, dt_);
  timing_ = timing;
  request_planned_line();
  return line_;
}

bool NeedleInBody::move_with(const std::shared_ptr<fem::BodyMotion>& motion) {
  motion_ = motion;
  return true;
}

void NeedleInBody::approach(const Vec3& tip, const Vec3& axis) noexcept {
  if (line_ == nullptr || ticks_outside_++ % ticks_between_checks != 0) return;
  const std::optional<Vec3> entry = skin_ahead(tip, axis);
  if (!entry) return;
  const fem::BodyField* const motion = newest_motion();
  if (held_by(motion) == 0 && runs_along(path_, *entry, axis, same_line)) {
    if (!requested_ || !requested_->is_planned || requested_->is_continuation) request_planned_line();
    return;
  }
  if (!is_requested(*entry, axis, same_aim, motion)) request_line(*entry, axis, motion);
}

// While a probe moves, it takes and releases nodes in every step: the requested line stays.
bool NeedleInBody::is_requested(const Vec3& entry, const Vec3& direction, double within,
                                const fem::BodyField* motion) const noexcept {
  if (!requested_ || requested_->is_planned || requested_->is_continuation ||
      !runs_along(requested_->path, entry, direction, within))
    return false;
  return held_by(motion) == requested_->held || !rests(motion);
}

const fem::BodyField* NeedleInBody::newest_motion() noexcept {
  if (motion_ == nullptr) return nullptr;
  const fem::BodyField& newest = motion_->read();
  applied_step_ = newest.step;
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

Wrench NeedleInBody::on_held() const noexcept {
  return touches_ && own_ != nullptr ? line_->on_held(own_->point_forces()) : Wrench{};
}

Vec3 NeedleInBody::coupling_offset() const noexcept {
  return touches_ ? model().coupling_offset() : Vec3(Vec3::Zero());
}

Pose NeedleInBody::tissue_motion() const noexcept {
  return touches_ ? model().tissue_motion() : Pose::Identity();
}

void NeedleInBody::begin(const Vec3& entry, const Vec3& direction) noexcept {
  reported_motion_ = false;
  if (change_.is_active()) set_numbers(change_.last());
  const bool beside =
      line_ != nullptr && (held_by(newest_motion()) != 0 || !runs_along(path_, entry, direction, same_line));
  if (beside != beside_plan_) announced_ = false;
  beside_plan_ = beside;
  if (line_ != nullptr) {
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
  ticks_on_line_ = 0;
  const bool inside = requested_ && requested_->is_continuation, pending = coupling_ != Coupling::none;
  if (!beside_plan_) {
    if (!requested_ || !requested_->is_planned || inside || pending) request_planned_line();
  } else if (!requested_ || requested_->is_planned || inside || pending ||
             !runs_along(requested_->path, entry, direction, same_line)) {
    request_line(entry, direction, newest_motion());
  }
  own_->begin_growing(entry, direction, is_hole(entry));
}

forces::ResistanceForce NeedleInBody::step(const forces::NeedleInTissue& needle,
                                           forces::TickEvents& events) noexcept {
  if (change_.is_active()) set_numbers(change_.next());
  if (!std::exchange(announced_, true)) {
    events.push({forces::EventKind::line_taken, needle.tissue, needle.motion.depth, beside_plan_ ? own_line : -1.0});
  }
  if (line_ != nullptr) accept_known_points(needle, events);
  if (motion_ != nullptr || breath_.field != nullptr) apply_motion(needle, events);
  forces::ResistanceForce force = model().step(needle, events);
  touches_ = force.in_contact;
  remember_hole();
  if (line_ != nullptr) extend_line_after_turn(needle);
  return force;
}

void NeedleInBody::reset() noexcept {
  planned_.reset();
  if (own_ != nullptr) own_->reset();
  breath_ = {};
  beside_plan_ = touches_ = false;
  announced_ = reported_motion_ = true;
  hole_count_ = 0;
  ticks_outside_ = ticks_on_line_ = 0;
  if (line_ != nullptr) request_planned_line();
}

// The existing points, or those of the recording.
fem::ContactLine::Progress NeedleInBody::known_points(const forces::NeedleInTissue& needle) noexcept {
  if (coupling_ != Coupling::none) return {points_, complete_};
  if (timing_ == PointTiming::in_time) return points_ahead_of(needle);
  if (timing_ == PointTiming::as_known) {
    fem::ContactLine::Progress now = line_->progress();
    now.points = std::max(now.points, points_);  // kept where the line is extended
    return now;
  }
  fem::ContactLine::Progress now{points_, complete_};
  if (!recorded_) return now;
  now.complete = *recorded_ < 0.0;
  const double count = now.complete ? -1.0 - *recorded_ : *recorded_;
  now.points = count > 0.0 && count <= fem::ContactLine::most_points ? static_cast<std::size_t>(count) : 0;
  line_->wait_for(now.points);
  return now;
}

// As many as lie less than `required_lead` before the tip, and a few more; the same number whenever they arrive.
fem::ContactLine::Progress NeedleInBody::points_ahead_of(const forces::NeedleInTissue& needle) noexcept {
  fem::ContactLine::Progress now{points_, complete_};
  while (!now.complete) {
    if (now.points > 0) {
      const Vec3 from_tip = line_->body().nodes[now.points - 1] - needle.tip;
      if (from_tip.dot(needle.axis) > required_lead) break;
    }
    const std::size_t wanted = now.points + points_in_time;
    const fem::ContactLine::Progress there = line_->wait_for(wanted);
    now.complete = there.points < wanted;
    now.points = std::min(there.points, wanted);
  }
  return now;
}

void NeedleInBody::accept_known_points(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept {
  const fem::ContactLine::Progress now = known_points(needle);
  recorded_.reset();
  if (now.points != points_ || now.complete != complete_) {
    const std::size_t before = points_;
    points_ = now.points;
    complete_ = now.complete;
    own_->extend(points_, complete_);
    open_holes();
    const double past = needle.motion.depth - own_->point_depth(before);
    if (before > 0 && points_ > before && past > late) report_late_points(past, needle, events);
    const auto count = static_cast<double>(points_);
    events.push(
        {forces::EventKind::points_taken, needle.tissue, needle.motion.depth, complete_ ? -1.0 - count : count});
  }
  // The needle touches a surface that is not available yet.
  if (std::exchange(begins_, false) && points_ == 0 && !complete_)
    report_late_points(needle.motion.depth, needle, events);
}

// Tissue moves sideways with the shaft, so the tip's place in the tissue at rest counts.
void NeedleInBody::extend_line_after_turn(const forces::NeedleInTissue& needle) noexcept {
  if (++ticks_on_line_ < least_ticks_per_line || ticks_on_line_ % ticks_between_checks != 0) return;
  if (!touches_ || points_ == 0 || !(needle.motion.velocity > 0.0) || coupling_ != Coupling::none) return;
  const fem::EmbeddedNeedle::Continuation next = own_->continuation();
  const Vec3 along = requested_->path.direction();
  const bool turned = distance(next.place, requested_->path.entry, along) > same_aim ||
                      distance(next.place + look_ahead * next.direction, requested_->path.entry, along) > same_aim;
  if (!turned && !(complete_ && own_->past_line())) return;
  points_ = own_->reached();
  complete_ = false;
  ticks_on_line_ = 0;
  own_->extend_from(points_);
  requested_->path = {next.place, next.place + path_.length() * next.direction};
  requested_->is_continuation = true;
  line_->continue_from(next.place, next.direction, points_);
}

void NeedleInBody::apply_motion(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept {
  const fem::BodyField* const newest = newest_motion();
  if (line_ != nullptr && newest != nullptr) couple(*newest, needle, events);
  const std::span<const float> of_mesh = newest == nullptr ? std::span<const float>() : newest->moved;
  const bool moves = model().move_with(of_mesh, breath_);
  if (!moves || motion_ == nullptr || std::exchange(reported_motion_, true)) return;
  events.push({forces::EventKind::moving_body_met, needle.tissue, needle.motion.depth, 1.0});
}

// A resting probe holds nodes other than those coupled with the needle's points.
void NeedleInBody::couple(const fem::BodyField& motion, const forces::NeedleInTissue& needle,
                          forces::TickEvents& events) noexcept {
  switch (coupling_) {
    case Coupling::none:
      if (!touches_ || !complete_ || points_ == 0 || held_by(&motion) == requested_->held || !rests(&motion)) return;
      coupling_ = Coupling::requested;
      coupled_held_ = held_by(&motion);
      coupled_count_ = motion.held_count;
      line_->couple(motion.held_nodes(), points_);
      return;
    case Coupling::requested: {
      const bool recorded = std::exchange(recorded_coupling_, false);
      const bool there =
          timing_ == PointTiming::as_recorded ? recorded && line_->wait_until_coupled() : line_->is_coupled();
      if (!there) return;
      coupling_ = Coupling::applied;
      own_->exchange();
      events.push({forces::EventKind::points_coupled, needle.tissue, needle.motion.depth,
                   static_cast<double>(coupled_count_)});
      return;
    }
    case Coupling::applied:
      if (own_->exchanges()) return;
      coupling_ = Coupling::none;
      requested_->held = coupled_held_;
      requested_->is_planned = false;
      if (own_->exchanged()) line_->apply_coupling();
      return;
  }
}

void NeedleInBody::request_line(const Vec3& entry, const Vec3& direction, const fem::BodyField* motion) noexcept {
  coupling_ = Coupling::none;
  requested_ = RequestedLine{.path = {entry, entry + path_.length() * direction}, .held = held_by(motion)};
  line_->request(entry, direction, motion == nullptr ? std::span<const std::uint32_t>() : motion->held_nodes());
}

void NeedleInBody::request_planned_line() noexcept {
  coupling_ = Coupling::none;
  requested_ = RequestedLine{.path = path_, .is_planned = true};
  line_->request_planned(path_.entry, path_.direction());
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
