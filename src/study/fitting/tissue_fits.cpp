#include <algorithm>
#include <cmath>

#include "study/fitting/fit_model.h"
#include "study/fitting/simulate.h"

#include "forces/fracture.h"
#include "forces/shaft_friction.h"
#include "forces/three_component.h"

namespace bodkin::study {

namespace {

namespace three {
enum : std::size_t {
  linear,
  quadratic,
  puncture_force,
  cutting_force,
  coulomb_in,
  coulomb_out,
  viscous_in,
  viscous_out,
  cutting_stiffness,
  hold,
  contact
};

using Settings = anatomy::ThreeComponentSettings;
using Friction = anatomy::KarnoppFriction;

Settings settings_of(std::span<const double> p) {
  Settings settings;
  settings.linear = p[linear];
  settings.quadratic = std::max(p[quadratic], p[linear] > 0.0 ? 0.0 : 1e-9);
  settings.puncture_force = p[puncture_force];
  settings.cutting_force = std::min(p[cutting_force], p[puncture_force]);
  settings.cutting_stiffness = p[cutting_stiffness];
  // Static friction is at least the sliding friction.
  settings.inwards = {p[coulomb_in], p[viscous_in], std::max(p[coulomb_in], settings.inwards.static_force)};
  settings.outwards = {p[coulomb_out], p[viscous_out], std::max(p[coulomb_out], settings.outwards.static_force)};
  settings.hold = p[hold];
  return settings;
}

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> force) {
  Settings settings = settings_of(p);
  settings.limit = no_limit<Settings>();
  forces::ThreeComponent model(settings);
  simulate_axial(
      history, p[contact], force, [&] { model.begin(Vec3::Zero(), Vec3::UnitZ()); },
      [&](const AxialMotion& motion, forces::TickEvents& events) {
        return model.step(motion, anatomy::tissue::soft, events);
      });
}

double yields_in(std::span<const double> p, const AxialMotion& motion, std::size_t /*which*/) {
  const double x = motion.depth - p[contact];
  return x > 0.0 ? p[linear] * x + p[quadratic] * x * x : 0.0;
}

void guess(std::span<const CurveShape> shapes, std::span<double> p) {
  const CurveShape& shape = shapes.front();
  const double depth = std::max(0.1, shape.peak_depth - shape.contact);
  p[linear] = 0.3 * shape.peak_force / depth;
  p[quadratic] = 0.7 * shape.peak_force / (depth * depth);
  const double travel = std::max(0.1, shape.end_depth - shape.peak_depth);
  p[coulomb_in] = std::max(1e-4, (shape.end_force - shape.after_force) / travel);
  p[coulomb_out] = p[coulomb_in];
  p[cutting_force] = std::max(0.01, shape.after_force - p[coulomb_in] * depth);
  p[contact] = shape.contact;
}

FittedElements elements(std::span<const double> p) {
  const Settings s = settings_of(p);
  io::XmlElement element =
      element_of("three_component", s, &Settings::linear, &Settings::quadratic, &Settings::puncture_force,
                 &Settings::cutting_force, &Settings::cutting_stiffness, &Settings::hold);
  const auto friction = [](const char* name, const Friction& one) {
    return element_of(name, one, &Friction::coulomb, &Friction::viscous, &Friction::static_force);
  };
  element.children = {friction("inwards", s.inwards), friction("outwards", s.outwards)};
  return {.resistance = element};
}
}  // namespace three

namespace fracture {
enum : std::size_t { stiffness, toughness, cutting_toughness, cutting_stiffness, spacing, width, thickness, contact };

using Settings = anatomy::FractureSettings;

Settings settings_of(std::span<const double> p) {
  Settings settings;
  settings.stiffness = p[stiffness];
  settings.spacing = p[spacing];
  settings.toughness = p[toughness];
  settings.width = p[width];
  settings.thickness = p[thickness];
  settings.cutting_stiffness = p[cutting_stiffness];
  settings.cutting_toughness = p[cutting_toughness];
  return settings;
}

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> force) {
  Settings settings = settings_of(p);
  settings.limit = no_limit<Settings>();
  forces::Fracture model(settings);
  simulate_axial(
      history, p[contact], force, [&] { model.begin(Vec3::Zero(), Vec3::UnitZ()); },
      [&](const AxialMotion& motion, forces::TickEvents& events) {
        return model.step(motion, anatomy::tissue::soft, events);
      });
}

double yields_in(std::span<const double> p, const AxialMotion& motion, std::size_t /*which*/) {
  const double x = motion.depth - p[contact];
  return x > 0.0 ? forces::stored_energy(p[stiffness], p[spacing], x) / (p[width] * p[thickness]) : 0.0;
}

void guess(std::span<const CurveShape> shapes, std::span<double> p) {
  const CurveShape& shape = shapes.front();
  p[stiffness] = shape.peak_force / cubic_per_stiffness(p[spacing], shape.peak_depth - shape.contact);
  p[cutting_toughness] = std::max(0.001, 0.5 * (shape.after_force + shape.end_force) / p[width]);
  p[contact] = shape.contact;
}

FittedElements elements(std::span<const double> p) {
  return {.resistance = element_of("fracture", settings_of(p), &Settings::stiffness, &Settings::spacing,
                                   &Settings::toughness, &Settings::width, &Settings::thickness,
                                   &Settings::cutting_stiffness, &Settings::cutting_toughness)};
}
}  // namespace fracture

