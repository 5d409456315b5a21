#pragma once

#include <cstdint>

#include "session/session_file.h"

#include "simulation/operator_script.h"

namespace bodkin::training {

// The other hand of a simulated operator, which holds an ultrasound probe with the planned path in its slice: written
// into the session a hundred times a second. The operator's aim and unsteadiness displace and turn the slice; when
// the tip has been out of it for the time of a reaction, the hand slides the probe after it. The probe presses on
// nothing, so that the needle feels the same with it and without. How fast it slides and how slowly it wanders are
// Bodkin's choice. The same seed gives the same samples on every machine.
void hold_probe(session::Session& session, const simulation::OperatorScript& script, std::uint64_t seed);

}  // namespace bodkin::training
