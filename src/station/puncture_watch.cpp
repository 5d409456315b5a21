#include "station/puncture_watch.h"

#include <algorithm>
#include <cmath>

namespace bodkin::station {

namespace {

constexpr double surely_inside = 8.0;  // mm, deeper than any skin dimples before puncture
constexpr double dimple_width = 3.0;   // mm

}  // namespace

void PunctureWatch::update(const simulation::TickOutput& output, std::span<const session::SessionEvent> events) {
  using forces::EventKind;
  for (const session::SessionEvent& event : events) {
    switch (event.event.kind) {
      case EventKind::puncture:
      case EventKind::loss_of_resistance:
        punctured_ = true;
        break;
      case EventKind::bone_contact:
        on_bone_ = true;
        break;
      case EventKind::bone_left:
        on_bone_ = false;
        break;
      case EventKind::withdrawn:
        punctured_ = on_bone_ = false;
        break;
      default:
        break;
    }
  }
  touching_ = output.depth > 0.0 && output.in_contact;
  if (touching_ && output.depth > surely_inside) punctured_ = true;
  if (!touching_) punctured_ = on_bone_ = false;
}

double PunctureWatch::skin_dimple(const simulation::TickOutput& output,
                                  std::span<const forces::DiagnosticName> names) const noexcept {
  if (!touching_) return 0.0;
  if (!punctured_) {
    const double* const wall = find_diagnostic(output, names, "wall_mm");
    return std::clamp(wall != nullptr ? output.depth - *wall : output.depth, 0.0, output.depth);
  }
  const double* const stretch = find_diagnostic(output, names, "stretch_mm");
  return stretch != nullptr ? *stretch : 0.0;
}

const double* find_diagnostic(const simulation::TickOutput& output, std::span<const forces::DiagnosticName> names,
                              std::string_view name) noexcept {
  for (std::size_t i = 0; i < std::min(names.size(), output.diagnostics.size()); ++i) {
    if (names[i].name == name) return &output.diagnostics[i];
  }
  return nullptr;
}

double dimple_share(double distance) noexcept {
  const double ratio = distance / dimple_width;
  return 1.0 / std::sqrt(1.0 + ratio * ratio);
}

}  // namespace bodkin::station
