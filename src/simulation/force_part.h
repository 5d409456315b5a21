#pragma once

#include <memory>
#include <span>
#include <vector>

#include "anatomy/case.h"
#include "forces/resistance_model.h"

namespace bodkin::simulation {

// What a case adds to its resistance without changing the force along the line: a pull across it, or something to
// watch. Made before the ticks begin; nothing in the tick allocates or throws.
class ForcePart {
 public:
  virtual ~ForcePart() = default;
  virtual void begin(const Vec3& entry, const Vec3& direction) noexcept = 0;
  // May add to the force across the line and to the events.
  virtual void step(const forces::NeedleInTissue& needle, forces::ResistanceForce& force,
                    forces::TickEvents& events) noexcept = 0;
  virtual void reset() noexcept = 0;
  // As many as diagnostic_names() has for it.
  virtual std::size_t publish(std::span<double> values) const noexcept = 0;
};

// The parts of a case that are such: bevel_tip, csf_flow, syringe. Throws InputError for settings out of range.
std::vector<std::unique_ptr<ForcePart>> make_force_parts(const anatomy::Case& patient, double dt);

// What they publish, in their order.
std::vector<forces::DiagnosticName> force_part_diagnostics(const anatomy::ForceParts& parts);

}  // namespace bodkin::simulation
