#pragma once

#include <concepts>
#include <limits>
#include <optional>
#include <string_view>

#include "anatomy/case.h"
#include "core/axial_motion.h"
#include "core/geometry.h"
#include "forces/diagnostics.h"
#include "forces/events.h"
#include "forces/rail.h"

namespace bodkin::forces {

// Where the needle is, as far as a resistance needs to know.
struct NeedleInTissue {
  AxialMotion motion;                               // along the frozen line
  Vec3 tip = Vec3::Zero();                          // LPS mm
  anatomy::TissueId tissue = anatomy::tissue::air;  // at the tip
  Vec3 axis = Vec3::UnitZ();                        // unit, hub to tip
  Vec3 side = Vec3::UnitX();                        // unit, across the needle, turns with its shaft
  const Rail* rail = nullptr;                       // holds the proxy on the line, if that is the case's constraint
  double grip = 1.0;  // factor on the friction of the shaft, by turning the needle (needle_grasp.h)
  std::optional<double> thumb_force = {};  // N on the plunger of a syringe; nothing: as the case has it
  bool stylet_moved = false;               // the stylet is not as the case has it
  bool manometer_moved = false;            // the same of the manometer
};

// The force that a resistance found in one tick.
struct ResistanceForce {
  double along = 0.0;          // N, along the frozen line, positive pushes the hand out
  Vec3 across = Vec3::Zero();  // N on the hand, of models whose force may leave the line
  Vec3 torque = Vec3::Zero();  // N mm on the hand, about the tip, of models that feel the whole shaft
  double stiffness = 0.0;      // N/mm, elastic tangent where the model knows it; 0 otherwise
  // mm: how deep the tissue that touches the tip lies when nothing pushes it. Tissue that has not given way yet moves
  // with the tip, so this is less than the tip's depth. Infinite: the tip is as deep in the tissue as in space.
  double material = std::numeric_limits<double>::infinity();
  // The tissue in which the tip is, and the one that it pushes before it, of a model that knows the layers of its
  // line better than the voxels on the hand's; air: unknown.
  anatomy::TissueId inside = anatomy::tissue::air, pushed = anatomy::tissue::air;
  bool in_contact = false;  // false: the needle has left the body, the line can be released
};

// What a resistance is, apart from its settings.
struct ResistanceTraits {
  std::string_view name;            // as cases, commands and sessions write it: "tracking_wall"
  bool holds_laterally = false;     // its force has a part across the line, so a rail adds only its torque
  bool has_shaft_friction = false;  // the part `shaft_friction` would count it twice
  bool feels_grip = false;          // multiplies its friction with NeedleInTissue::grip
  bool passes_layers = false;       // goes by the tissue, but does not itself say when one gives way
  bool can_relax = false;           // a spring that the part `relaxation` may let fade
  bool relaxes_itself = false;      // it takes the part `relaxation` into its own equations
  ModelDiagnosticNames diagnostics = {};
};

// What a model need not say: it neither shares the device's stiffness nor reduces a tissue's, and publishes nothing.
struct ResistanceDefaults {
  // N/mm along the line that the part `shaft_friction` leaves to the model.
  double firm_stiffness() const noexcept { return 0.0; }
  // The smallest factor by which a tissue's stiffness had to be reduced for the device; 1 = none.
  double stiffness_scale() const noexcept { return 1.0; }
  // Of the last tick.
  ModelDiagnostics diagnostics() const noexcept { return {}; }
};

// A model of the resistance that a needle meets, one file pair. It is made from (const Case&, const Settings&,
// double dt), which throws InputError for settings or tissues that make it impossible, active, or too stiff for the
// device; the case outlives it. begin() is a new line (unit direction) on which nothing is touched yet, step() one
// tick on it, reset() forgets everything. All three are deterministic and neither allocate nor throw.
// docs/adding-a-force-model.md shows a whole one.
template <typename Model>
concept ResistanceModel = std::same_as<decltype(Model::traits), const ResistanceTraits> &&
    std::constructible_from<Model, const anatomy::Case&, const typename Model::Settings&, double> &&
    requires(Model model, const Model& seen, const NeedleInTissue& needle, TickEvents& events, const Vec3& vector) {
  { model.begin(vector, vector) }
  noexcept;
  { model.step(needle, events) }
  noexcept->std::same_as<ResistanceForce>;
  { model.reset() }
  noexcept;
  { seen.firm_stiffness() }
  noexcept->std::same_as<double>;
  { seen.stiffness_scale() }
  noexcept->std::same_as<double>;
  { seen.diagnostics() }
  noexcept->std::same_as<ModelDiagnostics>;
};

}  // namespace bodkin::forces
