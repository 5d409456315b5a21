#pragma once

#include <cstdint>
#include <optional>

#include "session/session_file.h"

#include "simulation/operator_script.h"

namespace bodkin::training {

// Lets a simulated operator perform on a patient, as fast as it goes, and keeps the session in memory: the same ticks
// as `bodkin run` records with this case, script, path and seed. Without a diagnostic and without what only a file
// has (case.xml, digest, time). It ends when the tip touches the tissue `ending`. `longest`: s after which it ends
// whatever the operator does; the session then counts as finished too. Throws InputError for a script, a path or a
// patient that cannot be used.
session::Session simulate_attempt(const anatomy::Case& patient, const simulation::OperatorScript& script,
                                  const anatomy::NeedlePath& path, std::uint64_t seed,
                                  const std::optional<anatomy::TissueId>& ending = {}, double longest = 120.0);

}  // namespace bodkin::training
