#pragma once

#include <span>
#include <vector>

#include "report/plot.h"
#include "session/session_file.h"

#include "simulation/tick_record.h"

namespace bodkin::report {

// The diagnostics of the force models (forces/diagnostics.h) against the depth of the deepest insertion: a plot for
// each unit, in the order of the units' first occurrence. Empty without diagnostics or without an insertion.
std::vector<Plot> diagnostics_against_depth(std::span<const simulation::TickRecord> ticks,
                                            std::span<const session::RecordedDiagnostic> diagnostics);

// The unit at the end of a diagnostic's name: "mm" of "wall_mm", "N mm" of "stored_N_mm", "" of "grip".
std::string unit_of_diagnostic(const std::string& name);

}  // namespace bodkin::report
