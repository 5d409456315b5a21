#pragma once

#include <span>
#include <vector>

#include "report/plot.h"
#include "session/session_file.h"

#include "anatomy/case.h"

namespace bodkin::report {

// Of the device's peak force: upper limit of plots of forces.
inline constexpr double highest_share = 1.5;

// The events in records, with their ticks (in a session read from a file they are separate).
std::vector<session::SessionEvent> events_of(std::span<const simulation::TickRecord> ticks);

// Resistance against depth: the tissues of the deepest insertion as bands, its events as numbers, earlier insertions
// thin, and the force after the governor if it differs. Forces far above the device's peak are cut off.
Plot force_against_depth(std::span<const simulation::TickRecord> ticks, std::span<const session::SessionEvent> events,
                         double dt, const anatomy::Case& patient);

// Resistance and depth against time.
Plot force_and_depth_against_time(std::span<const simulation::TickRecord> ticks, double dt);

// The energy given by the hand to the tissue along the needle, against time, with the times at which damping was
// added to keep it from falling below zero.
Plot energy_against_time(std::span<const simulation::TickRecord> ticks, double dt);

// The second hand against time, the upper plot first. Plunger: pressure and force on the thumb, each with the
// needle's depth. Probe: the force of the contact.
std::vector<Plot> second_hand_against_time(const session::Session& session);

}  // namespace bodkin::report
