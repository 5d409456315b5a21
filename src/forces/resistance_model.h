#pragma once

#include <concepts>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "anatomy/case.h"
#include "core/axial_motion.h"
#include "core/geometry.h"
#include "forces/diagnostics.h"
#include "forces/events.h"
#include "forces/rail.h"

namespace bodkin::forces {

// The needle's state, as a resistance needs it.
struct NeedleInTissue {
  AxialMotion motion;                               // along the frozen line
  Vec3 tip = Vec3::Zero();                          // LPS mm
  anatomy::TissueId tissue = anatomy::tissue::air;  // at the tip
  Vec3 axis = Vec3::UnitZ();                        // unit, hub to tip
  Vec3 side = Vec3::UnitX();                        // unit, across the needle, fixed to the shaft
  const Rail* rail = nullptr;                       // holds the proxy on the line, if that is the case's constraint
  double grip = 1.0;  // factor on the friction of the shaft, by turning the needle (needle_grasp.h)
  std::optional<double> thumb_force = {};  // N on the plunger of a syringe; empty: as in the case
  bool stylet_moved = false;               // the stylet is not where the case has it
  bool manometer_moved = false;            // the manometer is not where the case has it
};

// The force that a resistance found in one tick.
struct ResistanceForce {
  double along = 0.0;          // N, along the frozen line, positive pushes the hand out
  Vec3 across = Vec3::Zero();  // N on the hand, of models whose force may leave the line
  Vec3 torque = Vec3::Zero();  // N mm on the hand, about the tip, of models that feel the whole shaft
  double stiffness = 0.0;      // N/mm, elastic tangent where the model knows it; 0 otherwise
  // mm: depth, at rest, of the tissue that touches the tip. Tissue that is not punctured yet moves with the tip, so
  // this is less than the tip's depth. Infinite: the tip is as deep in the tissue as in space.
  double material = std::numeric_limits<double>::infinity();
  // The tissue in which the tip is, and the one that it pushes, from a model that knows the layers of its line better
  // than the voxels along the hand's line; air: unknown.
  anatomy::TissueId inside = anatomy::tissue::air, pushed = anatomy::tissue::air;
  bool in_contact = false;  // false: the needle has left the body, the line may be released
};

// Properties of a resistance that do not depend on its settings.
struct ResistanceTraits {
  std::string_view name;            // as cases, commands and sessions write it: "tracking_wall"
  bool has_lateral_force = false;   // its force has a part across the line, so a rail adds only its torque
  bool has_shaft_friction = false;  // the part `shaft_friction` would count it twice
  bool uses_grip = false;           // multiplies its friction by NeedleInTissue::grip
  bool passes_layers = false;       // depends on the tissue, but does not itself detect punctures
  bool can_relax = false;           // is a spring that the part `relaxation` may relax
  bool relaxes_itself = false;      // includes the part `relaxation` in its own equations
  ModelDiagnosticNames diagnostics = {};
};

// Defaults for a model: it neither uses the device's stiffness nor reduces a tissue's, and publishes no diagnostics.
struct ResistanceDefaults {
  // N/mm along the line that the part `shaft_friction` must leave to the model.
  double firm_stiffness() const noexcept { return 0.0; }
  // The smallest factor by which a tissue's stiffness had to be reduced for the device; 1 = none.
  double stiffness_scale() const noexcept { return 1.0; }
  // Of the last tick.
  ModelDiagnostics diagnostics() const noexcept { return {}; }
};

// A model of a needle's resistance, one file pair. It is constructed from (const Case&, const Settings&, double dt)
// and throws InputError for settings or tissues that make it impossible, active, or too stiff for the device; the
// case outlives it. begin() starts a new line (unit direction) with nothing touched yet, step() computes one tick on
// it, reset() forgets all state. All three are deterministic and neither allocate nor throw.
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

// What a model of a deformable body is besides: simulation/body_port.h.
class TissueBody {
 protected:
  ~TissueBody() = default;
};

// Any resistance model behind one interface; made before the ticks begin, so that no tick allocates.
class AnyResistance {
 public:
  virtual ~AnyResistance() = default;

  virtual void begin(const Vec3& entry, const Vec3& direction) noexcept = 0;
  virtual ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept = 0;
  virtual void reset() noexcept = 0;

  virtual const ResistanceTraits& traits() const noexcept = 0;
  virtual double firm_stiffness() const noexcept = 0;
  virtual double stiffness_scale() const noexcept = 0;
  virtual ModelDiagnostics diagnostics() const noexcept = 0;

  // The deformable body of the model; null for a model without one.
  virtual TissueBody* body() noexcept = 0;
};

template <ResistanceModel Model>
class ResistanceOf final : public AnyResistance {
 public:
  ResistanceOf(const anatomy::Case& patient, const typename Model::Settings& settings, double dt)
      : model_(patient, settings, dt) {}

  void begin(const Vec3& entry, const Vec3& direction) noexcept final { model_.begin(entry, direction); }
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept final {
    return model_.step(needle, events);
  }
  void reset() noexcept final { model_.reset(); }

  const ResistanceTraits& traits() const noexcept final { return Model::traits; }
  double firm_stiffness() const noexcept final { return model_.firm_stiffness(); }
  double stiffness_scale() const noexcept final { return model_.stiffness_scale(); }
  ModelDiagnostics diagnostics() const noexcept final { return model_.diagnostics(); }
  TissueBody* body() noexcept final {
    if constexpr (std::is_base_of_v<TissueBody, Model>) return &model_;
    return nullptr;
  }

 private:
  Model model_;
};

// A resistance that a case can choose. `make` reads the settings from the patient's description; it throws
// InputError as the model's constructor does.
struct ResistanceEntry {
  ResistanceTraits traits;
  std::unique_ptr<AnyResistance> (*make)(const anatomy::Case& patient, double dt);
};

// The resistance with these settings, one of anatomy::ResistanceSettings. The source of the model defines it, or the
// program does not link:
//   template <>
//   ResistanceEntry resistance_with<anatomy::FractureSettings>() { return entry_of<Fracture>(); }
template <typename Settings>
ResistanceEntry resistance_with();

template <ResistanceModel Model>
ResistanceEntry entry_of() {
  using Settings = typename Model::Settings;
  static_assert(Model::traits.name == Settings::element);
  return {Model::traits, [](const anatomy::Case& patient, double dt) -> std::unique_ptr<AnyResistance> {
            const auto& settings = std::get<Settings>(patient.description.haptics.resistance);
            return std::make_unique<ResistanceOf<Model>>(patient, settings, dt);
          }};
}

}  // namespace bodkin::forces
