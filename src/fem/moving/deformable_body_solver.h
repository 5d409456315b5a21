#pragma once

#include <optional>
#include <span>

#include "fem/moving/corotational_body.h"
#include "fem/moving/probe_press.h"
#include "fem/solid/elastic_body.h"

namespace bodkin::fem {

struct BodySolverSettings {
  CorotationalSettings motion;
  ProbeFace probe;
};

// A deformable body and the probe that presses it, one step at a time and without a thread (BodyThread runs it on
// one).
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

// Writes by how much the nodes lie from their places at rest, mm, x y z in turn, into as many numbers as the body
// has.
void read_displacements(const CorotationalBody& body, std::span<float> displacements) noexcept;

}  // namespace bodkin::fem
