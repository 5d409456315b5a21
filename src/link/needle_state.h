#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "link/bytes.h"
#include "station/station_observer.h"

#include "core/geometry.h"
#include "forces/diagnostics.h"

namespace bodkin::link {

// The newest tick, with all that a screen elsewhere needs to show it as the station's own does: NDARRAY
// `NeedleState`, one row of numbers with the columns below.
struct NeedleState {
  double time = 0.0;              // s of the session
  double depth = 0.0;             // mm along the needle's line below the skin
  double velocity = 0.0;          // mm/s, inwards
  Vec3 requested = Vec3::Zero();  // N, LPS, that the models ask for
  Vec3 applied = Vec3::Zero();    // N, LPS, that leaves for the hand
  double resistance = 0.0;        // N along the needle
  double constraint = 0.0;        // N across it
  double energy = 0.0;            // N mm that the hand has given to the tissue
  anatomy::TissueId tissue = anatomy::tissue::air;
  bool in_contact = false;
  std::uint32_t limits = 0;  // see haptics::ServoSnapshot
  std::uint64_t ticks = 0;   // of the servo, and those that came late
  std::uint64_t late_ticks = 0;
  double recent_success = 1.0;      // share of the last hundred ticks that were in time
  double drawn_in = 0.0;            // breath, 0 to 1
  std::vector<double> diagnostics;  // of the force model, in the order of the names
};

// Columns before those of the diagnostics.
inline constexpr std::size_t needle_state_fixed_columns = 19;

// Names of the columns in turn, with units; those of `diagnostics` are the last ones.
std::vector<std::string> needle_state_columns(std::span<const forces::DiagnosticName> diagnostics);

// `diagnostics`: how many the force model has.
NeedleState needle_state(const station::StationStatus& status, std::size_t diagnostics);
Bytes needle_state_content(const NeedleState& state);
// Throws InputError for another number of rows, for fewer columns, and for what is not a finite number.
NeedleState read_needle_state(std::span<const std::uint8_t> content);

}  // namespace bodkin::link
