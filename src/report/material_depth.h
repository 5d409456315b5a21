#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/plot.h"
#include "session/session_file.h"

#include "simulation/tick_record.h"

namespace bodkin::report {

// The depth used in plots: that of the tip in the hand, or that of the tissue at the tip in its undeformed state
// (forces::ResistanceForce::material). While a tissue is pushed but not punctured, the first grows and the second
// does not.
enum class PlottedDepth : std::uint8_t { hand, material };

// "hand" or "material". `option`: its name in the message. Throws InputError for anything else.
PlottedDepth parse_plotted_depth(std::string_view text, std::string_view option);

// Ticks and events of a session with depths in the material.
struct MaterialDepths {
  std::vector<simulation::TickRecord> ticks;
  std::vector<session::SessionEvent> events;
};

// Position of the depth in the material among the diagnostics; empty if the models do not know it.
std::optional<std::size_t> material_diagnostic(std::span<const session::RecordedDiagnostic> diagnostics);

// `events` may be in the ticks or separate. Throws InputError when the diagnostics have no depth in the material.
MaterialDepths in_material(std::span<const simulation::TickRecord> ticks,
                           std::span<const session::SessionEvent> events,
                           std::span<const session::RecordedDiagnostic> diagnostics);

// The label of an axis of `depth`.
std::string depth_label(PlottedDepth depth);

}  // namespace bodkin::report
