#include <algorithm>
#include <cmath>

#include "study/fitting/fit_model.h"
#include "study/fitting/simulate.h"

#include "forces/depth_profile.h"
#include "forces/spring_damper_wall.h"
#include "forces/tracking_wall.h"

namespace bodkin::study {

namespace {

namespace wall {
enum : std::size_t { stiffness, wall, damping };

using Settings = anatomy::SpringDamperWallSettings;

Settings settings_of(std::span<const double> p) {
  return {.stiffness = p[stiffness], .damping = p[damping], .wall = p[wall], .limit = no_limit<Settings>()};
}

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> force) {
  forces::SpringDamperWall model(settings_of(p));
  forces::TickEvents events;
  for (std::size_t n = 0; n < history.ticks.size(); ++n)
    force[n] = model.step(history.ticks[n], anatomy::tissue::soft, events);
}

void guess(std::span<const CurveShape> shapes, std::span<double> p) {
  const CurveShape& shape = shapes.front();
  p[stiffness] = shape.slope;
  p[wall] = std::min(shape.intercept, shape.contact);
}

FittedElements elements(std::span<const double> p) {
  return {.resistance = element_of("spring_damper_wall", settings_of(p), &Settings::stiffness, &Settings::damping,
                                   &Settings::wall)};
}
}  // namespace wall

// Of `tracking_wall`, one tissue or a stack.
namespace following {
using Settings = anatomy::TrackingWallSettings;
using Tissue = anatomy::TrackingWallTissue;
using DepthLayer = anatomy::TrackingWallDepthLayer;

// The wall's force has no default scale: a tissue without a number does not resist.
FitParameter force() {
  return fit_parameter(&Tissue::force, {.usual = 1.0});
}
// A setting may be infinite. The solver needs a bound, and no curve of 600 s distinguishes longer times.
FitParameter catch_up() {
  return fit_parameter(&Settings::catch_up, {.most = 1000.0});
}

io::XmlElement tissue_element(const Tissue& tissue) {
  return element_of("tracking_wall", tissue, &Tissue::stiffness, &Tissue::force);
}
io::XmlElement settings_element(const Settings& settings) {
  return element_of("tracking_wall", settings, &Settings::catch_up);
}
}  // namespace following

namespace tracking {
enum : std::size_t { stiffness, force, catch_up, contact };

following::Settings settings_of(std::span<const double> p) {
  following::Settings settings;
  settings.catch_up = p[catch_up];
  settings.limit = no_limit<following::Settings>();
  settings.layers = {{.from = 0.0, .layer = {.stiffness = p[stiffness], .force = p[force]}}};
  return settings;
}

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> forces) {
  const following::Settings settings = settings_of(p);
  forces::TrackingWall model(anatomy::TissueLibrary(), settings, history.dt);
  simulate_axial(
      history, p[contact], forces, [&] { model.begin(Vec3::Zero(), Vec3::UnitZ()); },
      [&](const AxialMotion& motion, forces::TickEvents& events) {
        return model.step(motion, anatomy::tissue::soft, events);
      });
}

void guess(std::span<const CurveShape> shapes, std::span<double> p) {
  const CurveShape& shape = shapes.front();
  p[force] = std::max(shape.peak_force, shape.end_force);
  p[stiffness] = shape.slope;
  p[contact] = shape.contact;
}

FittedElements elements(std::span<const double> p) {
  const following::Settings settings = settings_of(p);
  return {.tissues = {following::tissue_element(settings.layers.front().layer)},
          .resistance = following::settings_element(settings)};
}
}  // namespace tracking

// The values: stiffness, a force for each layer, catch-up time, contact, then where each layer begins.
namespace stack {
constexpr std::size_t shared = 3;

std::size_t layers(std::span<const double> p) {
  return (p.size() - shared) / 2;
}
double catch_up(std::span<const double> p) {
  return p[1 + layers(p)];
}
double contact(std::span<const double> p) {
  return p[2 + layers(p)];
}
double top(std::span<const double> p, std::size_t layer) {
  return p[shared + layers(p) + layer];
}

following::Settings settings_of(std::span<const double> p) {
  following::Settings settings;
  settings.catch_up = catch_up(p);
  settings.limit = no_limit<following::Settings>();
  for (std::size_t i = 0; i < layers(p); ++i)
    settings.layers.push_back({.from = top(p, i), .layer = {.stiffness = p[0], .force = p[1 + i]}});
  return settings;
}

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> forces) {
  const following::Settings settings = settings_of(p);
  forces::TrackingWall model(anatomy::TissueLibrary(), settings, history.dt);
  simulate_axial(
      history, contact(p), forces, [&] { model.begin(Vec3::Zero(), Vec3::UnitZ()); },
      [&](const AxialMotion& motion, forces::TickEvents& events) {
        return model.step(motion, anatomy::tissue::soft, events);
      });
}

void guess(std::span<const CurveShape> shapes, std::span<double> p) {
  const CurveShape& shape = shapes.front();
  p[0] = shape.slope;
  for (std::size_t i = 0; i < layers(p); ++i) p[1 + i] = std::max(shape.peak_force, shape.end_force);
  p[2 + layers(p)] = shape.contact;
}

