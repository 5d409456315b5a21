#include "simulation/haptic_tick.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

#include "core/error.h"
#include "core/motion_estimator.h"
#include "forces/fingertip.h"
#include "forces/gravity_compensation.h"
#include "haptics/force_governor.h"
#include "simulation/constraint.h"
#include "simulation/hub_stop.h"
#include "simulation/loss_of_resistance.h"
#include "simulation/needle_bow.h"
#include "simulation/needle_contact.h"
#include "simulation/organ_release.h"
#include "simulation/resistance.h"
#include "simulation/tip_in_layers.h"
#include "simulation/touching_tissue.h"

namespace bodkin::simulation {

namespace {

constexpr double farthest_tip = 1e5;   // mm from the origin; farther, the pose is an error of the device
constexpr double tissue_slack = 0.2;   // mm that the tip must move before another change of tissue is an event
constexpr int limit_event_rest = 100;  // ticks without intervention before the next one is a new event
constexpr std::uint8_t interventions =
    haptics::force_limit::passivity | haptics::force_limit::peak | haptics::force_limit::thermal;

// As declared, except that a program may simulate a stronger device than a case file can state.
void check_device(const anatomy::DeviceLimits& device) {
  for_each_parameter(
      [](const auto& parameter, const auto& value) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>) {
          const Range from = {parameter.range.low, unbounded, parameter.range.includes_low, false};
          check_range("device", parameter.name, value, from, parameter.unit);
        }
      },
      device);
  check_relations(device, "device");
}

// The case, if its numbers can be simulated.
const anatomy::Case& checked(const anatomy::Case& patient) {
  if (patient.tissues.empty()) throw InputError("the case has no tissues, so there is nothing to feel");
  const anatomy::HapticSettings& haptics = patient.description.haptics;
  bodkin::check(haptics, "haptics");
  check_device(patient.description.device);
  return patient;
}

haptics::GovernorSettings governor_settings(const anatomy::Case& patient, double dt, double velocity_threshold) {
  haptics::GovernorSettings settings;
  settings.dt = dt;
  settings.peak_force = patient.description.device.peak_force;
  settings.continuous_force = patient.description.device.continuous_force;
  settings.peak_torque = patient.description.device.peak_torque;
  settings.velocity_threshold = velocity_threshold;
  return settings;
}

// A patient who breathes, and the needle in the material.
struct Breath {
  Breath(const anatomy::Breathing& breathing, double dt) noexcept : clock(breathing, dt), field(breathing) {}

  // One tick.
  TickInput in_material(const TickInput& input, BodyPort* body) noexcept {
    const double drawn_in = clock.step(input.other.breath_held);
    const Vec3 tip = input.needle.translation();
    TickInput moved = input;
    moved.needle.translation() = field.material(tip, drawn_in);
    of_tip = tip - moved.needle.translation();
    if (body != nullptr) body->breathe(field, drawn_in, of_tip);
    return moved;
  }

  anatomy::BreathClock clock;
  anatomy::BreathField field;
  Vec3 of_tip = Vec3::Zero();  // mm, motion of the tissue at the tip
};

}  // namespace

struct HapticTick::State {
  explicit State(const anatomy::Case& from)
      : patient(checked(from)),
        dt(1.0 / from.description.haptics.rate),
        motion(dt, from.description.device.position_resolution),
        resistance(from, dt),
        constraint(from, dt),
        compensation(from.description.haptics.compensation),
        governor(governor_settings(from, dt, motion.threshold())),
        hub(from.description.needle.length, from.description.device.stiffness),
        buckles(from.description.haptics.mechanics == anatomy::Mechanics::physical),
        deforms(goes_by_material(from.description.haptics)),
        layers(from, resistance.passes_layers()),
        bow(from, dt),
        organs(from, dt) {
    if (from.description.breathing) {
      bodkin::check(*from.description.breathing, "breathing");
      breath.emplace(*from.description.breathing, dt);
    }
    if (from.description.haptics.parts.fingertip) {
      finger.emplace(from.tissues, *from.description.haptics.parts.fingertip, from.description.device.stiffness, dt);
    }
  }

