#pragma once

#include <cstdint>

#include "session/session_file.h"

#include "simulation/operator_script.h"

namespace bodkin::training {

// The other hand of a simulated operator, which holds an ultrasound probe with the planned path in its slice:
// recorded in the session a hundred times a second. The operator's aim and unsteadiness displace and turn the slice;
// when the tip has been out of it for a reaction time, the hand slides the probe after it. The probe does not press,
// so the needle's forces are the same with and without it. The speeds of sliding and wandering are Bodkin's choice.
// The same seed gives the same samples on every machine.
void hold_probe(session::Session& session, const simulation::OperatorScript& script, std::uint64_t seed);

}  // namespace bodkin::training
