#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "study/fitting/fit_model.h"
#include "study/fitting/simulate.h"
#include <fmt/format.h>

#include "forces/depth_profile.h"
#include "forces/shaft_friction.h"

namespace bodkin::study {

namespace {

// The values: skin's stiffness, puncture depth, a stiffness for each layer, trailing length, contact, a slope for
// each layer, then where each layer begins.
namespace profile_stack {
enum : std::size_t { skin_stiffness, puncture_depth, first };
constexpr std::size_t shared = 4;

std::size_t layers(std::span<const double> p) {
  return (p.size() - shared) / 3;
}
double trailing(std::span<const double> p) {
  return std::min(p[first + layers(p)], p[puncture_depth]);
}
double contact(std::span<const double> p) {
  return p[first + layers(p) + 1];
}
std::span<const double> slopes(std::span<const double> p) {
  return p.subspan(shared + layers(p), layers(p));
}
std::span<const double> tops(std::span<const double> p) {
  return p.subspan(shared + 2 * layers(p), layers(p));
}

using Settings = anatomy::DepthProfileSettings;
using Tissue = anatomy::DepthProfileTissue;

Settings settings_of(std::span<const double> p) {
  Settings settings;
  settings.skin_stiffness = p[skin_stiffness];
  settings.puncture_depth = p[puncture_depth];
  settings.trailing = trailing(p);
  settings.limit = no_limit<Settings>();
  return settings;
}

Tissue tissue_of(std::span<const double> p, std::size_t layer) {
  return {.kind = anatomy::DepthProfileKind::soft, .stiffness = p[first + layer], .slope = slopes(p)[layer]};
}

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> force) {
  std::vector<anatomy::TissueProperties> tissues(layers(p));
  for (std::size_t i = 0; i < tissues.size(); ++i) {
    tissues[i].id = static_cast<anatomy::TissueId>(first_layer + i);
    tissues[i].name = fmt::format("layer_{}", i + 1);
    tissues[i].depth_profile = tissue_of(p, i);
  }
  forces::DepthProfile model(anatomy::TissueLibrary(std::move(tissues)), settings_of(p), history.dt);
  const std::span<const double> begins = tops(p);
  simulate_axial(
      history, contact(p), force, [&] { model.begin(Vec3::Zero(), Vec3::UnitZ()); },
      [&](const AxialMotion& motion, forces::TickEvents& events) {
        const auto below = std::upper_bound(begins.begin() + 1, begins.end(), motion.depth);
        return model.step(motion, static_cast<anatomy::TissueId>(first_layer + (below - begins.begin() - 1)), events);
      });
}

double yields_in(std::span<const double> p, const AxialMotion& motion, std::size_t /*which*/) {
  return motion.depth - contact(p);
}

void guess(std::span<const CurveShape> shapes, std::span<double> p) {
  const CurveShape& shape = shapes.front();
  const double depth = std::max(0.1, shape.peak_depth - shape.contact);
  const std::size_t n = layers(p);
  p[skin_stiffness] = shape.peak_force / depth;
  p[first + n] = std::min(p[first + n], depth);
  p[first + n + 1] = shape.contact;
  for (std::size_t i = 0; i < n; ++i) p[first + i] = std::max(0.01, shape.after_force / p[first + n]);
}

FittedElements elements(std::span<const double> p) {
  FittedElements result{.resistance = element_of("depth_profile", settings_of(p), &Settings::skin_stiffness,
                                                 &Settings::puncture_depth, &Settings::trailing)};
  for (std::size_t i = 0; i < layers(p); ++i) {
    result.tissues.push_back(
        element_of("depth_profile", tissue_of(p, i), &Tissue::kind, &Tissue::stiffness, &Tissue::slope));
  }
  return result;
}
}  // namespace profile_stack

// The values: Coulomb friction of each layer, stiffness, viscous friction and static ratio of all, Stribeck velocity,
// contact, then where each layer begins. Stiffness and viscous friction are in proportion to the Coulomb friction, so
// that a layer without friction has none of them.
namespace friction_stack {
enum : std::size_t { stiffness, viscous, static_ratio, stribeck, contact };
constexpr std::size_t shared = 5;
using Settings = anatomy::ShaftFrictionSettings;
using Tissue = anatomy::ShaftFrictionTissue;

std::size_t layers(std::span<const double> p) {
  return (p.size() - shared) / 2;
}
double of_all(std::span<const double> p, std::size_t which) {
  return p[layers(p) + which];
}

// A product within the limits of a tissue library.
double declared(double Tissue::*member, double value) {
  const FitParameter parameter = fit_parameter(member);
  return std::clamp(value, parameter.low, parameter.high);
}

Tissue tissue_of(std::span<const double> p, std::size_t layer) {
  return {.coulomb = p[layer],
          .static_force = declared(&Tissue::static_force, of_all(p, static_ratio) * p[layer]),
          .stiffness = declared(&Tissue::stiffness, of_all(p, stiffness) * p[layer]),
          .viscous = declared(&Tissue::viscous, of_all(p, viscous) * p[layer])};
}

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> force) {
  forces::ShaftFriction model({.stribeck_velocity = of_all(p, stribeck)});
  const std::size_t n = layers(p);
  const std::span<const double> tops = p.subspan(shared + n, n);
  simulate_axial(
      history, of_all(p, contact), force, [&] { model.begin(); },
      [&](const AxialMotion& motion, forces::TickEvents& events) {
        double coulomb = 0.0;  // N, of the shaft in all layers
        for (std::size_t i = 0; i < n; ++i) {
          const double end = i + 1 < n ? std::min(tops[i + 1], motion.depth) : motion.depth;
          coulomb += p[i] * std::max(0.0, end - tops[i]);
        }
        return model.step(motion,
                          {coulomb, of_all(p, static_ratio) * coulomb, of_all(p, stiffness) * coulomb,
                           of_all(p, viscous) * coulomb},
                          events);
      });
}

void guess(std::span<const CurveShape> shapes, std::span<double> p) {
  const CurveShape& shape = shapes.front();
  const double all = std::max(1e-4, shape.end_force / std::max(0.5, shape.end_depth - shape.contact));
  for (std::size_t i = 0; i < layers(p); ++i) p[i] = all;
  p[layers(p) + contact] = shape.contact;
}

FittedElements elements(std::span<const double> p) {
  FittedElements result{.resistance = element_of("shaft_friction", Settings{.stribeck_velocity = of_all(p, stribeck)},
                                                 &Settings::stribeck_velocity)};
  for (std::size_t i = 0; i < layers(p); ++i) {
    result.tissues.push_back(element_of("shaft_friction", tissue_of(p, i), &Tissue::coulomb, &Tissue::static_force,
                                        &Tissue::stiffness, &Tissue::viscous));
  }
  return result;
}
}  // namespace friction_stack

}  // namespace

