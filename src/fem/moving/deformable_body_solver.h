#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "anatomy/condensed_body.h"
#include "core/progress.h"
#include "fem/moving/corotational_body.h"
#include "fem/moving/corotational_tangent.h"
#include "fem/moving/probe_press.h"
#include "fem/node_forces.h"
#include "fem/solid/elastic_body.h"

namespace bodkin::fem {

struct BodySolverSettings {
  CorotationalSettings motion;
  ProbeFace probe;
  // A new corridor is due when no node moves by more than `settled` mm in a step and one has moved by more than
  // `worth` mm since the last corridor; both above 0 [D: half the tremor of a resting hand in 1/60 s, and what is
  // visible in an ultrasound image].
  double settled = 0.05;
  double worth = 0.5;
  std::size_t memory_limit = 0;  // see FactorOptions
};

// The state of the body that a corridor is made from.
struct BodyState {
  NodeVectors places;              // mm, one column per node of the mesh
  std::vector<std::uint8_t> held;  // by node of the mesh: CorotationalBody::all_held
  bool needle = false;             // a needle is in it: the corridor is made about the state without its forces
};

// A deformable body, the probe that presses it, the needle's forces on it, and the corridor about its present state,
// one step at a time and without a thread (BodyThread runs it on one).
class DeformableBodySolver {
 public:
  // Checks the arguments; throws InputError. Allocates the memory of all steps, but not that of corridors.
  DeformableBodySolver(const BodyDescription& body, const BodySolverSettings& settings);

  // One step; does not throw, allocate, lock or read a clock. `probe`: empty when no probe touches the body;
  // `needle`: forces on nodes of the mesh; node numbers out of range are ignored.
  const CorotationalStep& step(const std::optional<Pose>& probe, const NodeForces& needle) noexcept;

  // Whether a corridor about the present state is due: the body has settled in another place than that of the last
  // corridor. While a needle is in, which moves the body too, only nodes that the probe holds, or held, count.
  bool corridor_is_due() const noexcept { return due_; }
  // The corridor's nodes where they are now and their compliance there, with the nodes under the probe held a
  // thousand times as firmly as the stiffest node; null when it does not fit into memory. In a state that buckles the
  // stiffness by compressive stress is left out (StressStiffness::positive).
  std::shared_ptr<anatomy::CondensedBody> make_corridor();
  // The same in two parts, of which one other thread may do the second while this one keeps stepping: take_state()
  // copies the present state, after which no corridor is due until the body has moved on; make_corridor() makes the
  // corridor about it. `progress` is called from the work, and may abort it by throwing. `nodes`: of the mesh, the
  // corridor from now on; empty: unchanged. If the corridor cannot be made, the previous one stays.
  void take_state(BodyState& state);
  std::shared_ptr<anatomy::CondensedBody> make_corridor(const BodyState& state, const Progress& progress = {},
                                                        std::vector<std::uint32_t> nodes = {});

  const CorotationalBody& body() const noexcept { return moving_; }
  const ProbePress& press() const noexcept { return press_; }
  // The corridor's nodes at rest and their tissues, without compliance. For the thread that makes corridors.
  const anatomy::CondensedBody& corridor_at_rest() const noexcept { return plan_.corridor; }
  bool settled() const noexcept { return settled_; }

 private:
  void judge(bool needle) noexcept;
  bool find_free(const BodyState& state, const Progress& progress);
  std::shared_ptr<anatomy::CondensedBody> condense_about(const NodeVectors& places,
                                                         std::span<const std::uint8_t> held,
                                                         const Progress& progress);

  BodySolverSettings settings_;
  BodyDescription description_;
  CorotationalBody moving_;
  ProbePress press_;
  BodyPlan plan_;
  NodeVectors last_corridor_;            // mm, places of the nodes in the last corridor
  std::vector<std::uint8_t> last_held_;  // by the probe, in the last corridor
  bool settled_ = true, due_ = false, needle_ = false;
  std::optional<CorotationalBody> free_;  // the body without a needle, at rest; for the thread that makes corridors
};

}  // namespace bodkin::fem