FittedElements elements(std::span<const double> p) {
  const following::Settings settings = settings_of(p);
  FittedElements result{.resistance = following::settings_element(settings)};
  for (const following::DepthLayer& one : settings.layers) {
    io::XmlElement element = element_of("layer", one, &following::DepthLayer::from);
    const io::XmlElement tissue = following::tissue_element(one.layer);
    element.attributes.insert(element.attributes.end(), tissue.attributes.begin(), tissue.attributes.end());
    result.resistance->children.push_back(std::move(element));
  }
  return result;
}
}  // namespace stack

namespace profile {
enum : std::size_t { skin_stiffness, puncture_depth, stiffness, slope, trailing, contact };

using Settings = anatomy::DepthProfileSettings;
using Tissue = anatomy::DepthProfileTissue;

Settings settings_of(std::span<const double> p) {
  Settings settings;
  settings.skin_stiffness = p[skin_stiffness];
  settings.puncture_depth = p[puncture_depth];
  settings.trailing = std::min(p[trailing], p[puncture_depth]);
  settings.limit = no_limit<Settings>();
  return settings;
}

Tissue tissue_of(std::span<const double> p) {
  return {.kind = anatomy::DepthProfileKind::soft, .stiffness = p[stiffness], .slope = p[slope]};
}

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> force) {
  const Settings settings = settings_of(p);
  anatomy::TissueProperties soft;
  soft.id = anatomy::tissue::soft;
  soft.depth_profile = tissue_of(p);
  forces::DepthProfile model(anatomy::TissueLibrary({soft}), settings, history.dt);
  simulate_axial(
      history, p[contact], force, [&] { model.begin(Vec3::Zero(), Vec3::UnitZ()); },
      [&](const AxialMotion& motion, forces::TickEvents& events) {
        return model.step(motion, anatomy::tissue::soft, events);
      });
}

double yields_in(std::span<const double> p, const AxialMotion& motion, std::size_t /*which*/) {
  return motion.depth - p[contact];
}

void guess(std::span<const CurveShape> shapes, std::span<double> p) {
  const CurveShape& shape = shapes.front();
  const double depth = std::max(0.1, shape.peak_depth - shape.contact);
  p[skin_stiffness] = shape.peak_force / depth;
  p[contact] = shape.contact;
  p[trailing] = std::min(p[trailing], depth);
  const double travel = std::max(0.1, shape.end_depth - shape.peak_depth);
  p[slope] = (shape.end_force - shape.after_force) / p[trailing] / travel;
  p[stiffness] = std::max(0.01, shape.after_force / p[trailing] - p[slope] * depth);
}

FittedElements elements(std::span<const double> p) {
  return {.tissues = {element_of("depth_profile", tissue_of(p), &Tissue::kind, &Tissue::stiffness, &Tissue::slope)},
          .resistance = element_of("depth_profile", settings_of(p), &Settings::skin_stiffness,
                                   &Settings::puncture_depth, &Settings::trailing)};
}
}  // namespace profile

}  // namespace

FitModel spring_damper_wall_fit() {
  return {.name = "spring_damper_wall",
          .parameters = {fit_parameter(&wall::Settings::stiffness), fit_parameter(&wall::Settings::wall),
                         fit_parameter(&wall::Settings::damping)},
          .jumpy = {wall::wall},
          .needs_time = true,
          .simulate = wall::simulate,
          .guess = wall::guess,
          .elements = wall::elements};
}

FitModel tracking_wall_fit() {
  return {.name = "tracking_wall",
          .parameters = {fit_parameter(&following::Tissue::stiffness), following::force(), following::catch_up(),
                         contact_parameter()},
          .contact = tracking::contact,
          .simulate = tracking::simulate,
          .guess = tracking::guess,
          .elements = tracking::elements,
          .stack = tracking_wall_stack_fit};
}

FitModel tracking_wall_stack_fit(std::span<const double> tops) {
  FitModel model = {.name = "tracking_wall",
                    .parameters = {fit_parameter(&following::Tissue::stiffness)},
                    .contact = 2 + tops.size(),
                    .simulate = stack::simulate,
                    .guess = stack::guess,
                    .elements = stack::elements};
  add_for_layers(model, tops.size(), following::force());
  model.parameters.push_back(following::catch_up());
  model.parameters.push_back(contact_parameter());
  add_tops(model, tops);
  return model;
}

FitModel depth_profile_fit() {
  return {.name = "depth_profile",
          .parameters = {fit_parameter(&profile::Settings::skin_stiffness),
                         fit_parameter(&profile::Settings::puncture_depth),
                         fit_parameter(&profile::Tissue::stiffness), fit_parameter(&profile::Tissue::slope),
                         fit_parameter(&profile::Settings::trailing), contact_parameter()},
          .yields = {profile::puncture_depth},
          .contact = profile::contact,
          .simulate = profile::simulate,
          .yields_in = profile::yields_in,
          .guess = profile::guess,
          .elements = profile::elements,
          .stack = depth_profile_stack_fit};
}

}  // namespace bodkin::study