  const anatomy::Case& patient;
  double dt;
  MotionEstimator motion;
  Resistance resistance;
  Constraint constraint;
  forces::GravityCompensation compensation;
  haptics::ForceGovernor governor;
  HubStop hub;
  bool buckles;  // mechanics="physical"
  bool deforms;  // the tip's tissue is that of the deformed material
  TipInLayers layers;
  NeedleBow bow;
  OrganRelease organs;
  NeedleContact contact;
  std::optional<Breath> breath;  // empty: nobody breathes
  std::optional<forces::Fingertip> finger;
  bool finger_is_down = false;  // in place of the needle
  LossOfResistance loss;
  Vec3 last_tip = Vec3::Zero();
  bool seen = false;                                   // there was a tick before
  anatomy::TissueId announced = anatomy::tissue::air;  // tissue of the last tissue_entered
  Vec3 announced_at = Vec3::Zero();                    // LPS mm
  bool anything_announced = false;
  int quiet_ticks = limit_event_rest;  // since the governor's last intervention
  TickOutput last;                     // repeated while a fault lasts

  // `axis`: the needle's, unit.
  TickOutput step(const TickInput& input, const Vec3& axis) noexcept;
  TickOutput feel(const Vec3& tip, const Vec3& axis, double advance) noexcept;
  void announce_tissue(const Vec3& tip, TickOutput& output) noexcept;
  void announce_limits(const Vec3& wanted, TickOutput& output) noexcept;
  TickOutput fault() noexcept;
  // The device's position for a tip in the material.
  Vec3 hand(const Vec3& tip) const noexcept { return breath ? Vec3(tip + breath->of_tip) : tip; }
  void place_tip(forces::NeedleInTissue& needle) noexcept;
  double follow_layers(const forces::NeedleInTissue& needle, const forces::ResistanceForce& found,
                       TickOutput& output) noexcept;
};

// The tip of a needle that may bow.
void HapticTick::State::place_tip(forces::NeedleInTissue& needle) noexcept {
  needle.motion = bow.tip_motion(needle.motion);
  if (bow.bow() == 0.0) return;
  needle.tip -= bow.bow() * contact.direction();
  needle.tissue = anatomy::nearest<anatomy::TissueId>(patient.tissues, needle.tip, anatomy::tissue::air);
}

// Tissue and events of the deformed material; N of the resistance at the hand.
double HapticTick::State::follow_layers(const forces::NeedleInTissue& needle, const forces::ResistanceForce& found,
                                        TickOutput& output) noexcept {
  output.tissue = layers.step(output.depth, needle.tissue, found, output.events);
  announced = output.tissue;
  announced_at = last_tip;
  anything_announced = true;
  return buckles ? bow.limited(found.along, output.tissue, output.events) : found.along;
}

void HapticTick::State::announce_tissue(const Vec3& tip, TickOutput& output) noexcept {
  if (output.tissue == announced) return;
  if (anything_announced && (tip - announced_at).squaredNorm() < tissue_slack * tissue_slack) return;
  announced = output.tissue;
  announced_at = tip;
  anything_announced = true;
  output.events.push({forces::EventKind::tissue_entered, announced, output.depth, 0.0});
}

void HapticTick::State::announce_limits(const Vec3& wanted, TickOutput& output) noexcept {
  if ((output.limits & interventions) == 0) {
    quiet_ticks = std::min(quiet_ticks + 1, limit_event_rest);
    return;
  }
  if (quiet_ticks == limit_event_rest) {
    output.events.push({forces::EventKind::force_limited, output.tissue, output.depth, wanted.norm()});
  }
  quiet_ticks = 0;
}

// The models rest, the force fades. Only reset() ends this state.
TickOutput HapticTick::State::fault() noexcept {
  TickOutput output = last;
  output.events.clear();
  if (!governor.failed()) {
    governor.fail();
    output.events.push({forces::EventKind::fault, output.tissue, output.depth, 0.0});
  }
  output.requested = Wrench{};
  output.resistance = output.constraint = output.velocity = 0.0;
  output.applied.force = governor.step({});
  output.applied.torque = governor.torque();
  output.limits = governor.flags();
  last = output;
  return output;
}

