#pragma once

#include <span>
#include <vector>

#include "anatomy/case.h"
#include "training/plot.h"
#include "training/session_file.h"

namespace bodkin {

// The events that stand in records, with their ticks (a session that was read from a file holds them apart).
std::vector<SessionEvent> events_of(std::span<const TickRecord> ticks);

// Resistance against depth: the tissues of the deepest insertion as bands, its events as numbers, earlier insertions
// thin, and what the governor let through where that was something else. Forces far above the device's peak are cut
// off.
Plot force_against_depth(std::span<const TickRecord> ticks, std::span<const SessionEvent> events, double dt,
                         const Case& patient);

// Resistance and depth against time.
Plot force_and_depth_against_time(std::span<const TickRecord> ticks, double dt);

}  // namespace bodkin
