#pragma once

#include <memory>
#include <span>

#include "anatomy/case.h"
#include "forces/resistance_model.h"
#include "simulation/body_port.h"

namespace bodkin::simulation {

// The resistance that a case chooses, with its parts: any of resistance_models(). Deterministic; step() allocates
// nothing. The case must outlive the object.
class Resistance {
 public:
  // Throws InputError when settings or tissues make the model impossible, active, or too stiff for the device, and
  // for a part that does not go with the model.
  Resistance(const anatomy::Case& patient, double dt);
  ~Resistance();
  Resistance(Resistance&&) noexcept;
  Resistance& operator=(Resistance&&) noexcept;

  // A new line: nothing is touched yet. Models that remember channels do.
  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  // One tick on the line. Events are appended.
  forces::ResistanceForce step(const forces::NeedleInTissue& needle, forces::TickEvents& events) noexcept;
  // Forgets channels too.
  void reset() noexcept;

  // The deformable body of the model; null for a model without one. Valid as long as this.
  BodyPort* body() noexcept;

  // The smallest factor by which a tissue's stiffness had to be reduced for the device; 1 = none.
  double stiffness_scale() const noexcept;
  // ResistanceTraits::holds_laterally of the model.
  bool holds_laterally() const noexcept;
  // ResistanceTraits::passes_layers of the model.
  bool passes_layers() const noexcept;
  // What model and parts publish each tick, by name.
  std::span<const forces::DiagnosticName> diagnostic_names() const noexcept;
  // The values of the last tick, in the same order; those after them stay as they are.
  void publish(forces::Diagnostics& values) const noexcept;

 private:
  struct State;

  // One tick, with the grip of the hand.
  forces::ResistanceForce step_held(const forces::NeedleInTissue& held, forces::TickEvents& events) noexcept;

  std::unique_ptr<State> state_;
};

}  // namespace bodkin::simulation
