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

anatomy::ThreeComponentSettings settings_of(std::span<const double> p) {
  anatomy::ThreeComponentSettings settings;
  settings.linear = p[linear];
  settings.quadratic = std::max(p[quadratic], p[linear] > 0.0 ? 0.0 : 1e-9);
  settings.puncture_force = p[puncture_force];
  settings.cutting_force = std::min(p[cutting_force], p[puncture_force]);
  settings.cutting_stiffness = p[cutting_stiffness];
  // At rest friction holds with at least what it slides with.
  settings.inwards = {p[coulomb_in], p[viscous_in], std::max(p[coulomb_in], settings.inwards.static_force)};
  settings.outwards = {p[coulomb_out], p[viscous_out], std::max(p[coulomb_out], settings.outwards.static_force)};
  settings.hold = p[hold];
  return settings;
}

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> force) {
  anatomy::ThreeComponentSettings settings = settings_of(p);
  settings.limit = no_limit;
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
  const anatomy::ThreeComponentSettings s = settings_of(p);
  io::XmlElement element = numbers_element("three_component", {{"linear_N_per_mm", s.linear},
                                                               {"quadratic_N_per_mm2", s.quadratic},
                                                               {"puncture_force_N", s.puncture_force},
                                                               {"cutting_force_N", s.cutting_force},
                                                               {"cutting_stiffness_N_per_mm", s.cutting_stiffness},
                                                               {"hold_N_per_mm2", s.hold}});
  const auto friction = [](const char* name, const anatomy::KarnoppFriction& one) {
    return numbers_element(name, {{"coulomb_N_per_mm", one.coulomb},
                                  {"viscous_N_s_per_mm2", one.viscous},
                                  {"static_N_per_mm", one.static_force}});
  };
  element.children = {friction("inwards", s.inwards), friction("outwards", s.outwards)};
  return {.resistance = element};
}
}  // namespace three

namespace fracture {
enum : std::size_t { stiffness, toughness, cutting_toughness, cutting_stiffness, spacing, width, thickness, contact };

anatomy::FractureSettings settings_of(std::span<const double> p) {
  anatomy::FractureSettings settings;
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
  anatomy::FractureSettings settings = settings_of(p);
  settings.limit = no_limit;
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
  const anatomy::FractureSettings s = settings_of(p);
  return {.resistance = numbers_element("fracture", {{"stiffness_N_per_mm", s.stiffness},
                                                     {"spacing_mm", s.spacing},
                                                     {"toughness_N_per_mm", s.toughness},
                                                     {"width_mm", s.width},
                                                     {"thickness_mm", s.thickness},
                                                     {"cutting_stiffness_N_per_mm", s.cutting_stiffness},
                                                     {"cutting_toughness_N_per_mm", s.cutting_toughness}})};
}
}  // namespace fracture

namespace friction {
enum : std::size_t { coulomb, stiffness, viscous, static_friction, stribeck, contact };

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> force) {
  forces::ShaftFriction model({.stribeck_velocity = p[stribeck]});
  const double most = std::max(p[static_friction], p[coulomb]);
  simulate_axial(
      history, p[contact], force, [&] { model.begin(); },
      [&](const AxialMotion& motion, forces::TickEvents& events) {
        const double length = std::max(0.0, motion.depth);
        return model.step(motion, {p[coulomb] * length, most * length, p[stiffness] * length, p[viscous] * length},
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
  return {
      .tissues = {numbers_element("shaft_friction", {{"coulomb_N_per_mm", p[coulomb]},
                                                     {"static_N_per_mm", std::max(p[static_friction], p[coulomb])},
                                                     {"stiffness_N_per_mm2", p[stiffness]},
                                                     {"viscous_N_s_per_mm2", p[viscous]}})},
      .resistance = numbers_element("shaft_friction", {{"stribeck_velocity_mm_per_s", p[stribeck]}})};
}
}  // namespace friction

}  // namespace

FitModel three_component_fit() {
  return {.name = "three_component",
          .parameters = {{"linear", "N/mm", 0.0, 10.0, 0.02},
                         {"quadratic", "N/mm^2", 0.0, 10.0, 0.03},
                         {"puncture_force", "N", 0.01, 50.0, 0.85},
                         {"cutting_force", "N", 0.0, 50.0, 0.3},
                         {"coulomb_inwards", "N/mm", 0.0, 10.0, 0.01196},
                         {"coulomb_outwards", "N/mm", 0.0, 10.0, 0.01057},
                         {"viscous_inwards", "N s/mm^2", 0.0, 1.0, 0.00021213},
                         {"viscous_outwards", "N s/mm^2", 0.0, 1.0, 0.00029308},
                         {"cutting_stiffness", "N/mm", 0.01, 100.0, 1.0, false},
                         {"hold", "N/mm^2", 0.001, 100.0, 0.1, false},
                         {"contact", "mm", -1000.0, 1000.0, 0.0, false}},
          .yields = {three::puncture_force},
          .contact = three::contact,
          .needs_time = true,
          .simulate = three::simulate,
          .yields_in = three::yields_in,
          .guess = three::guess,
          .elements = three::elements};
}

FitModel fracture_fit() {
  return {.name = "fracture",
          .parameters = {{"stiffness", "N/mm", 0.001, 10.0, 0.05},
                         {"toughness", "N/mm", 1e-4, 100.0, 1.0},
                         {"cutting_toughness", "N/mm", 0.0, 100.0, 0.1},
                         {"cutting_stiffness", "N/mm", 0.01, 100.0, 1.0},
                         {"spacing", "mm", 0.1, 10.0, 1.0, false},
                         {"width", "mm", 0.05, 5.0, 0.8, false},
                         {"thickness", "mm", 0.01, 20.0, 1.0, false},
                         {"contact", "mm", -1000.0, 1000.0, 0.0, false}},
          .yields = {fracture::toughness},
          .contact = fracture::contact,
          .simulate = fracture::simulate,
          .yields_in = fracture::yields_in,
          .guess = fracture::guess,
          .elements = fracture::elements};
}

FitModel shaft_friction_fit() {
  return {.name = "shaft_friction",
          .parameters = {{"coulomb", "N/mm", 0.0, 10.0, 0.012},
                         {"stiffness", "N/mm^2", 1e-6, 100.0, 0.05},
                         {"viscous", "N s/mm^2", 0.0, 1.0, 0.0002},
                         {"static", "N/mm", 0.0, 10.0, 0.015},
                         {"stribeck_velocity", "mm/s", 0.01, 1000.0, 5.0, false},
                         {"contact", "mm", -1000.0, 1000.0, 0.0, false}},
          .contact = friction::contact,
          .needs_time = true,
          .simulate = friction::simulate,
          .guess = friction::guess,
          .elements = friction::elements};
}

}  // namespace bodkin::study
