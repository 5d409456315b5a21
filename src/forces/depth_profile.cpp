#include "forces/depth_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "forces/device_stability.h"
#include "forces/model_input.h"
#include "forces/needle_law.h"

namespace bodkin::forces {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

DepthProfile::DepthProfile(const anatomy::TissueLibrary& library, const anatomy::DepthProfileSettings& settings,
                           double dt)
    : settings_(settings),
      tissues_(library.by_id(&anatomy::TissueProperties::depth_profile)),
      dt_(dt),
      filter_(settings.filter, dt),
      punctures_(settings.channel_radius, settings.channel_tilt),
      bone_(infinity) {
  constexpr auto model = "depth_profile";
  check_tick(model, dt);
  check(settings, model);
  check_tissues(library, &anatomy::TissueProperties::depth_profile, model);
}

void DepthProfile::begin(const Vec3& entry, const Vec3& direction) noexcept {
  punctures_.enter(entry, direction);
  inside_ = false;
}

void DepthProfile::reset() noexcept {
  punctures_.clear();
  inside_ = false;
}

// A change of tissue counts at once; reverting it needs one voxel of travel, so that flickering labels at the border
// of two tissues have no effect.
void DepthProfile::settle(double depth, anatomy::TissueId tissue) noexcept {
  if (tissue == settled_) return;
  if (tissue == previous_ && std::abs(depth - changed_at_) < settings_.hysteresis) return;
  previous_ = settled_;
  settled_ = tissue;
  changed_at_ = depth;
}

double DepthProfile::filtered_stiffness(double depth) noexcept {
  const anatomy::DepthProfileTissue& here = tissues_[settled_];
  const double before = filter_.value();
  const double after = filter_.step(std::clamp(here.stiffness + here.slope * depth, 0.0, 10.0));
  const double fastest = settings_.stiffening * dt_;
  if (after - before > fastest) filter_.reset(before + fastest);
  return filter_.value();
}

// Stiffness may change under load only so that the stored energy does not grow.
void DepthProfile::change_stiffness(double depth, double k) noexcept {
  if (k > k_ && depth > reference_) reference_ = depth - k_ / k * (depth - reference_);
  k_ = k;
}

double DepthProfile::soft_force(const AxialMotion& motion) noexcept {
  const double d = motion.depth;
  double left = settings_.release > 0.0 ? std::max(0.0, 1.0 - releasing_ * dt_ / settings_.release) : 0.0;
  if (motion.stopped || motion.direction == 0) {
    if (releasing_ == 0.0) left = 1.0;
  } else if (motion.direction > 0) {
    if (releasing_ > 0.0) reference_ = d - left * std::max(0.0, d - reference_);  // same force before and after
    releasing_ = 0.0;
    left = 1.0;
    reference_ = std::max(reference_, d - settings_.trailing);
  } else {
    releasing_ += 1.0;
    left = settings_.release > 0.0 ? std::max(0.0, 1.0 - releasing_ * dt_ / settings_.release) : 0.0;
    if (left == 0.0) reference_ = d;
  }
  if (d <= reference_) {
    reference_ = d;
    releasing_ = 0.0;
    return 0.0;
  }
  return k_ * left * (d - reference_);
}

double DepthProfile::skin_force(const AxialMotion& motion, TickEvents& events) noexcept {
  const double d = motion.depth;
  const double force = settings_.skin_stiffness * d;
  if (d < settings_.puncture_depth) return force;
  punctured_ = true;
  events.push({EventKind::puncture, anatomy::tissue::skin, d, std::min(force, settings_.limit)});
  const anatomy::DepthProfileTissue& here = tissues_[settled_];
  filter_.reset(std::clamp(here.stiffness + here.slope * d, 0.0, 10.0));
  k_ = filter_.value();
  releasing_ = 0.0;
  reference_ = d - (k_ > 0.0 ? std::min(settings_.trailing, force / k_) : settings_.trailing);
  return soft_force(motion);
}

void DepthProfile::watch_bone(double depth, anatomy::TissueId tissue, TickEvents& events) noexcept {
  const bool bone_here = tissues_[tissue].kind == anatomy::DepthProfileKind::bone;
  if (in_bone_ && depth < bone_) {
    in_bone_ = false;
    events.push({EventKind::bone_left, tissue, depth, 0.0});
  } else if (!in_bone_ && bone_here) {
    // Known bone is met where it was; new bone, a voxel or more in front of it, at the tip.
    if (depth < bone_ && depth > bone_ - settings_.hysteresis) return;
    if (depth < bone_) bone_ = depth;
    in_bone_ = true;
    events.push({EventKind::bone_contact, tissue, depth, 0.0});
  }
}

double DepthProfile::step(const AxialMotion& motion, anatomy::TissueId tissue, TickEvents& events) noexcept {
  const double d = motion.depth;
  if (!usable(motion)) {
    events.push({EventKind::fault, tissue, reference_, 0.0});
    return 0.0;
  }
  if (d <= 0.0) {  // AIR
    if (inside_) events.push({EventKind::withdrawn, tissue, d, 0.0});
    inside_ = false;
    return 0.0;
  }
  if (!inside_) {
    events.push({EventKind::contact, tissue, d, 0.0});
    inside_ = true;
    in_bone_ = false;
    bone_ = infinity;
    punctured_ = punctures_.deepest() >= settings_.puncture_depth;
    settled_ = previous_ = tissue;
    changed_at_ = reference_ = 0.0;
    releasing_ = 0.0;
    const anatomy::DepthProfileTissue& here = tissues_[tissue];
    filter_.reset(here.stiffness);
    k_ = here.stiffness;
  }
  punctures_.deepen(d);
  watch_bone(d, tissue, events);

  const anatomy::TissueId before = settled_;
  if (tissues_[tissue].kind != anatomy::DepthProfileKind::bone) settle(d, tissue);
  const anatomy::DepthProfileKind kind = tissues_[settled_].kind;
  if (settled_ != before && kind == anatomy::DepthProfileKind::organ) {
    events.push({EventKind::tissue_entered, settled_, d, 0.0});
  }

  double force = 0.0;
  if (!punctured_) {
    force = skin_force(motion, events);
  } else if (kind == anatomy::DepthProfileKind::nothing || kind == anatomy::DepthProfileKind::organ) {
    reference_ = d;
    releasing_ = 0.0;
    filter_.reset(0.0);
    k_ = 0.0;
  } else {
    if (!in_bone_ && kind == anatomy::DepthProfileKind::soft) change_stiffness(d, filtered_stiffness(d));
    force = soft_force(motion);
  }
  if (in_bone_) force = std::max(force, settings_.bone_stiffness * (d - bone_));
  return std::clamp(force, 0.0, settings_.limit);
}

DepthProfile::DepthProfile(const anatomy::Case& patient, const anatomy::DepthProfileSettings& settings, double dt)
    : DepthProfile(effective_tissues(patient), felt_settings(settings, patient), dt) {
  const anatomy::DeviceLimits& device = patient.description.device;
  require_stable("depth_profile", "skin stiffness", settings_.skin_stiffness, device);
  require_stable("depth_profile", "bone stiffness", settings_.bone_stiffness, device);
  firm_stiffness_ = std::max(settings_.bone_stiffness, settings_.skin_stiffness);
  const anatomy::TissueLibrary library = effective_tissues(patient);
  for (const anatomy::TissueProperties& tissue : library.tissues()) {
    require_stable("depth_profile", "the spring of " + tissue.title, tissue.depth_profile.stiffness, device);
    firm_stiffness_ = std::max(firm_stiffness_, tissue.depth_profile.stiffness);
  }
}

ResistanceForce DepthProfile::step(const NeedleInTissue& needle, TickEvents& events) noexcept {
  const double force = step(needle.motion, needle.tissue, events);
  const double behind = in_bone_ ? bone_ : k_ > 0.0 ? reference_ : needle.motion.depth;
  return {.along = force, .material = punctured_ ? behind : 0.0, .in_contact = needle.motion.depth > 0.0};
}

template <>
ResistanceEntry resistance_with<anatomy::DepthProfileSettings>() {
  return entry_of<DepthProfile>();
}

}  // namespace bodkin::forces
