#include "forces/layered.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.h"
#include "core/random.h"
#include "forces/model_input.h"
#include "forces/needle_law.h"

namespace bodkin::forces {

namespace {

constexpr double speed_floor = 1.0;         // v0 of the break rule, mm/s
constexpr double fade_time = 0.020;         // s in which viscous terms return after bone
constexpr double furthest_tenting = -10.0;  // mm, beyond which the skin lets go
constexpr double sliver = 1.0;              // mm; a thinner run inside one tissue is noise of the labels
constexpr double rough_cell = 0.1;          // mm
constexpr double bone_slack = 0.2;          // mm off the bone that make an event
constexpr double longest_path = 400.0;      // mm of a patient's line; greater depths count as 400 mm
constexpr double least_grip_budget = 0.1;   // of the device's stiffness
constexpr std::uint64_t rough_seed = 0x6e65656c65;

}  // namespace

Layered::Layered(const anatomy::TissueLibrary& library, const anatomy::LayeredSettings& settings,
                 double device_stiffness, double dt, double longest, bool one_face)
    : layer_(settings.layer),
      dt_(dt),
      device_stiffness_(device_stiffness),
      strict_(settings.strict),
      one_face_(one_face),
      sliver_layers_(std::max(0, static_cast<int>(std::ceil(sliver / settings.layer - 1e-9)) - 1)) {
  const VoigtSum sum = settings.law == anatomy::LayeredLaw::cubic ? VoigtSum::cubic : VoigtSum::piecewise;
  check(settings, "layered");
  check_tissues(library, &anatomy::TissueProperties::layered, "layered");
  for (const anatomy::TissueProperties& tissue : library.tissues()) {
    const anatomy::LayeredTissue& p = tissue.layered;
    Law& law = laws_[tissue.id];
    law.kind = p.kind;
    law.drag = p.drag;
    law.contact_stiffness = std::min(p.contact_stiffness, device_stiffness);
    if (p.kind != anatomy::LayeredKind::viscoelastic) continue;
    law.push = VoigtLaw(sum, p.stiffness, p.viscosity, p.element_spacing);
    // The law is stiffest where it breaks. A tissue too stiff for the device gives way over a longer distance, at the
    // same forces.
    const double scale = std::min(1.0, device_stiffness / law.push.tangent(law.push.inverse(p.break_force)));
    if (scale < 1.0) law.push = law.push.softened(scale);
    stiffness_scale_ = std::min(stiffness_scale_, scale);
    law.grip = VoigtLaw(sum, p.shaft_stiffness, p.shaft_viscosity, p.shaft_spacing);
    law.break_force = p.break_force;
    law.break_force_rate = p.break_force_rate;
    law.static_friction = p.static_friction;
    law.dynamic_friction = p.dynamic_friction;
    law.roughness = p.roughness;
    law.rough = p.roughness > 0.0;
    law.slip_strain = law.grip.inverse(p.dynamic_friction);
    law.most_strain = law.grip.inverse(p.static_friction);
    law.breakaway_tangent = law.grip.tangent(law.most_strain);
  }
  blocks_.resize(static_cast<std::size_t>(std::ceil(longest / layer_)) + 2);
}

void Layered::begin() noexcept {
  known_ = 0;
  revealed_ = -1;
  last_punctured_ = -1;
  bone_near_ = std::numeric_limits<double>::infinity();
  last_depth_ = 0.0;
  softening_ = 1.0;
  viscous_ = 1.0;
  bone_reported_ = false;
}

// Creates blocks for the layers that the tip has reached. A run thinner than 1 mm (the voxel of the paper) with the
// same tissue on both sides is noise of the labels, not an organ to be punctured; bone is never treated as noise.
// Nothing behind bone is reached.
void Layered::reveal(int tip_layer, std::span<const anatomy::TissueId> layers) noexcept {
  const int end = static_cast<int>(layers.size());
  while (revealed_ < tip_layer && revealed_ + 1 < end && bone_near_ == std::numeric_limits<double>::infinity()) {
    const int next = revealed_ + 1;
    const anatomy::TissueId tissue = layers[static_cast<std::size_t>(next)];
    if (known_ > 0) {
      Block& current = blocks_[known_ - 1];
      int resumes = next;  // the layer at which the current tissue continues
      while (resumes < end && resumes - next <= sliver_layers_ &&
             layers[static_cast<std::size_t>(resumes)] != current.tissue &&
             laws_[layers[static_cast<std::size_t>(resumes)]].kind != anatomy::LayeredKind::rigid) {
        ++resumes;
      }
      if (resumes < end && resumes - next <= sliver_layers_ &&
          layers[static_cast<std::size_t>(resumes)] == current.tissue) {
        current.last = revealed_ = resumes;
        continue;
      }
    }
    if (known_ == blocks_.size()) return;
    blocks_[known_] = Block{.tissue = tissue, .first = next, .last = next, .near = next * layer_};
    ++known_;
    revealed_ = next;
    if (laws_[tissue].kind == anatomy::LayeredKind::rigid) bone_near_ = next * layer_;
  }
}

// A tip that reaches a block presses on its face; a block punctured before grips the shaft at once.
void Layered::touch(Block& block) const noexcept {
  if (block.first > last_punctured_) {
    block.mode = Mode::pressed;
    block.strain = one_face_ ? std::max(0.0, last_depth_ - block.near) : 0.0;
  } else {
    block.mode = Mode::held;
    block.strain = 0.0;
    block.contact = std::clamp(last_depth_ - block.near, 0.0, length(block));
  }
}

bool Layered::breaks(const Law& law, double force, const AxialMotion& motion) const noexcept {
  if (strict_) {  // eq. 3 times v, so that nothing is divided
    return motion.velocity > 0.0 &&
           force * motion.velocity >= law.break_force * motion.velocity + law.break_force_rate;
  }
  if (motion.direction <= 0) return false;
  return force >= law.break_force + law.break_force_rate / (std::max(0.0, motion.velocity) + speed_floor);
}

void Layered::press(Block& block, const Law& law, const AxialMotion& motion, Sums& sums,
                    TickEvents& events) noexcept {
  const double x = motion.depth - block.near - block.strain;
  if (x < 0.0) {
    block.mode = Mode::untouched;
    return;
  }
  const double force = law.push.push(x, motion.velocity * viscous_);  // eq. 2
  if (breaks(law, force, motion)) {
    last_punctured_ = std::max(last_punctured_, block.first);
    block.mode = Mode::held;
    block.strain = 0.0;
    block.contact = std::min(x, length(block));
    sums.gripped = true;
    events.push({EventKind::puncture, block.tissue, motion.depth, force});
    return;
  }
  sums.resistance += force;
  sums.firm_stiffness += law.push.tangent(x);
  sums.first_pressed = std::min(sums.first_pressed, block.near);
}

void Layered::hold(Block& block, const Law& law, const AxialMotion& motion, double advance, Sums& sums) noexcept {
  // No tissue is stretched beyond its static friction, however far the needle moved in one tick.
  block.strain = std::clamp(block.strain + softening_ * advance, -law.most_strain, law.most_strain);
  const double friction = law.grip.grip(block.strain, motion.velocity * viscous_);  // eq. 4
  sums.resistance += grip_ * friction * block.contact;
  sums.shaft += grip_ * friction * block.contact;
  sums.friction_stiffness += grip_ * law.breakaway_tangent * block.contact;
  sums.held_stiffness += softening_ * grip_ * law.grip.tangent(std::abs(block.strain)) * block.contact;
  sums.gripped = true;
  const bool at_limit = std::abs(friction) > law.static_friction || std::abs(block.strain) == law.most_strain;
  if (at_limit && block.strain * advance > 0.0) {  // eq. 14
    block.mode = Mode::sliding;
    block.slide = block.strain > 0.0 ? 1 : -1;
    block.furthest = motion.depth;
  } else if (block.contact <= 0.0) {
    block.mode = Mode::untouched;
  }
}

void Layered::slide(Block& block, const Law& law, const AxialMotion& motion, Sums& sums) noexcept {
  const double sense = block.slide;
  block.furthest = sense > 0.0 ? std::max(block.furthest, motion.depth) : std::min(block.furthest, motion.depth);
  block.contact = std::clamp(block.furthest - block.near, 0.0, length(block));
  if (block.contact <= 0.0) {
    block.mode = Mode::untouched;
    return;
  }
  sums.gripped = true;
  double dynamic = law.dynamic_friction;  // eq. 5, 7
  double slip = law.slip_strain;
  if (law.rough) dynamic *= 1.0 + law.roughness * roughness(block.furthest);
  // A needle that reverses stretches the tissue the other way at once; the estimate of its direction follows some
  // ticks later. The force follows the position, so that the delay adds no energy.
  const double back = softening_ * sense * (block.furthest - motion.depth);
  const bool ends = motion.stopped || motion.direction == -block.slide;
  if (law.rough && (back > 0.0 || ends)) slip = law.grip.inverse(std::min(dynamic, law.static_friction));
  const double strain = std::max(slip - back, -law.most_strain);
  const double friction = back > 0.0 ? law.grip.grip(sense * strain, 0.0) : sense * dynamic;
  sums.resistance += grip_ * friction * block.contact;
  sums.shaft += grip_ * friction * block.contact;
  sums.friction_stiffness += grip_ * law.breakaway_tangent * block.contact;
  if (ends) {
    block.mode = Mode::held;
    block.strain = sense * strain;
  }
}

// Smooth noise in [-1, 1], the same at the same depth in every run and at every rate.
double Layered::roughness(double depth) noexcept {
  const double place = depth / rough_cell;
  const double cell = std::floor(place);
  const auto index = static_cast<std::int64_t>(cell);
  if (index != rough_cell_) {
    rough_cell_ = index;
    rough_low_ = hash_noise(rough_seed, index);
    rough_high_ = hash_noise(rough_seed, index + 1);
  }
  return rough_low_ + (place - cell) * (rough_high_ - rough_low_);
}

void Layered::report_bone(double depth, bool in_bone, TickEvents& events) noexcept {
  if (in_bone && !bone_reported_) {
    bone_reported_ = true;
    events.push({EventKind::bone_contact, blocks_[known_ - 1].tissue, depth, 0.0});
  } else if (bone_reported_ && depth < bone_near_ - bone_slack) {
    bone_reported_ = false;
    events.push({EventKind::bone_left, blocks_[known_ - 1].tissue, depth, 0.0});
  }
}

LayeredForce Layered::step(const AxialMotion& motion, std::span<const anatomy::TissueId> layers, TickEvents& events,
                           double grip) noexcept {
  grip_ = grip;
  const double advance = motion.depth - last_depth_;
  last_depth_ = motion.depth;
  const double deepest_layer = static_cast<double>(layers.size()) - 1.0;
  const int tip_layer = static_cast<int>(std::clamp(std::floor(motion.depth / layer_), -1.0, deepest_layer));
  reveal(tip_layer, layers);

  const bool in_bone = motion.depth > bone_near_;
  viscous_ = in_bone ? 0.0 : std::min(1.0, viscous_ + dt_ / fade_time);

  Sums sums;
  double viscous_length_drag = 0.0;
  for (std::size_t index = 0; index < known_; ++index) {
    Block& block = blocks_[index];
    const Law& law = laws_[block.tissue];
    if (law.kind == anatomy::LayeredKind::viscoelastic) {
      const bool is_near = block.mode == Mode::untouched && tip_layer >= block.first;
      if (is_near && !(one_face_ && std::isfinite(sums.first_pressed))) touch(block);
      if (block.mode == Mode::pressed) {
        press(block, law, motion, sums, events);
      } else if (block.mode == Mode::held) {
        hold(block, law, motion, advance, sums);
      } else if (block.mode == Mode::sliding) {
        slide(block, law, motion, sums);
      }
    } else if (law.kind == anatomy::LayeredKind::viscous) {
      const double reach = std::min(motion.depth, sums.first_pressed);
      viscous_length_drag += law.drag * std::clamp(reach - block.near, 0.0, length(block));  // eq. 13
    } else if (law.kind == anatomy::LayeredKind::rigid && in_bone) {
      sums.resistance += law.contact_stiffness * (motion.depth - block.near);
      sums.firm_stiffness += law.contact_stiffness;
    }
  }
  sums.resistance += viscous_length_drag * motion.velocity * viscous_;

  // The held shaft shares the device's stiffness with the other elastic parts: a longer shaft deforms over a longer
  // distance.
  const double budget = std::max(least_grip_budget * device_stiffness_, device_stiffness_ - sums.firm_stiffness);
  softening_ = sums.friction_stiffness > budget ? budget / sums.friction_stiffness : 1.0;

  report_bone(motion.depth, in_bone, events);
  const bool in_contact = motion.depth > 0.0 || (sums.gripped && motion.depth > furthest_tenting);
  if (!in_contact) return {};
  return {.resistance = sums.resistance,
          .stiffness = sums.firm_stiffness + sums.held_stiffness,
          .shaft = sums.shaft,
          .material = std::min(sums.first_pressed, bone_near_),
          .in_contact = true,
          .in_bone = in_bone};
}

LayeredResistance::LayeredResistance(const anatomy::Case& patient, const anatomy::LayeredSettings& settings,
                                     double dt)
    : model_(effective_tissues(patient), settings, patient.description.device.stiffness, dt, longest_path,
             patient.description.haptics.mechanics == anatomy::Mechanics::physical),
      path_(settings.layer, longest_path),
      volume_(&patient.tissues) {}

void LayeredResistance::begin(const Vec3& entry, const Vec3& direction) noexcept {
  path_.restart(entry, direction);
  model_.begin();
}

ResistanceForce LayeredResistance::step(const NeedleInTissue& needle, TickEvents& events) noexcept {
  path_.extend_to(std::min(needle.motion.depth + model_.look_ahead(), longest_path), *volume_);
  found_ = model_.step(needle.motion, path_.layers(), events, needle.grip);
  return {.along = found_.resistance,
          .stiffness = found_.stiffness,
          .material = found_.material,
          .in_contact = found_.in_contact};
}

template <>
ResistanceEntry resistance_with<anatomy::LayeredSettings>() {
  return entry_of<LayeredResistance>();
}

}  // namespace bodkin::forces
