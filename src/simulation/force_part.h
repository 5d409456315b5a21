#pragma once

#include <memory>
#include <span>
#include <vector>

#include "anatomy/case.h"
#include "forces/resistance_model.h"

namespace bodkin::simulation {

// A part of a case's resistance that does not change the force along the line: a lateral force, or a quantity to
// observe. Created before the ticks begin; nothing in the tick allocates or throws.
class ForcePart {
 public:
  virtual ~ForcePart() = default;
  virtual void begin(const Vec3& entry, const Vec3& direction) noexcept = 0;
  // May add to the lateral force and to the events.
  virtual void step(const forces::NeedleInTissue& needle, forces::ResistanceForce& force,
                    forces::TickEvents& events) noexcept = 0;
  void reset() noexcept { begin(Vec3::Zero(), Vec3::UnitZ()); }
  // Writes as many values as diagnostic_names() lists for it.
  virtual std::size_t publish(std::span<double> values) const noexcept = 0;
};

// The parts of a case of this kind: bevel_tip, csf_flow, syringe. Throws InputError for settings out of range.
std::vector<std::unique_ptr<ForcePart>> make_force_parts(const anatomy::Case& patient, double dt);

// Their diagnostics, in their order.
std::vector<forces::DiagnosticName> force_part_diagnostics(const anatomy::ForceParts& parts);

}  // namespace bodkin::simulation
