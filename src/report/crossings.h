#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "report/plot.h"

#include "anatomy/case.h"
#include "simulation/tick_record.h"

namespace bodkin::report {

// A section of one tissue that the tip passed, recorded at its first entry.
struct TissueCrossing {
  anatomy::TissueId tissue = anatomy::tissue::air;
  double from = 0.0;        // mm, depth of the near face (of the entry of the tip)
  double to = 0.0;          // mm, depth of the far face, or the deepest point in the last one
  double peak_force = 0.0;  // N, largest resistance while the tip passed through it
  double peak_depth = 0.0;  // mm, its depth
  double time = 0.0;        // s, from the first to the last tick of the first pass
};

// The tissues in the order of their depth during one insertion: `ticks` from contact to withdrawal. Ticks outside the
// body are ignored.
std::vector<TissueCrossing> tissues_crossed(std::span<const simulation::TickRecord> ticks, double dt);

// An insertion inside a recording: the ticks from the first contact until the needle has left the body.
struct Insertion {
  std::size_t first = 0;  // index of the first tick in contact
  std::size_t last = 0;   // index of the last tick in contact
  double deepest = 0.0;   // mm
};

// The insertions of a recording, in order.
std::vector<Insertion> insertions(std::span<const simulation::TickRecord> ticks);

// An event, for people: "skin gives way at 0.85 N".
std::string event_text(const forces::Event& event, const anatomy::TissueLibrary& library);
// Whether an event gets a number in a plot (a tissue entered without any other event does not).
bool is_notable(forces::EventKind kind);

// The crossings as coloured bands of a plot over depth.
std::vector<PlotBand> bands_of(std::span<const TissueCrossing> crossings, const anatomy::TissueLibrary& library);

}  // namespace bodkin::report
