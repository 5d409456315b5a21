#pragma once

#include <memory>
#include <span>

#include "anatomy/case.h"
#include "forces/resistance_model.h"
#include "simulation/body_port.h"

namespace bodkin::simulation {

// The resistance chosen by a case, with its parts: any of resistance_models(). Deterministic; step() allocates
// nothing. The case must outlive the object.
class Resistance {
 public:
  // Throws InputError when settings or tissues make the model impossible, active, or too stiff for the device, and
  // for a part that is incompatible with the model.
  Resistance(const anatomy::Case& patient, double dt);
  ~Resistance();
  Resistance(Resistance&&) noexcept;
  Resistance& operator=(Resistance&&) noexcept;

  // A new line: nothing is touched yet. Models with a memory of channels keep it.
  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  // One tick on the line. Events are appended.
  forces::ResistanceForce step(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept;
  // Forgets all state, including channels.
  void reset() noexcept;

  // The deformable body of the model; null for a model without one. Valid as long as this object.
  BodyPort* body() noexcept;

  // The smallest factor by which a tissue's stiffness had to be reduced for the device; 1 = none.
  double stiffness_scale() const noexcept;
  // ResistanceTraits::has_lateral_force of the model.
  bool has_lateral_force() const noexcept;
  // ResistanceTraits::passes_layers of the model.
  bool passes_layers() const noexcept;
  // Diagnostics of model and parts, by name.
  std::span<const forces::DiagnosticName> diagnostic_names() const noexcept;
  // The values of the last tick, in the same order; further elements are not changed.
  void publish(forces::Diagnostics& values) const noexcept;

 private:
  struct State;

  // One tick, with the grip on the shaft.
  forces::ResistanceForce step_held(const forces::NeedleInTissue& held, forces::TickEvents& events) noexcept;

  std::unique_ptr<State> state_;
};

}  // namespace bodkin::simulation