// The finger instead of the needle: the needle's models rest.
TickOutput HapticTick::State::feel(const Vec3& tip, const Vec3& axis, double advance) noexcept {
  TickOutput output;
  contact.follow(tip, anatomy::nearest<anatomy::TissueId>(patient.tissues, tip, anatomy::tissue::air));
  output.velocity = motion.step(motion.depth() + advance).velocity;
  const double speed = advance / dt;
  const forces::FingertipState& felt = finger->step(tip, axis, output.events);
  output.tissue = felt.touching ? anatomy::tissue::skin : anatomy::tissue::air;
  output.resistance = felt.force;
  const haptics::ForceRequest request{.resistance = felt.force,
                                      .axis = axis,
                                      .velocity = speed,
                                      .in_contact = felt.touching,
                                      .compensation = compensation.step(hand(tip))};
  output.requested.force = request.compensation - felt.force * axis;
  output.applied.force = governor.step(request);
  output.applied.torque = governor.torque();
  output.energy = governor.passivity().energy();
  output.limits = governor.flags();
  announce_limits(output.requested.force, output);
  return output;
}

TickOutput HapticTick::State::step(const TickInput& input, const Vec3& axis) noexcept {
  const Vec3 tip = input.needle.translation();
  TickOutput output;
  output.tissue = anatomy::nearest<anatomy::TissueId>(patient.tissues, tip, anatomy::tissue::air);
  const double advance = seen ? (tip - last_tip).dot(contact.held() ? contact.direction() : axis) : 0.0;
  seen = true;
  last_tip = tip;

  // A finger that presses is lifted before there is a needle again.
  const bool stays = finger_is_down && output.tissue != anatomy::tissue::air;
  const bool was_down = finger_is_down;
  finger_is_down = finger && !contact.held() && (input.other.finger || stays);
  if (finger_is_down) return feel(tip, axis, advance);
  if (was_down) finger->reset();

  if (contact.held()) {
    contact.follow(tip, output.tissue);
  } else if (contact.touches(tip, axis, output.tissue, patient.tissues)) {
    resistance.begin(contact.entry(), contact.direction());
    constraint.begin(contact.entry(), contact.direction(), tip);
    loss.begin();
    hub.begin();
    layers.begin(contact.entry(), contact.direction());
    bow.begin();
    organs.begin();
    motion.rebase(contact.depth(tip) - advance);
    output.events.push({forces::EventKind::contact, output.tissue, 0.0, 0.0});
  } else if (BodyPort* const body = resistance.body()) {
    body->approach(tip, axis);
  }

  // Outside, the estimator follows the motion along the needle; in contact, the depth along the frozen line.
  const AxialMotion moving = motion.step(contact.held() ? contact.depth(tip) : motion.depth() + advance);
  output.velocity = moving.velocity;

  // Along the frozen line, not the present axis: the deformation is measured there, so the work of the resistance is
  // that of the law, and a tilt of the hand neither gains nor loses energy.
  haptics::ForceRequest request{.axis = contact.held() ? contact.direction() : axis,
                                .velocity = advance / dt,
                                .compensation = compensation.step(hand(tip))};
  double stiffness = 0.0;
  if (contact.held()) {
    forces::NeedleInTissue needle{.motion = moving,
                                  .tip = tip,
                                  .tissue = output.tissue,
                                  .axis = axis,
                                  .side = input.needle.linear().col(0),
                                  .rail = constraint.rail(),
                                  .thumb_force = input.thumb.force(),
                                  .stylet_moved = input.other.stylet_moved,
                                  .manometer_moved = input.other.manometer_moved};
    if (buckles) place_tip(needle);
    output.depth = needle.motion.depth;
    const forces::ResistanceForce tissue_force = resistance.step(needle, output.events);
    stiffness = tissue_force.stiffness;
    resistance.publish(output.diagnostics);
    if (tissue_force.in_contact) {
      request.in_contact = output.in_contact = true;
      double along = tissue_force.along;
      if (deforms) along = follow_layers(needle, tissue_force, output);
      const double share = organs.step(tip, output.tissue);
      request.resistance = output.resistance =
          share * along + hub.step(moving.depth, stiffness, output.tissue, output.events);
      const bool feels_flavum = deforms && layers.felt() == anatomy::tissue::ligamentum_flavum;
      loss.step(needle.motion, feels_flavum ? layers.felt() : output.tissue, tissue_force.along, output.events);
      const Wrench held = constraint.step(tip, axis, resistance.has_lateral_force());
      request.constraint = share * Vec3(tissue_force.across + held.force);
      request.torque = output.requested.torque = share * Vec3(tissue_force.torque + held.torque);
      output.constraint = request.constraint.norm();
    } else {
      output.events.push({forces::EventKind::withdrawn, output.tissue, output.depth, 0.0});
      contact.release();
    }
  }
  if (!deforms || (!contact.held() && output.tissue == anatomy::tissue::air)) announce_tissue(tip, output);

  output.requested.force = request.constraint - request.resistance * request.axis + request.compensation;
  output.applied.force = governor.step(request);
  output.applied.torque = governor.torque();
  output.energy = governor.passivity().energy();
  output.limits = governor.flags();
  if (stiffness > patient.description.device.stiffness) output.limits |= haptics::force_limit::stiffness;
  announce_limits(output.requested.force, output);
  return output;
}

