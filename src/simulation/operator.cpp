#include "simulation/operator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/repeatable.h"
#include "core/rotation.h"

namespace bodkin::simulation {

namespace {

constexpr double sample_interval = 0.005;  // s between remembered sensations
constexpr double drop_memory = 0.3;        // s over which a drop of force is noticed
constexpr double hardness_memory = 0.15;   // s over which hardness is judged
constexpr double feeling_cutoff = 15.0;    // Hz of the sensing of a slowly varying force
constexpr double least_yield = 0.05;       // mm; hardness is never divided by less
constexpr double aiming_pace = 40.0;       // mm/s at which the hand moves over to a new line of aim
constexpr double turning_pace = 0.5;       // rad/s at which the needle is turned
constexpr double twirling_pace = 40.0;     // rad/s, the limit of fingers turning a needle
constexpr double speed_interval = 0.35;    // s between independent values of the speed's noise
constexpr double wander_interval = 0.9;    // s, the same of the wander

Vec3 nearer(const Vec3& from, const Vec3& to, double reach) noexcept {
  const Vec3 offset = to - from;
  const double distance = offset.norm();
  return distance <= reach ? to : Vec3(from + offset * (reach / distance));
}

}  // namespace

Operator::SlowNoise::SlowNoise(double interval, double dt, std::uint64_t seed)
    : random_(seed), rate_(dt / interval), from_(random_.normal()), to_(random_.normal()) {}

double Operator::SlowNoise::next() noexcept {
  position_ += rate_;
  if (position_ >= 1.0) {
    position_ -= 1.0;
    from_ = to_;
    to_ = random_.normal();
  }
  const double share = position_ * position_ * (3.0 - 2.0 * position_);
  return from_ + share * (to_ - from_);
}

Operator::Operator(const OperatorScript& script, const anatomy::NeedlePath& path, std::uint64_t seed, double dt)
    : script_((check(script, "operator '" + script.name + "'"), script)),
      path_(path),
      dt_(dt),
      random_(mix64(seed ^ 0xA1)),
      speed_noise_(speed_interval, dt, mix64(seed ^ 0xB2)),
      wander_{SlowNoise(wander_interval, dt, mix64(seed ^ 0xC3)), SlowNoise(wander_interval, dt, mix64(seed ^ 0xC4)),
              SlowNoise(wander_interval, dt, mix64(seed ^ 0xC5)), SlowNoise(wander_interval, dt, mix64(seed ^ 0xC6))},
      visits_(script.phases.size(), 0),
      samples_(static_cast<std::size_t>(std::ceil(drop_memory / std::max(sample_interval, dt))) + 1),
      sample_ticks_(std::max(1, static_cast<int>(std::lround(sample_interval / dt)))) {
  if (!(path.length() > 1e-3))
    throw InputError("the needle's entry and target are the same point, expected a path of some length");
  for (const OperatorPhase& phase : script.phases) {
    if (std::any_of(phase.until.begin(), phase.until.end(), [](const auto& until) { return until.has_share(); }))
      throw InputError("phase '" + phase.name + "' of operator '" + script.name +
                       "' waits for a share of a force, expected one in N for the patient");
  }
  across_ = needle_pose(path.entry, path.direction()).linear().col(0);
  along_ = needle_pose(path.entry, path.direction()).linear().col(1);
  const Vec3 up = Vec3::UnitZ() - Vec3::UnitZ().dot(path.direction()) * path.direction();
  cephalad_ = up.norm() > 1e-6 ? Vec3(up.normalized()) : along_;
  draw_aim();
  entry_ = aim_entry_;
  direction_ = aim_direction_;
  intended_ = -script_.start_distance;
  advance_ = intended_;
  enter(0);
}

Pose Operator::start() const noexcept {
  return needle_pose(entry_ + intended_ * direction_, direction_);
}

void Operator::draw_aim() noexcept {
  const double x = script_.aim_position * random_.normal();
  const double y = script_.aim_position * random_.normal();
  const double a = script_.aim_angle * random_.normal();
  const double b = script_.aim_angle * random_.normal();
  aim_entry_ = path_.entry + x * across_ + y * along_;
  aim_direction_ = (path_.direction() + a * across_ + b * along_).normalized();
}

void Operator::add_sample(const OperatorSense& sense) noexcept {
  const double pushing_out = -sense.force.dot(needle_axis(sense.needle));
  const double share = 1.0 - repeatable::exp(-2.0 * std::numbers::pi * feeling_cutoff * dt_);
  force_ += share * (pushing_out - force_);
  advance_ = (sense.needle.translation() - path_.entry).dot(path_.direction());
  if (first_) phase_advance_ = advance_;
  first_ = false;
  if (--until_sample_ > 0) return;
  until_sample_ = sample_ticks_;
  newest_ = (newest_ + 1) % samples_.size();
  samples_[newest_] = {force_, advance_};
  sample_count_ = std::min(sample_count_ + 1, samples_.size());
}

double Operator::recent_drop() const noexcept {
  double peak = force_;
  for (std::size_t age = 0; age < sample_count_; ++age) {
    peak = std::max(peak, samples_[(newest_ + samples_.size() - age) % samples_.size()].force);
  }
  return peak - force_;
}

double Operator::recent_hardness() const noexcept {
  const auto memory = static_cast<std::size_t>(std::lround(hardness_memory / (sample_ticks_ * dt_)));
  if (sample_count_ <= memory) return 0.0;
  const ForceSample& then = samples_[(newest_ + samples_.size() - memory) % samples_.size()];
  return (force_ - then.force) / std::max(advance_ - then.advance, least_yield);
}

bool Operator::holds(const OperatorCondition& condition) const noexcept {
  const double travel = std::abs(advance_ - phase_advance_);
  if (condition.time && phase_time_ < *condition.time) return false;
  if (condition.travel && travel < *condition.travel) return false;
  if (condition.depth_above && advance_ < *condition.depth_above) return false;
  if (condition.depth_below && advance_ > *condition.depth_below) return false;
  if (condition.remaining_below && path_.length() - advance_ > *condition.remaining_below) return false;
  if (condition.force_above && force_ < *condition.force_above) return false;
  if (condition.force_below && force_ > *condition.force_below) return false;
  if (condition.force_drop && recent_drop() < *condition.force_drop) return false;
  if (condition.hardness_above && recent_hardness() < *condition.hardness_above) return false;
  return true;
}

void Operator::decide() noexcept {
  if (pending_) {
    pending_time_ -= dt_;
    if (pending_time_ <= 0.0) enter(pending_next_);
    return;
  }
  for (const OperatorCondition& condition : script_.phases[static_cast<std::size_t>(phase_)].until) {
    if (!holds(condition)) continue;
    if (!condition.has_force_condition()) {
      enter(condition.next);
    } else {
      pending_ = true;
      pending_next_ = condition.next;
      pending_time_ = std::max(0.0, script_.reaction + script_.reaction_spread * random_.normal());
    }
    return;
  }
}

void Operator::enter(int phase) noexcept {
  // A phase that has had its turns passes the offset to another; a cycle of such phases ends the script.
  for (std::size_t hop = 0; phase != OperatorCondition::end && hop <= script_.phases.size(); ++hop) {
    const OperatorPhase& wanted = script_.phases[static_cast<std::size_t>(phase)];
    if (wanted.at_most == 0 || visits_[static_cast<std::size_t>(phase)] < wanted.at_most) break;
    phase = hop == script_.phases.size() ? OperatorCondition::end : wanted.otherwise;
  }
  phase_ = phase;
  phase_time_ = 0.0;
  phase_advance_ = advance_;
  stepped_ = 0.0;
  pausing_ = 0.0;
  pending_ = false;
  sample_count_ = 0;
  if (phase == OperatorCondition::end) return;
  ++visits_[static_cast<std::size_t>(phase)];
  const OperatorPhase& now = script_.phases[static_cast<std::size_t>(phase)];
  other_.finger = now.finger;
  if (now.move_stylet) other_.stylet_moved = !other_.stylet_moved;
  if (now.move_manometer) other_.manometer_moved = !other_.manometer_moved;
  if (now.aim_again) draw_aim();
  if (now.tilt != 0.0) {
    // Towards the head: superior is +z in LPS.
    const Vec3 axis = aim_direction_.cross(Vec3::UnitZ());
    if (axis.norm() > 1e-6) aim_direction_ = rotation_about(axis.normalized(), now.tilt) * aim_direction_;
  }
  // Holding still or pulling back releases the push: from the hand's position, not from its goal.
  if (now.speed <= 0.0 && !first_) {
    intended_ = std::min(intended_, advance_);
    speed_ = 0.0;
  }
}

void Operator::move() noexcept {
  const OperatorPhase& now = script_.phases[static_cast<std::size_t>(phase_)];
  const double noise = 1.0 + script_.unsteadiness * speed_noise_.next();
  double wanted = now.speed * std::max(0.0, noise);
  if (pausing_ > 0.0) {
    pausing_ -= dt_;
    wanted = 0.0;
  }
  const double change = now.acceleration * dt_;
  speed_ += std::clamp(wanted - speed_, -change, change);
  intended_ += speed_ * dt_;
  stepped_ += std::abs(speed_) * dt_;
  if (now.step > 0.0 && stepped_ >= now.step) {
    stepped_ = 0.0;
    pausing_ = now.pause;
  }
  entry_ =
      nearer(entry_, now.shift == 0.0 ? aim_entry_ : Vec3(aim_entry_ + now.shift * cephalad_), aiming_pace * dt_);
  direction_ = nearer(direction_, aim_direction_, turning_pace * dt_).normalized();
  const double turn = 0.5 * now.twirl * repeatable::sin(2.0 * std::numbers::pi * now.twirl_rate * phase_time_);
  twirled_ += std::clamp(turn - twirled_, -twirling_pace * dt_, twirling_pace * dt_);
}

Pose Operator::step(const OperatorSense& sense) noexcept {
  add_sample(sense);
  phase_time_ += dt_;
  if (!finished()) decide();
  if (!finished()) move();
  const Vec3 drift = script_.wander * (wander_[0].next() * across_ + wander_[1].next() * along_);
  const Vec3 lean = script_.wander_angle * (wander_[2].next() * across_ + wander_[3].next() * along_);
  const Vec3 direction = (direction_ + lean).normalized();
  Pose wanted = needle_pose(entry_ + drift + intended_ * direction, direction);
  if (twirled_ != 0.0) wanted.rotate(rotation_about(Vec3::UnitZ(), twirled_));
  return wanted;
}

}  // namespace bodkin::simulation