FitModel depth_profile_stack_fit(std::span<const double> tops) {
  FitModel model = {.name = "depth_profile",
                    .parameters = {fit_parameter(&profile_stack::Settings::skin_stiffness),
                                   fit_parameter(&profile_stack::Settings::puncture_depth)},
                    .yields = {profile_stack::puncture_depth},
                    .contact = profile_stack::first + tops.size() + 1,
                    .simulate = profile_stack::simulate,
                    .yields_in = profile_stack::yields_in,
                    .guess = profile_stack::guess,
                    .elements = profile_stack::elements};
  add_for_layers(model, tops.size(), fit_parameter(&profile_stack::Tissue::stiffness));
  model.parameters.push_back(fit_parameter(&profile_stack::Settings::trailing));
  model.parameters.push_back(contact_parameter());
  // A layer is thin: its stiffness and the change of it are hardly separable.
  add_for_layers(model, tops.size(), fit_parameter(&profile_stack::Tissue::slope, {.fitted = false}));
  add_tops(model, tops);
  return model;
}

FitModel shaft_friction_stack_fit(std::span<const double> tops) {
  FitModel model = {.name = "shaft_friction",
                    .contact = tops.size() + friction_stack::contact,
                    .needs_time = true,
                    .simulate = friction_stack::simulate,
                    .guess = friction_stack::guess,
                    .elements = friction_stack::elements};
  add_for_layers(model, tops.size(),
                 fit_parameter(&friction_stack::Tissue::coulomb, {.usual = usual_friction.coulomb}));
  // Ratios of two declared numbers, which no table declares.
  model.parameters.push_back({"stiffness_ratio", "1/mm", 0.01, 1000.0, 3.0});
  model.parameters.push_back({"viscous_ratio", "s/mm", 0.0, 1.0, 0.005});
  model.parameters.push_back({"static_ratio", "", 1.0, 3.0, 1.2});
  model.parameters.push_back(fit_parameter(&friction_stack::Settings::stribeck_velocity, {.fitted = false}));
  model.parameters.push_back(contact_parameter());
  add_tops(model, tops);
  return model;
}

}  // namespace bodkin::study
