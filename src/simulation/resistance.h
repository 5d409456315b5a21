#pragma once

#include <memory>

#include "anatomy/case.h"
#include "core/axial_motion.h"
#include "core/geometry.h"
#include "fem/node_forces.h"
#include "forces/events.h"
#include "forces/rail.h"

namespace bodkin {

// Where the needle is, as far as a resistance needs to know.
struct NeedleInTissue {
  AxialMotion motion;             // along the frozen line
  Vec3 tip = Vec3::Zero();        // LPS mm
  TissueId tissue = tissue::air;  // at the tip
  Vec3 axis = Vec3::UnitZ();      // unit, hub to tip
  Vec3 side = Vec3::UnitX();      // unit, across the needle, turns with its shaft
  const Rail* rail = nullptr;     // holds the proxy on the line, if that is the case's constraint
};

// What a resistance found in one tick.
struct ResistanceForce {
  double along = 0.0;          // N, along the frozen line, positive pushes the hand out
  Vec3 across = Vec3::Zero();  // N on the hand, of models whose force may leave the line
  Vec3 torque = Vec3::Zero();  // N mm on the hand, about the tip, of models that feel the whole shaft
  double stiffness = 0.0;      // N/mm, elastic tangent where the model knows it; 0 otherwise
  bool in_contact = false;     // false: the needle has left the body, the line can be released
};

// The resistance that a case chooses, with its parts: any of `resistance_names`. Deterministic; step() allocates
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
  // The model holds the needle laterally itself (`volume_proxy`, `embedded_needle`), so a rail adds only its torque.
  bool holds_laterally() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bodkin
