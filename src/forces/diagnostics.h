#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace bodkin::forces {

// A number that a force model publishes every tick in addition to its force: the wall of a tracking wall, the energy
// stored in a membrane. It is recorded, exported and plotted under its name; nothing in the tick depends on it.
struct DiagnosticName {
  std::string_view name;   // of a column, with the unit: "wall_mm"; empty: no such diagnostic
  std::string_view title;  // as people read it: "position of the wall"
};

// Largest numbers: of one resistance, and of a resistance with all its parts.
inline constexpr std::size_t most_model_diagnostics = 4;
inline constexpr std::size_t most_diagnostics = 12;

using ModelDiagnosticNames = std::array<DiagnosticName, most_model_diagnostics>;
using ModelDiagnostics = std::array<double, most_model_diagnostics>;  // in the order of the names; unused ones are 0

// The diagnostics of one tick, in the order of HapticTick::diagnostic_names(); unused ones are 0.
using Diagnostics = std::array<double, most_diagnostics>;

constexpr std::size_t count_of(std::span<const DiagnosticName> names) noexcept {
  std::size_t count = 0;
  while (count < names.size() && !names[count].name.empty()) ++count;
  return count;
}

}  // namespace bodkin::forces
