#include "link/needle_state.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "link/contents.h"
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::link {

namespace {

constexpr std::size_t fixed_columns = needle_state_fixed_columns;

// Between LPS and RAS, the same in both directions.
Vec3 mirrored(const Vec3& force) {
  return {-force.x(), -force.y(), force.z()};
}

// Values out of range become 0: the sender is another program.
template <typename Whole>
Whole whole(double value) {
  constexpr double exact = 9007199254740992.0;  // 2^53: beyond it a double does not represent every whole number
  const double most = std::min(exact, static_cast<double>(std::numeric_limits<Whole>::max()));
  return value >= 0.0 && value <= most ? static_cast<Whole>(value) : Whole{};
}

}  // namespace

std::vector<std::string> needle_state_columns(std::span<const forces::DiagnosticName> diagnostics) {
  std::vector<std::string> names = {"time_s",        "depth_mm",       "velocity_mm_s", "requested_R_N",
                                    "requested_A_N", "requested_S_N",  "applied_R_N",   "applied_A_N",
                                    "applied_S_N",   "resistance_N",   "constraint_N",  "energy_N_mm",
                                    "tissue",        "in_contact",     "limits",        "ticks",
                                    "late_ticks",    "recent_success", "drawn_in"};
  for (const forces::DiagnosticName& each : diagnostics) names.emplace_back(each.name);
  return names;
}

NeedleState needle_state(const station::StationStatus& status, std::size_t diagnostics) {
  const simulation::TickOutput& output = status.needle.output;
  NeedleState state;
  state.time = status.time;
  state.depth = output.depth;
  state.velocity = output.velocity;
  state.requested = output.requested.force;
  state.applied = output.applied.force;
  state.resistance = output.resistance;
  state.constraint = output.constraint;
  state.energy = output.energy;
  state.tissue = output.tissue;
  state.in_contact = output.in_contact;
  state.limits = status.servo.limits;
  state.ticks = status.timings.ticks;
  state.late_ticks = status.timings.overruns;
  state.recent_success = status.timings.recent_success;
  state.drawn_in = output.drawn_in;
  const auto* const first = output.diagnostics.data();
  state.diagnostics.assign(first, first + std::min(diagnostics, output.diagnostics.size()));
  return state;
}

Bytes needle_state_content(const NeedleState& state) {
  const Vec3 requested = mirrored(state.requested), applied = mirrored(state.applied);
  std::vector<double> row = {state.time,
                             state.depth,
                             state.velocity,
                             requested.x(),
                             requested.y(),
                             requested.z(),
                             applied.x(),
                             applied.y(),
                             applied.z(),
                             state.resistance,
                             state.constraint,
                             state.energy,
                             static_cast<double>(state.tissue),
                             state.in_contact ? 1.0 : 0.0,
                             static_cast<double>(state.limits),
                             static_cast<double>(state.ticks),
                             static_cast<double>(state.late_ticks),
                             state.recent_success,
                             state.drawn_in};
  row.insert(row.end(), state.diagnostics.begin(), state.diagnostics.end());
  return array_content(row, row.size());
}

NeedleState read_needle_state(std::span<const std::uint8_t> content) {
  const NumberArray array = read_array(content);
  if (array.size.size() != 2 || array.size[0] != 1 || array.size[1] < fixed_columns) {
    throw InputError(fmt::format(
        "NeedleState is not a row of at least {} numbers; the server runs another version of Bodkin", fixed_columns));
  }
  const std::vector<double>& row = array.values;
  if (!std::all_of(row.begin(), row.end(), [](double value) { return std::isfinite(value); }))
    throw InputError("NeedleState holds something that is not a finite number");
  NeedleState state;
  state.time = row[0];
  state.depth = row[1];
  state.velocity = row[2];
  state.requested = mirrored({row[3], row[4], row[5]});
  state.applied = mirrored({row[6], row[7], row[8]});
  state.resistance = row[9];
  state.constraint = row[10];
  state.energy = row[11];
  state.tissue = whole<anatomy::TissueId>(row[12]);
  state.in_contact = row[13] != 0.0;
  state.limits = whole<std::uint32_t>(row[14]);
  state.ticks = whole<std::uint64_t>(row[15]);
  state.late_ticks = whole<std::uint64_t>(row[16]);
  state.recent_success = row[17];
  state.drawn_in = std::clamp(row[18], 0.0, 1.0);
  state.diagnostics.assign(row.begin() + fixed_columns, row.end());
  return state;
}

}  // namespace bodkin::link
