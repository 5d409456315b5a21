#pragma once

#include <cstdint>

#include "core/geometry.h"
#include "forces/diagnostics.h"
#include "forces/events.h"

namespace bodkin::simulation {

// What goes into one tick: where the device holds the needle.
struct TickInput {
  Pose needle = Pose::Identity();  // LPS mm, origin at the tip, third axis hub to tip
};

// What one tick found. Everything that is recorded, plotted and judged comes from here.
struct TickOutput {
  Wrench requested;         // what the models ask for, on the hand, LPS
  Wrench applied;           // what leaves through the governor
  double depth = 0.0;       // mm along the frozen line; negative or 0 outside
  double velocity = 0.0;    // mm/s, inwards
  double resistance = 0.0;  // N along the needle, positive pushes out
  double constraint = 0.0;  // N, size of the constraint force
  double energy = 0.0;      // N mm that the hand has given to the tissue along the needle, as passivity counts it
  anatomy::TissueId tissue = anatomy::tissue::air;  // at the tip
  bool in_contact = false;
  std::uint8_t limits = 0;            // governor flags, see haptics/force_governor.h
  forces::Diagnostics diagnostics{};  // of the resistance, in the order of HapticTick::diagnostic_names(); 0 outside
  forces::TickEvents events;
};

// One tick as a recording keeps it. Time is tick * dt.
struct TickRecord {
  std::uint64_t tick = 0;
  TickInput input;
  TickOutput output;
};

}  // namespace bodkin::simulation