HapticTick::HapticTick(const anatomy::Case& patient) : state_(std::make_unique<State>(patient)) {}
HapticTick::~HapticTick() = default;
HapticTick::HapticTick(HapticTick&&) noexcept = default;
HapticTick& HapticTick::operator=(HapticTick&&) noexcept = default;

double HapticTick::dt() const noexcept {
  return state_->dt;
}

BodyPort* HapticTick::body() noexcept {
  return state_->resistance.body();
}

void HapticTick::hold_breath() noexcept {
  state_->breath.reset();
}

void HapticTick::set_breath(const anatomy::BreathState& moment) noexcept {
  if (state_->breath) state_->breath->clock.set(moment);
}

std::span<const forces::DiagnosticName> HapticTick::diagnostic_names() const noexcept {
  return state_->resistance.diagnostic_names();
}

double HapticTick::stiffness_scale() const noexcept {
  return state_->resistance.stiffness_scale();
}

void HapticTick::reset() noexcept {
  State& state = *state_;
  state.motion.reset();
  if (state.breath) {
    state.breath->clock.reset();
    state.breath->of_tip.setZero();
  }
  state.resistance.reset();
  state.governor.reset();
  state.contact.reset();
  if (state.finger) state.finger->reset();
  state.seen = state.anything_announced = state.finger_is_down = false;
  state.announced = anatomy::tissue::air;
  state.quiet_ticks = limit_event_rest;
  state.last = TickOutput{};
}

TickOutput HapticTick::step(const TickInput& input) noexcept {
  State& state = *state_;
  const Vec3 tip = input.needle.translation();
  const Vec3 axis = needle_axis(input.needle);
  const double length = axis.norm();
  const bool usable = (tip.array().abs() <= farthest_tip).all() && length > 1e-6 && length < 1e6;  // NaN is not
  if (state.governor.failed() || !usable) return state.fault();

  TickOutput output = state.step(state.breath ? state.breath->in_material(input, body()) : input, axis / length);
  if (state.breath) {
    output.drawn_in = state.breath->clock.drawn_in();
    output.breath = state.breath->clock.moment();
  }
  if (state.governor.failed()) {  // a model returned a non-finite number: keep the previous values
    state.last.events.clear();
    state.last.requested = Wrench{};
    state.last.resistance = state.last.constraint = state.last.velocity = 0.0;
    state.last.applied = output.applied;
    state.last.limits = output.limits;
    TickOutput failed = state.last;
    failed.events.push({forces::EventKind::fault, failed.tissue, failed.depth, 0.0});
    return failed;
  }
  state.last = output;
  return output;
}

}  // namespace bodkin::simulation
