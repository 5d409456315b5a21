#pragma once

#include <optional>
#include <string>

#include "report/plot.h"
#include "session/session_file.h"

#include "anatomy/case.h"

namespace bodkin::report {

// Number of the simulated expert's attempts with which an attempt's forces are compared.
inline constexpr int expert_attempts = 20;

// The resistance that the simulated operator `expert` (session::load_operator) meets during insertion, against depth:
// on this patient, with the path, the device and the force models of the session, in `expert_attempts` attempts with
// seeds of their own. Each depth has the minimum and maximum of the attempts within half a millimetre. Empty for
// models of a deformable body, whose attempts take minutes, or if the expert cannot start on this path. Throws
// InputError for an unknown operator.
std::optional<PlotRange> expert_forces(const anatomy::Case& patient, const session::SessionHeader& header,
                                       const std::string& expert);

}  // namespace bodkin::report
