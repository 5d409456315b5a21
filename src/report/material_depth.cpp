#include "report/material_depth.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"
#include "simulation/resistance_models.h"

namespace bodkin::report {

PlottedDepth parse_plotted_depth(std::string_view text, std::string_view option) {
  if (text == "hand") return PlottedDepth::hand;
  if (text == "material") return PlottedDepth::material;
  throw InputError(fmt::format("{} is '{}'; expected hand or material", option, text));
}

std::optional<std::size_t> material_diagnostic(std::span<const session::RecordedDiagnostic> diagnostics) {
  const auto found =
      std::find_if(diagnostics.begin(), diagnostics.end(), [](const session::RecordedDiagnostic& diagnostic) {
        return diagnostic.name == simulation::material_depth_name;
      });
  if (found == diagnostics.end()) return {};
  return static_cast<std::size_t>(found - diagnostics.begin());
}

MaterialDepths in_material(std::span<const simulation::TickRecord> ticks,
                           std::span<const session::SessionEvent> events,
                           std::span<const session::RecordedDiagnostic> diagnostics) {
  const std::optional<std::size_t> at = material_diagnostic(diagnostics);
  if (!at) {
    throw InputError(
        "the force models do not report the depth in the material; take a case with mechanics=\"physical\", or "
        "leave "
        "the plots at the depth of the hand");
  }
  MaterialDepths found{{ticks.begin(), ticks.end()}, {events.begin(), events.end()}};
  const auto depth_of = [&](const simulation::TickOutput& output) {
    return output.in_contact ? output.diagnostics[*at] : output.depth;
  };
  for (session::SessionEvent& event : found.events) {
    const auto tick = std::lower_bound(
        ticks.begin(), ticks.end(), event.tick,
        [](const simulation::TickRecord& record, std::uint64_t wanted) { return record.tick < wanted; });
    if (tick != ticks.end() && tick->tick == event.tick) event.event.depth = depth_of(tick->output);
  }
  for (simulation::TickRecord& record : found.ticks) record.output.depth = depth_of(record.output);
  return found;
}

std::string depth_label(PlottedDepth depth) {
  return depth == PlottedDepth::material ? "depth in the tissue at rest, mm" : "depth along the needle's line, mm";
}

}  // namespace bodkin::report
