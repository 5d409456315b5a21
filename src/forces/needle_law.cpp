#include "forces/needle_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

#include "core/repeatable.h"

namespace bodkin::forces {

namespace {

constexpr double torn_share = 0.77;            // 0.61 / (0.61 + 0.18), Barnett et al. 2015
constexpr double usual_bevel = 20.0;           // deg, of the quincke needle whose factor is 1
constexpr double stretched = 1.22;             // s of tips without an edge; from 1.08 at 12 deg
constexpr double reference_diameter = 0.7176;  // mm, 22 G, for numbers without a known needle
constexpr double friction_diameter = 1.27;     // mm, of the needle of Okamura et al. 2004
constexpr double softest_wall = 0.01;          // N/mm
constexpr double sideways_share = 0.3;         // of the proxy's climb, to slide across
constexpr double least_force = 1e-3;           // N, of laws that need a positive force

double radians(double degrees) noexcept {
  return degrees * std::numbers::pi / 180.0;
}

double torn(anatomy::NeedleTip tip) noexcept {
  switch (tip) {
    case anatomy::NeedleTip::whitacre:
    case anatomy::NeedleTip::sprotte:
    case anatomy::NeedleTip::conical:
    case anatomy::NeedleTip::filiform:
      return stretched;
    case anatomy::NeedleTip::trephine:
      return std::numbers::pi;
    case anatomy::NeedleTip::quincke:
    case anatomy::NeedleTip::tuohy:
    case anatomy::NeedleTip::chiba:
    case anatomy::NeedleTip::diamond:
      break;
  }
  return 1.0;
}

// The tearing part of tip_factor().
double torn_factor(const anatomy::Needle& needle) noexcept {
  return torn_share * torn(needle.tip);
}

const anatomy::PhysicalTissue* skin_of(const anatomy::Case& patient) noexcept {
  if (patient.description.haptics.mechanics != anatomy::Mechanics::physical) return nullptr;
  const anatomy::TissueProperties* skin = patient.library.find(anatomy::tissue::skin);
  return skin != nullptr && skin->physical.puncture_force > 0.0 ? &skin->physical : nullptr;
}

// Eq. 2 passes through the force at its dimpling. Where its curve would be steeper than the device can render, it
// becomes almost a straight line, which dimples least.
void press_through(anatomy::LayeredTissue& layered, double force, double stiffness, double device) {
  const double dimpling = force / stiffness;
  const auto fit = [&] {
    const double a = dimpling / layered.element_spacing;
    layered.stiffness = std::clamp(6.0 * force / (layered.element_spacing * a * (a + 1.0) * (a + 2.0)), 1e-6, 100.0);
    return layered.stiffness * (3.0 * a * a + 6.0 * a + 2.0) / 6.0;
  };
  if (fit() <= device) return;
  layered.element_spacing = std::clamp(20.0 * dimpling, 0.01, 100.0);
  fit();
}

// `trailing`: mm, of depth_profile.
void derive(anatomy::TissueProperties& tissue, const anatomy::Needle& needle, double device, double trailing) {
  const anatomy::PhysicalTissue& is = tissue.physical;
  const double force = puncture_force(is, needle);
  const double stiffness = std::min(boundary_stiffness(is, needle), device);
  const double friction = friction_per_length(is, needle);
  const double wider = needle.outer_diameter / reference_diameter;

  anatomy::LayeredTissue& layered = tissue.layered;
  if (layered.kind == anatomy::LayeredKind::viscoelastic) {
    layered.break_force = std::clamp(force, least_force, 100.0);
    layered.break_force_rate = 0.0;
    if (stiffness > 0.0) press_through(layered, force, stiffness, device);
    const double ratio = layered.dynamic_friction > 0.0 ? friction / layered.dynamic_friction : 1.0;
    layered.dynamic_friction = std::min(friction, 10.0 / is.static_ratio);
    layered.static_friction = layered.dynamic_friction * is.static_ratio;
    layered.shaft_stiffness = std::clamp(layered.shaft_stiffness * ratio, 1e-6, 100.0);
    layered.shaft_viscosity *= wider;
  }
  layered.drag = std::min(layered.drag * wider, 10.0);

  // As stiff as possible: a thin layer reaches its force before it is passed.
  tissue.tracking_wall = {.stiffness = std::clamp(device, softest_wall, 100.0), .force = std::min(force, 50.0)};
  if (tissue.depth_profile.kind == anatomy::DepthProfileKind::soft)
    tissue.depth_profile = {.kind = tissue.depth_profile.kind, .stiffness = std::min(force / trailing, device)};
  anatomy::ProxyProperties& proxy = tissue.volume_proxy.properties;
  proxy.penetrability = std::min(force, 50.0);
  proxy.friction = sideways_share * proxy.penetrability;
  proxy.drag = std::min(proxy.drag * wider, 50.0);
  proxy.viscosity = std::min(proxy.viscosity * wider, 10.0);

  anatomy::ShaftFrictionTissue& shaft = tissue.shaft_friction;
  if (shaft.coulomb > 0.0) shaft.stiffness = std::clamp(shaft.stiffness * friction / shaft.coulomb, 1e-6, 100.0);
  shaft.coulomb = std::min(friction, 10.0 / is.static_ratio);
  shaft.static_force = shaft.coulomb * is.static_ratio;
  shaft.viscous = std::min(shaft.viscous * wider, 1.0);

  tissue.deformable.friction = std::min(friction, 10.0);
  tissue.deformable.puncture_force = std::min(force, 100.0);
  tissue.deformable.cutting_force = std::min(cutting_force(is, needle), 100.0);
  tissue.deformable.stiffness = stiffness;
}

double trailing_of(const anatomy::Case& patient) {
  const auto* own = std::get_if<anatomy::DepthProfileSettings>(&patient.description.haptics.resistance);
  return felt_settings(own != nullptr ? *own : anatomy::DepthProfileSettings{}, patient).trailing;
}

}  // namespace

double tip_factor(const anatomy::Needle& needle) noexcept {
  const double spread =
      repeatable::tan(radians(anatomy::bevel_angle(needle))) / repeatable::tan(radians(usual_bevel));
  return torn_factor(needle) + (1.0 - torn_share) * spread;
}

double puncture_force(const anatomy::PhysicalTissue& tissue, const anatomy::Needle& needle) noexcept {
  if (!(tissue.puncture_force > 0.0)) return 0.0;
  const anatomy::Needle reference = {.tip = tissue.reference_tip};
  return tissue.puncture_force * repeatable::pow(needle.outer_diameter / tissue.reference_diameter, tissue.exponent) *
         tip_factor(needle) / tip_factor(reference);
}

double cutting_force(const anatomy::PhysicalTissue& tissue, const anatomy::Needle& needle) noexcept {
  return tissue.cutting_share * puncture_force(tissue, needle) * torn_factor(needle) / tip_factor(needle);
}

double boundary_stiffness(const anatomy::PhysicalTissue& tissue, const anatomy::Needle& needle) noexcept {
  return tissue.puncture_force / tissue.dimpling * needle.outer_diameter / tissue.reference_diameter;
}

double friction_per_length(const anatomy::PhysicalTissue& tissue, const anatomy::Needle& needle) noexcept {
  return tissue.friction * std::numbers::pi * needle.outer_diameter;
}

bool is_described(const anatomy::PhysicalTissue& tissue) noexcept {
  return tissue.puncture_force > 0.0 || tissue.friction > 0.0;
}

anatomy::TissueLibrary effective_tissues(const anatomy::Case& patient) {
  if (patient.description.haptics.mechanics != anatomy::Mechanics::physical) return patient.library;
  std::vector<anatomy::TissueProperties> tissues = patient.library.tissues();
  const double trailing = trailing_of(patient);
  for (anatomy::TissueProperties& tissue : tissues) {
    if (is_described(tissue.physical))
      derive(tissue, patient.description.needle, patient.description.device.stiffness, trailing);
  }
  return anatomy::TissueLibrary(std::move(tissues));
}

anatomy::DepthProfileSettings felt_settings(const anatomy::DepthProfileSettings& settings,
                                            const anatomy::Case& patient) {
  anatomy::DepthProfileSettings felt = settings;
  const anatomy::PhysicalTissue* skin = skin_of(patient);
  if (skin == nullptr) return felt;
  const anatomy::Needle& needle = patient.description.needle;
  const double stiffness = std::min(boundary_stiffness(*skin, needle), patient.description.device.stiffness);
  felt.skin_stiffness = std::clamp(stiffness, 0.01, 10.0);
  felt.puncture_depth = std::clamp(puncture_force(*skin, needle) / felt.skin_stiffness, 0.1, 50.0);
  felt.trailing = std::min(felt.trailing, felt.puncture_depth);
  return felt;
}

anatomy::ThreeComponentSettings felt_settings(const anatomy::ThreeComponentSettings& settings,
                                              const anatomy::Case& patient) {
  anatomy::ThreeComponentSettings felt = settings;
  const anatomy::PhysicalTissue* skin = skin_of(patient);
  if (skin == nullptr) return felt;
  const anatomy::Needle& needle = patient.description.needle;
  felt.puncture_force = std::clamp(puncture_force(*skin, needle), 0.01, 50.0);
  const double share = felt.puncture_force / settings.puncture_force;
  felt.linear = settings.linear * share;
  felt.quadratic = settings.quadratic * share;
  felt.cutting_force = settings.cutting_force * share;
  // Its slope where it breaks, sqrt(a1^2 + 4 a2 F), is no steeper than the device can render.
  for (int step = 0; step < 200; ++step) {
    const double slope = std::sqrt(felt.linear * felt.linear + 4.0 * felt.quadratic * felt.puncture_force);
    if (slope <= patient.description.device.stiffness) break;
    felt.linear *= 0.97;
    felt.quadratic *= 0.97;
  }
  for (anatomy::KarnoppFriction* way : {&felt.inwards, &felt.outwards}) {
    const double wider = needle.outer_diameter / friction_diameter;
    way->coulomb *= wider;
    way->viscous *= wider;
    way->static_force *= wider;
  }
  return felt;
}

anatomy::FractureSettings felt_settings(const anatomy::FractureSettings& settings, const anatomy::Case& patient) {
  anatomy::FractureSettings felt = settings;
  if (skin_of(patient) == nullptr) return felt;
  const anatomy::Needle& needle = patient.description.needle;
  felt.width = std::clamp(needle.outer_diameter, 0.05, 5.0);
  felt.toughness = std::min(settings.toughness * tip_factor(needle), 100.0);
  felt.cutting_toughness = std::min(settings.cutting_toughness * tip_factor(needle), 100.0);
  return felt;
}

}  // namespace bodkin::forces