namespace friction {
enum : std::size_t { coulomb, stiffness, viscous, static_friction, stribeck, contact };
using Settings = anatomy::ShaftFrictionSettings;
using Tissue = anatomy::ShaftFrictionTissue;

Tissue tissue_of(std::span<const double> p) {
  return {.coulomb = p[coulomb],
          .static_force = std::max(p[static_friction], p[coulomb]),
          .stiffness = p[stiffness],
          .viscous = p[viscous]};
}

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> force) {
  forces::ShaftFriction model({.stribeck_velocity = p[stribeck]});
  const Tissue tissue = tissue_of(p);
  simulate_axial(
      history, p[contact], force, [&] { model.begin(); },
      [&](const AxialMotion& motion, forces::TickEvents& events) {
        const double length = std::max(0.0, motion.depth);
        return model.step(motion,
                          {tissue.coulomb * length, tissue.static_force * length, tissue.stiffness * length,
                           tissue.viscous * length},
                          events);
      });
}

void guess(std::span<const CurveShape> shapes, std::span<double> p) {
  const CurveShape& shape = shapes.front();
  p[coulomb] = std::max(1e-4, shape.end_force / std::max(0.5, shape.end_depth - shape.contact));
  p[static_friction] = 1.2 * p[coulomb];
  p[stiffness] = 3.0 * p[coulomb];
  p[viscous] = 0.005 * p[coulomb];
  p[contact] = shape.contact;
}

FittedElements elements(std::span<const double> p) {
  return {.tissues = {element_of("shaft_friction", tissue_of(p), &Tissue::coulomb, &Tissue::static_force,
                                 &Tissue::stiffness, &Tissue::viscous)},
          .resistance =
              element_of("shaft_friction", Settings{.stribeck_velocity = p[stribeck]}, &Settings::stribeck_velocity)};
}
}  // namespace friction

}  // namespace

FitModel three_component_fit() {
  using three::Friction;
  using three::Settings;
  const Settings usual;
  return {
      .name = "three_component",
      .parameters = {fit_parameter(&Settings::linear), fit_parameter(&Settings::quadratic),
                     fit_parameter(&Settings::puncture_force), fit_parameter(&Settings::cutting_force),
                     fit_parameter(&Friction::coulomb, {.name = "coulomb_inwards", .usual = usual.inwards.coulomb}),
                     fit_parameter(&Friction::coulomb, {.name = "coulomb_outwards", .usual = usual.outwards.coulomb}),
                     fit_parameter(&Friction::viscous, {.name = "viscous_inwards", .usual = usual.inwards.viscous}),
                     fit_parameter(&Friction::viscous, {.name = "viscous_outwards", .usual = usual.outwards.viscous}),
                     fit_parameter(&Settings::cutting_stiffness, {.fitted = false}),
                     fit_parameter(&Settings::hold, {.fitted = false}), contact_parameter()},
      .yields = {three::puncture_force},
      .contact = three::contact,
      .needs_time = true,
      .simulate = three::simulate,
      .yields_in = three::yields_in,
      .guess = three::guess,
      .elements = three::elements};
}

FitModel fracture_fit() {
  using fracture::Settings;
  return {.name = "fracture",
          .parameters = {fit_parameter(&Settings::stiffness), fit_parameter(&Settings::toughness),
                         fit_parameter(&Settings::cutting_toughness), fit_parameter(&Settings::cutting_stiffness),
                         fit_parameter(&Settings::spacing, {.fitted = false}),
                         fit_parameter(&Settings::width, {.fitted = false}),
                         fit_parameter(&Settings::thickness, {.fitted = false}), contact_parameter()},
          .yields = {fracture::toughness},
          .contact = fracture::contact,
          .simulate = fracture::simulate,
          .yields_in = fracture::yields_in,
          .guess = fracture::guess,
          .elements = fracture::elements};
}

FitModel shaft_friction_fit() {
  using friction::Tissue;
  return {
      .name = "shaft_friction",
      .parameters = {fit_parameter(&Tissue::coulomb, {.usual = usual_friction.coulomb}),
                     fit_parameter(&Tissue::stiffness),
                     fit_parameter(&Tissue::viscous, {.usual = usual_friction.viscous}),
                     fit_parameter(&Tissue::static_force, {.usual = usual_friction.static_force}),
                     fit_parameter(&friction::Settings::stribeck_velocity, {.fitted = false}), contact_parameter()},
      .contact = friction::contact,
      .needs_time = true,
      .simulate = friction::simulate,
      .guess = friction::guess,
      .elements = friction::elements,
      .stack = shaft_friction_stack_fit};
}

}  // namespace bodkin::study
