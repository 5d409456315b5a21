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

namespace bodkin {

struct PressedBodySettings {
  CorotationalSettings motion;
  ProbeFace probe;
  // A new corridor is due when no node moves by more than `settled` mm in a step and one has moved by more than
  // `worth` since the last corridor; both above 0 [D: half of what a hand that holds still trembles by in 1/60 s, and
  // what is seen in an ultrasound image].
  double settled = 0.05;
  double worth = 0.5;
  std::size_t memory_limit = 0;  // as of FactorOptions
};

// What a corridor about a state of the body is made from.
struct PressedState {
  NodeVectors places;              // mm, a column a node of the mesh
  std::vector<std::uint8_t> held;  // by node of the mesh: CorotationalBody::all_held
  bool needle = false;             // a needle is in it: the corridor is about where the body would be without
};

// A body, the probe that presses it, the needle's forces on it, and the corridor about the state that it has come to:
// everything that MovingBody does on its thread, in one thread and step by step.
class PressedBody {
 public:
  // Checks all of it; throws InputError. Takes the memory of all steps, not that of corridors.
  PressedBody(const BodyDescription& body, const PressedBodySettings& settings);

  // One step. Nothing of it throws, allocates, locks or reads a clock. `probe`: none when empty; `needle`: forces on
  // nodes of the mesh, those out of range passed over.
  const CorotationalStep& step(const std::optional<Pose>& probe, const NodeForces& needle) noexcept;

  // Whether a corridor about the present state is due: the body has settled, elsewhere than for the last corridor.
  // While a needle is in, which moves the body too, elsewhere is where the probe has moved what it holds, or held.
  bool corridor_is_due() const noexcept { return due_; }
  // The corridor's nodes where they are now and their compliance about it, those under the probe held a thousand
  // times as firmly as the stiffest node; null when it does not fit into memory. Should the state be one that
  // buckles, the stiffness by compressive stress is left out (StressStiffness::positive).
  std::shared_ptr<CondensedBody> make_corridor();
  // The same in two parts, of which the second may be done by one other thread while this one goes on stepping: the
  // present state, after which no corridor is due until the body has moved on, and the corridor about such a state.
  // `progress` is called from the work and may give it up by throwing. `nodes`: of the mesh, which are the corridor
  // from now on; empty: as before. Where the corridor cannot be made, it stays as it was.
  void take_state(PressedState& state);
  std::shared_ptr<CondensedBody> make_corridor(const PressedState& state, const Progress& progress = {},
                                               std::vector<std::uint32_t> nodes = {});

  const CorotationalBody& body() const noexcept { return moving_; }
  const ProbePress& press() const noexcept { return press_; }
  // The corridor's nodes, tissues and where they are at rest; without compliance. Of who makes corridors.
  const CondensedBody& corridor_at_rest() const noexcept { return plan_.corridor; }
  bool settled() const noexcept { return settled_; }

 private:
  void judge(bool needle) noexcept;
  bool find_free(const PressedState& state, const Progress& progress);
  std::shared_ptr<CondensedBody> condense_about(const NodeVectors& places, std::span<const std::uint8_t> held,
                                                const Progress& progress);

  PressedBodySettings settings_;
  BodyDescription description_;
  CorotationalBody moving_;
  ProbePress press_;
  BodyPlan plan_;
  NodeVectors last_corridor_;            // places
  std::vector<std::uint8_t> last_held_;  // likewise
  bool settled_ = true, due_ = false, needle_ = false;
  std::optional<CorotationalBody> free_;  // of who makes corridors: the body without a needle, at rest
};

}  // namespace bodkin
