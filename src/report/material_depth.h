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

// What plots against depth count: how deep the hand has brought the tip, or how deep the tissue that touches the tip
// lies when nothing pushes it (forces::ResistanceForce::material). While a tissue is pushed and has not given way,
// the first grows and the second stays.
enum class PlottedDepth : std::uint8_t { hand, material };

// "hand" or "material". `option`: as it is called in the sentence. Throws InputError for anything else.
PlottedDepth parse_plotted_depth(std::string_view text, std::string_view option);

// Ticks and events of a session whose depths are those in the material.
struct MaterialDepths {
  std::vector<simulation::TickRecord> ticks;
  std::vector<session::SessionEvent> events;
};

// Where the depth in the material stands among the diagnostics; none where the models do not know it.
std::optional<std::size_t> material_diagnostic(std::span<const session::RecordedDiagnostic> diagnostics);

// `events` may stand in the ticks or apart. Throws InputError when the diagnostics have no depth in the material.
MaterialDepths in_material(std::span<const simulation::TickRecord> ticks,
                           std::span<const session::SessionEvent> events,
                           std::span<const session::RecordedDiagnostic> diagnostics);

// The label of an axis of `depth`.
std::string depth_label(PlottedDepth depth);

}  // namespace bodkin::report
