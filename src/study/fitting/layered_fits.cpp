#include <algorithm>
#include <cmath>
#include <vector>

#include "study/fitting/fit_model.h"
#include "study/fitting/simulate.h"
#include <fmt/format.h>

#include "core/error.h"
#include "forces/layered.h"
#include "forces/voigt_law.h"

namespace bodkin::study {

namespace {

constexpr double rigid_device = 1e12;  // N/mm: nothing is softened for the sake of a device
constexpr double beyond = 2.0;         // mm of known tissue beyond the deepest point

// The force of `layered` along the tissues of `tissue_at` by depth, known in steps of `layer` mm.
template <typename TissueAt>
void simulate_line(const std::vector<anatomy::TissueProperties>& tissues, double layer, double contact,
                   const NeedleHistory& history, std::span<double> force, TissueAt tissue_at) {
  double deepest = 0.0;
  for (const AxialMotion& motion : history.ticks) deepest = std::max(deepest, motion.depth - contact);
  const double longest = deepest + beyond;
  std::vector<anatomy::TissueId> layers(static_cast<std::size_t>(longest / layer) + 1);
  for (std::size_t i = 0; i < layers.size(); ++i) layers[i] = tissue_at((static_cast<double>(i) + 0.5) * layer);
  forces::Layered model(anatomy::TissueLibrary(tissues), {.layer = layer}, rigid_device, history.dt, longest);
  forces::TickEvents events;
  bool inside = false;  // this model also holds a needle that is just leaving
  for (std::size_t n = 0; n < history.ticks.size(); ++n) {
    AxialMotion motion = history.ticks[n];
    motion.depth -= contact;
    if (!inside && motion.depth > 0.0) {
      model.begin();
      inside = true;
    }
    force[n] = 0.0;
    if (!inside) continue;
    events.clear();
    const forces::LayeredForce found = model.step(motion, layers, events);
    force[n] = found.resistance;
    inside = found.in_contact;
  }
}

using Tissue = anatomy::LayeredTissue;

io::XmlElement layered_element(const Tissue& one) {
  io::XmlElement element;
  element.name = "layered";
  element.children.push_back(element_of(std::string(alternative_of(one)), one, &Tissue::stiffness, &Tissue::viscosity,
                                        &Tissue::element_spacing, &Tissue::break_force, &Tissue::shaft_stiffness,
                                        &Tissue::shaft_spacing, &Tissue::static_friction, &Tissue::dynamic_friction));
  return element;
}

// A tissue's numbers are above 0, but a fit's range includes its end; and a missing number has no default to take a
// scale from.
FitParameter stiffness_parameter() {
  return fit_parameter(&Tissue::stiffness, {.usual = 0.05, .least = 1e-6});
}
FitParameter break_force_parameter() {
  return fit_parameter(&Tissue::break_force, {.usual = 1.0, .least = 0.001});
}
FitParameter shaft_stiffness_parameter() {
  return fit_parameter(&Tissue::shaft_stiffness, {.usual = 0.02, .least = 1e-6});
}
// Static over dynamic friction, which no table declares.
FitParameter static_ratio_parameter() {
  return {.name = "static_ratio", .low = 1.0, .high = 2.0, .usual = 1.2, .fitted = false};
}
// Half of a tissue's limit, because its static friction is up to twice as large.
FitParameter dynamic_friction_parameter() {
  const double most = fit_parameter(&Tissue::static_friction).high / static_ratio_parameter().high;
  return fit_parameter(&Tissue::dynamic_friction, {.usual = 0.02, .most = most});
}
FitParameter viscosity_parameter() {
  return fit_parameter(&Tissue::viscosity, {.usual = 0.001});
}

namespace layered {
enum : std::size_t {
  stiffness,
  break_force,
  dynamic_friction,
  shaft_stiffness,
  viscosity,
  spacing,
  shaft_spacing,
  static_ratio,
  contact
};
constexpr double layer = anatomy::LayeredSettings{}.layer;  // mm

anatomy::LayeredTissue tissue_of(std::span<const double> p) {
  anatomy::LayeredTissue one;
  one.kind = anatomy::LayeredKind::viscoelastic;
  one.stiffness = p[stiffness];
  one.viscosity = p[viscosity];
  one.element_spacing = p[spacing];
  one.break_force = p[break_force];
  one.shaft_stiffness = p[shaft_stiffness];
  one.shaft_spacing = p[shaft_spacing];
  one.dynamic_friction = p[dynamic_friction];
  one.static_friction = p[dynamic_friction] * p[static_ratio];
  return one;
}

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> force) {
  anatomy::TissueProperties soft;
  soft.id = anatomy::tissue::soft;
  soft.layered = tissue_of(p);
  simulate_line({soft}, layer, p[contact], history, force, [](double /*depth*/) { return anatomy::tissue::soft; });
}

double yields_in(std::span<const double> p, const AxialMotion& motion, std::size_t /*which*/) {
  if (motion.direction <= 0) return 0.0;
  const forces::VoigtLaw push(forces::VoigtSum::cubic, p[stiffness], p[viscosity], p[spacing]);
  return push.push(motion.depth - p[contact], motion.velocity);
}

void guess(std::span<const CurveShape> shapes, std::span<double> p) {
  const CurveShape& shape = shapes.front();
  const double depth = shape.peak_depth - shape.contact;
  p[stiffness] = shape.peak_force / cubic_per_stiffness(p[spacing], depth);
  const double shaft = std::max(0.5, shape.end_depth - shape.contact);
  p[dynamic_friction] = std::max(1e-4, shape.end_force / shaft);
  p[shaft_stiffness] = p[dynamic_friction] / cubic_per_stiffness(p[shaft_spacing], 0.8);
  p[viscosity] = 0.02 * p[stiffness];
  p[contact] = shape.contact;
}

FittedElements elements(std::span<const double> p) {
  return {.tissues = {layered_element(tissue_of(p))}};
}
}  // namespace layered

// The values: stiffness, break force and friction of each layer; viscosity in proportion to the stiffness and
// stiffness of the shaft in proportion to the friction, of all layers together; the spacings, static ratio and
// contact; then where each layer begins.
namespace layered_stack {
enum : std::size_t { shaft_ratio, viscosity_ratio, spacing, shaft_spacing, static_ratio, contact };
constexpr std::size_t shared = 6;

// mm, the finest between samples that a case may have
double layer() {
  return fit_parameter(&anatomy::LayeredSettings::layer).low;
}

std::size_t layers(std::span<const double> p) {
  return (p.size() - shared) / 4;
}
double of_all(std::span<const double> p, std::size_t which) {
  return p[3 * layers(p) + which];
}
double top(std::span<const double> p, std::size_t which) {
  return p[3 * layers(p) + shared + which];
}

anatomy::LayeredTissue tissue_of(std::span<const double> p, std::size_t which) {
  const std::size_t n = layers(p);
  anatomy::LayeredTissue one;
  one.kind = anatomy::LayeredKind::viscoelastic;
  one.stiffness = p[which];
  one.viscosity = of_all(p, viscosity_ratio) * p[which];
  one.element_spacing = of_all(p, spacing);
  one.break_force = p[n + which];
  one.dynamic_friction = p[2 * n + which];
  one.static_friction = of_all(p, static_ratio) * one.dynamic_friction;
  const FitParameter grip = shaft_stiffness_parameter();
  one.shaft_stiffness = std::clamp(of_all(p, shaft_ratio) * one.dynamic_friction, grip.low, grip.high);
  one.shaft_spacing = of_all(p, shaft_spacing);
  return one;
}

void simulate(std::span<const double> p, const NeedleHistory& history, std::span<double> force) {
  std::vector<anatomy::TissueProperties> tissues(layers(p));
  for (std::size_t i = 0; i < tissues.size(); ++i) {
    tissues[i].id = static_cast<anatomy::TissueId>(first_layer + i);
    tissues[i].name = fmt::format("layer_{}", i + 1);
    tissues[i].layered = tissue_of(p, i);
  }
  const std::span<const double> tops = p.subspan(3 * layers(p) + shared);
  simulate_line(tissues, layer(), of_all(p, contact), history, force, [&](double depth) {
    const auto below = std::upper_bound(tops.begin() + 1, tops.end(), depth);
    return static_cast<anatomy::TissueId>(first_layer + (below - tops.begin() - 1));
  });
}

double yields_in(std::span<const double> p, const AxialMotion& motion, std::size_t which) {
  if (motion.direction <= 0) return 0.0;
  const anatomy::LayeredTissue one = tissue_of(p, which);
  const forces::VoigtLaw push(forces::VoigtSum::cubic, one.stiffness, one.viscosity, one.element_spacing);
  return push.push(motion.depth - of_all(p, contact) - top(p, which), motion.velocity);
}

void guess(std::span<const CurveShape> shapes, std::span<double> p) {
  const std::size_t n = layers(p);
  const CurveShape& whole = shapes.front();
  const double shaft = std::max(0.5, whole.end_depth - whole.contact);
  for (std::size_t i = 0; i < n; ++i) {
    const CurveShape& own = shapes[i];
    const double depth = own.peak_depth - own.contact - top(p, i);
    p[i] = std::max(own.peak_force - own.after_force, 0.1 * own.peak_force) /
           cubic_per_stiffness(of_all(p, spacing), std::max(depth, 1.0));
    p[2 * n + i] = std::max(1e-4, 0.5 * whole.end_force / shaft);
  }
  p[3 * n + contact] = whole.contact;
}

FittedElements elements(std::span<const double> p) {
  FittedElements result;
  for (std::size_t i = 0; i < layers(p); ++i) result.tissues.push_back(layered_element(tissue_of(p, i)));
  return result;
}
}  // namespace layered_stack

}  // namespace

