#pragma once

#include <optional>
#include <string>

#include "report/plot.h"
#include "session/session_file.h"

#include "anatomy/case.h"

namespace bodkin::report {

// Attempts of the simulated expert with which an attempt's forces are compared.
inline constexpr int expert_attempts = 20;

// The resistance that the simulated operator `expert` (session::load_operator) meets on the way in, against depth: on
// this patient, with the path, the device and the force models of the session, in `expert_attempts` attempts with
// seeds of their own. Each depth has the least and the greatest of what the attempts felt there, within half a
// millimetre. Nothing for models of a deformable body, whose attempts take minutes, or where the expert cannot begin
// on this path. Throws InputError for an operator that does not exist.
std::optional<PlotRange> expert_forces(const anatomy::Case& patient, const session::SessionHeader& header,
                                       const std::string& expert);

}  // namespace bodkin::report
