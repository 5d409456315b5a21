#pragma once

#include <span>
#include <string_view>

#include "session/session_file.h"

#include "forces/diagnostics.h"
#include "simulation/tick_record.h"

namespace bodkin::station {

// The state of a needle's contact with the body, derived from a session's ticks and events for displays: whether it
// touches, whether the skin is punctured, whether the tip is on bone.
class PunctureWatch {
 public:
  // `output`: of the newest tick. `events`: since the last call.
  void update(const simulation::TickOutput& output, std::span<const session::SessionEvent> events);

  bool is_touching() const noexcept { return touching_; }
  bool has_punctured() const noexcept { return punctured_; }
  bool is_on_bone() const noexcept { return on_bone_; }

  // mm, inward motion along the needle of the skin around it, according to the force model: the tissue in front of
  // the tip until the skin is punctured, then the tissue that adheres to the shaft, which a withdrawing needle pulls
  // up (negative).
  double skin_dimple(const simulation::TickOutput& output,
                     std::span<const forces::DiagnosticName> names) const noexcept;

 private:
  bool touching_ = false, punctured_ = false, on_bone_ = false;
};

// The diagnostic of this name; null if the model has none.
const double* find_diagnostic(const simulation::TickOutput& output, std::span<const forces::DiagnosticName> names,
                              std::string_view name) noexcept;

// The fraction of the dimple at a distance (mm) from the needle's line: 1 at the needle, and farther out as 1/r, as
// the surface of an elastic half-space sinks about a point load (Boussinesq). The width, 3 mm, is our choice.
double dimple_share(double distance) noexcept;

}  // namespace bodkin::station