FitModel layered_fit() {
  return {.name = "layered",
          .parameters = {stiffness_parameter(), break_force_parameter(), dynamic_friction_parameter(),
                         shaft_stiffness_parameter(), viscosity_parameter(),
                         fit_parameter(&Tissue::element_spacing, {.fitted = false}),
                         fit_parameter(&Tissue::shaft_spacing, {.fitted = false}), static_ratio_parameter(),
                         contact_parameter()},
          .yields = {layered::break_force},
          .contact = layered::contact,
          .jumpy = {layered::shaft_stiffness, layered::dynamic_friction},
          .needs_time = true,
          .simulate = layered::simulate,
          .yields_in = layered::yields_in,
          .guess = layered::guess,
          .elements = layered::elements,
          .stack = layered_stack_fit};
}

FitModel layered_stack_fit(std::span<const double> tops) {
  for (const double top : tops) {
    const double steps = top / layered_stack::layer();
    if (std::abs(steps - std::round(steps)) > 1e-6) {
      throw InputError(fmt::format(
          "--layers has {:g} mm, expected multiples of {:g} mm for layered, which knows tissues no finer; "
          "give {:g}",
          top, layered_stack::layer(), std::round(steps) * layered_stack::layer()));
    }
  }
  const std::size_t n = tops.size();
  FitModel model = {.name = "layered",
                    .contact = 3 * n + layered_stack::contact,
                    .jumpy = {3 * n + layered_stack::shaft_ratio},
                    .needs_time = true,
                    .simulate = layered_stack::simulate,
                    .yields_in = layered_stack::yields_in,
                    .guess = layered_stack::guess,
                    .elements = layered_stack::elements};
  for (std::size_t i = 0; i < n; ++i) model.yields.push_back(n + i);
  add_for_layers(model, n, stiffness_parameter());
  add_for_layers(model, n, break_force_parameter());
  add_for_layers(model, n, dynamic_friction_parameter());
  model.parameters.push_back({"shaft_ratio", "1/mm", 0.01, 1000.0, 1.5});
  // The limit of the stiffest tissue.
  model.parameters.push_back(
      {"viscosity_ratio", "s", 0.0, viscosity_parameter().high / stiffness_parameter().high, 0.02});
  model.parameters.push_back(fit_parameter(&Tissue::element_spacing, {.fitted = false}));
  model.parameters.push_back(fit_parameter(&Tissue::shaft_spacing, {.fitted = false}));
  model.parameters.push_back(static_ratio_parameter());
  model.parameters.push_back(contact_parameter());
  add_tops(model, tops);
  return model;
}

}  // namespace bodkin::study
