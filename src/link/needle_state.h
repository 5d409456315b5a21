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

// The newest tick, with everything that a remote screen needs to show it as the station's own does: NDARRAY
// `NeedleState`, one row of numbers with the columns below.
struct NeedleState {
  double time = 0.0;              // s of the session
  double depth = 0.0;             // mm along the needle's line below the skin
  double velocity = 0.0;          // mm/s, inwards
  Vec3 requested = Vec3::Zero();  // N, LPS, by the models
  Vec3 applied = Vec3::Zero();    // N, LPS, on the hand
  double resistance = 0.0;        // N along the needle
  double constraint = 0.0;        // N across it
  double energy = 0.0;            // N mm given by the hand to the tissue
  anatomy::TissueId tissue = anatomy::tissue::air;
  bool in_contact = false;
  std::uint32_t limits = 0;  // see haptics::ServoSnapshot
  std::uint64_t ticks = 0;   // of the servo, and the late ones
  std::uint64_t late_ticks = 0;
  double recent_success = 1.0;      // fraction of the last hundred ticks that were on time
  double drawn_in = 0.0;            // inspiration, 0 to 1
  std::vector<double> diagnostics;  // of the force model, in the order of the names
};

// Columns before those of the diagnostics.
inline constexpr std::size_t needle_state_fixed_columns = 19;

// Names of the columns, with units; those of `diagnostics` come last.
std::vector<std::string> needle_state_columns(std::span<const forces::DiagnosticName> diagnostics);

// `diagnostics`: number of the force model's diagnostics.
NeedleState needle_state(const station::StationStatus& status, std::size_t diagnostics);
Bytes needle_state_content(const NeedleState& state);
// Throws InputError for another number of rows, for fewer columns, and for what is not a finite number.
NeedleState read_needle_state(std::span<const std::uint8_t> content);

}  // namespace bodkin::link
