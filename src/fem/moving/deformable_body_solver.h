#pragma once

#include <optional>
#include <vector>

#include "fem/body_motion.h"
#include "fem/moving/corotational_body.h"
#include "fem/moving/probe_press.h"
#include "fem/solid/elastic_body.h"

namespace bodkin::fem {

struct BodySolverSettings {
  CorotationalSettings motion;
  ProbeFace probe;
  std::vector<anatomy::NeedlePath> left_needles;  // left in the body, from entry to tip, at rest
};

// A deformable body and the probe that presses it, one step at a time and without a thread (BodyThread adds one).
class DeformableBodySolver {
 public:
  // Checks the arguments; throws InputError. Allocates the memory of all steps.
  DeformableBodySolver(const BodyDescription& body, const BodySolverSettings& settings);

  // One step; does not throw, allocate, lock or read a clock. `probe`: empty when no probe touches the body.
  const CorotationalStep& step(const std::optional<Pose>& probe) noexcept;

  const CorotationalBody& body() const noexcept { return moving_; }
  const ProbePress& press() const noexcept { return press_; }

 private:
  CorotationalBody moving_;
  ProbePress press_;
};

// The motion of a body at rest, with room for all later motions.
BodyField field_at_rest(const DeformableBodySolver& solver);
// After a step: sets `field` to the resulting motion. `failed`: this step or an earlier one failed, so that the
// needle meets the body at rest.
void read_field(const DeformableBodySolver& solver, bool failed, BodyField& field) noexcept;
}  // namespace bodkin::fem
