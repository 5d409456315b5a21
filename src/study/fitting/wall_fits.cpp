#include <algorithm>
#include <cmath>

#include "study/fitting/fit_model.h"
#include "study/fitting/simulate.h"
#include <fmt/format.h>

#include "forces/depth_profile.h"
#include "forces/spring_damper_wall.h"
#include "forces/tracking_wall.h"

namespace bodkin::study {

namespace {

namespace wall {
enum : std::size_t { stiffness, wall, damping };

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> force) {
  forces::SpringDamperWall model(
      {.stiffness = p[stiffness], .damping = p[damping], .wall = p[wall], .limit = no_limit});
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
  return {.resistance = numbers_element(
              "spring_damper_wall",
              {{"stiffness_N_per_mm", p[stiffness]}, {"damping_N_s_per_mm", p[damping]}, {"wall_mm", p[wall]}})};
}
}  // namespace wall

namespace tracking {
enum : std::size_t { stiffness, force, catch_up, contact };

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> forces) {
  anatomy::TrackingWallSettings settings;
  settings.catch_up = p[catch_up];
  settings.limit = no_limit;
  settings.layers = {{.from = 0.0, .layer = {.stiffness = p[stiffness], .force = p[force]}}};
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
  return {
      .tissues = {numbers_element("tracking_wall", {{"stiffness_N_per_mm", p[stiffness]}, {"force_N", p[force]}})},
      .resistance = numbers_element("tracking_wall", {{"catch_up_s", p[catch_up]}})};
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

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> forces) {
  anatomy::TrackingWallSettings settings;
  settings.catch_up = catch_up(p);
  settings.limit = no_limit;
  for (std::size_t i = 0; i < layers(p); ++i)
    settings.layers.push_back({.from = top(p, i), .layer = {.stiffness = p[0], .force = p[1 + i]}});
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
  FittedElements result{.resistance = numbers_element("tracking_wall", {{"catch_up_s", catch_up(p)}})};
  for (std::size_t i = 0; i < layers(p); ++i) {
    result.resistance->children.push_back(
        numbers_element("layer", {{"from_mm", top(p, i)}, {"stiffness_N_per_mm", p[0]}, {"force_N", p[1 + i]}}));
  }
  return result;
}
}  // namespace stack

namespace profile {
enum : std::size_t { skin_stiffness, puncture_depth, stiffness, slope, trailing, contact };

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> force) {
  anatomy::DepthProfileSettings settings;
  settings.skin_stiffness = p[skin_stiffness];
  settings.puncture_depth = p[puncture_depth];
  settings.trailing = std::min(p[trailing], p[puncture_depth]);
  settings.limit = no_limit;
  anatomy::TissueProperties soft;
  soft.id = anatomy::tissue::soft;
  soft.depth_profile = {.kind = anatomy::DepthProfileKind::soft, .stiffness = p[stiffness], .slope = p[slope]};
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
  io::XmlElement tissue =
      numbers_element("depth_profile", {{"stiffness_N_per_mm", p[stiffness]}, {"slope_N_per_mm2", p[slope]}});
  tissue.attributes.insert(tissue.attributes.begin(), {"kind", "soft"});
  return {
      .tissues = {tissue},
      .resistance = numbers_element("depth_profile", {{"skin_stiffness_N_per_mm", p[skin_stiffness]},
                                                      {"puncture_depth_mm", p[puncture_depth]},
                                                      {"trailing_mm", std::min(p[trailing], p[puncture_depth])}})};
}
}  // namespace profile

}  // namespace

FitModel spring_damper_wall_fit() {
  return {.name = "spring_damper_wall",
          .parameters = {{"stiffness", "N/mm", 0.001, 100.0, 0.5},
                         {"wall", "mm", -1000.0, 1000.0, 0.0},
                         {"damping", "N s/mm", 0.0, 1.0, 0.002}},
          .jumpy = {wall::wall},
          .needs_time = true,
          .simulate = wall::simulate,
          .guess = wall::guess,
          .elements = wall::elements};
}

FitModel tracking_wall_fit() {
  return {.name = "tracking_wall",
          .parameters = {{"stiffness", "N/mm", 0.01, 100.0, 0.5},
                         {"force", "N", 0.0, 50.0, 1.0},
                         {"catch_up", "s", 0.001, 1000.0, 0.5},
                         {"contact", "mm", -1000.0, 1000.0, 0.0, false}},
          .contact = tracking::contact,
          .simulate = tracking::simulate,
          .guess = tracking::guess,
          .elements = tracking::elements};
}

FitModel tracking_wall_stack_fit(std::span<const double> tops) {
  FitModel model = {.name = "tracking_wall",
                    .parameters = {{"stiffness", "N/mm", 0.01, 100.0, 0.5}},
                    .contact = 2 + tops.size(),
                    .simulate = stack::simulate,
                    .guess = stack::guess,
                    .elements = stack::elements};
  for (std::size_t i = 0; i < tops.size(); ++i)
    model.parameters.push_back({fmt::format("force_{}", i + 1), "N", 0.0, 50.0, 1.0});
  model.parameters.push_back({"catch_up", "s", 0.001, 1000.0, 0.5});
  model.parameters.push_back({"contact", "mm", -1000.0, 1000.0, 0.0, false});
  for (std::size_t i = 0; i < tops.size(); ++i)
    model.parameters.push_back({fmt::format("from_{}", i + 1), "mm", 0.0, 500.0, tops[i], false});
  return model;
}

FitModel depth_profile_fit() {
  return {.name = "depth_profile",
          .parameters = {{"skin_stiffness", "N/mm", 0.01, 10.0, 0.3},
                         {"puncture_depth", "mm", 0.1, 50.0, 5.0},
                         {"stiffness", "N/mm", 0.0, 10.0, 0.4},
                         {"slope", "N/mm^2", -1.0, 1.0, 0.01},
                         {"trailing", "mm", 0.01, 50.0, 2.0},
                         {"contact", "mm", -1000.0, 1000.0, 0.0, false}},
          .yields = {profile::puncture_depth},
          .contact = profile::contact,
          .simulate = profile::simulate,
          .yields_in = profile::yields_in,
          .guess = profile::guess,
          .elements = profile::elements};
}

}  // namespace bodkin::study
