#pragma once

#include <span>
#include <vector>

#include "report/plot.h"
#include "session/session_file.h"

#include "simulation/tick_record.h"

namespace bodkin::report {

// What the force models published (forces/diagnostics.h) against the depth of the deepest insertion: a plot for each
// unit, in the order in which the units come. None where nothing was published or no needle went in.
std::vector<Plot> diagnostics_against_depth(std::span<const simulation::TickRecord> ticks,
                                            std::span<const session::RecordedDiagnostic> diagnostics);

// The unit in which the name of a diagnostic ends: "mm" of "wall_mm", "N mm" of "stored_N_mm", "" of "grip".
std::string unit_of_diagnostic(const std::string& name);

}  // namespace bodkin::report
