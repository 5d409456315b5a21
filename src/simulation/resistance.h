#pragma once

#include <memory>
#include <span>

#include "anatomy/case.h"
#include "fem/node_forces.h"
#include "forces/resistance_model.h"

namespace bodkin {

// The resistance that a case chooses, with its parts: any of resistance_models(). Deterministic; step() allocates
// nothing. The case must outlive the object.
class Resistance {
 public:
  // Throws InputError when settings or tissues make the model impossible, active, or too stiff for the device, and
  // for a part that does not go with the model.
  Resistance(const Case& patient, double dt);
  ~Resistance();
  Resistance(Resistance&&) noexcept;
  Resistance& operator=(Resistance&&) noexcept;

  // A new line: nothing is touched yet. Models that remember channels do.
  void begin(const Vec3& entry, const Vec3& direction) noexcept;
  // One tick on the line. Events are appended.
  ResistanceForce step(const NeedleInTissue& needle, TickEvents& events) noexcept;
  // Forgets channels too.
  void reset() noexcept;

  // Another corridor of the deformable body, for a needle that begins after this. Not for two threads at once, but
  // beside the tick. False, and nothing done, where there is no room for more, or the model has none.
  bool add_corridor(const PreparedCorridor& corridor);
  // The first corridor about another state of the body, likewise: PreparedCorridor::state. False where the model has
  // none that can change. Throws InputError for one in which there is nothing to feel.
  bool refresh_corridor(const PreparedCorridor& corridor);
  // From the tick: needles that begin from now on find the body at rest.
  void stay_at_rest() noexcept;
  // What the needle does to a deformable body, by node of its mesh; nothing for other models.
  NodeForces node_forces() const noexcept;
  // mm by which the hand's needle is ahead of the one that such a body shows; 0 for other models.
  Vec3 ahead() const noexcept;

  // The smallest factor by which a tissue's stiffness had to be reduced for the device; 1 = none.
  double stiffness_scale() const noexcept;
  // ResistanceTraits::holds_laterally of the model.
  bool holds_laterally() const noexcept;
  // What model and parts publish each tick, by name; the values of the last tick, in the same order.
  std::span<const DiagnosticName> diagnostic_names() const noexcept;
  Diagnostics diagnostics() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodkin
