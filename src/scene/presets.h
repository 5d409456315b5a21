#pragma once

#include <cstdint>
#include <string_view>

#include "scene/surfaces.h"

namespace bodkin::scene {

// The visible parts of the patient.
enum class Preset : std::uint8_t {
  skin,        // the outside
  cut_away,    // the skin with an opening about the path, inside everything that a needle can meet
  bones,       // bones and the structures between them
  see_through  // everything under a faint skin
};

inline constexpr Preset presets[] = {Preset::skin, Preset::cut_away, Preset::bones, Preset::see_through};

constexpr std::string_view name_of(Preset preset) {
  constexpr std::string_view names[] = {"skin", "cut_away", "bones", "see_through"};
  return names[static_cast<std::size_t>(preset)];
}

// 0: the skin is not drawn, 1: it hides everything behind it; 0 within the opening of a cut-away.
constexpr float skin_opacity(Preset preset) {
  constexpr float opacities[] = {1.0F, 1.0F, 0.0F, 0.15F};
  return opacities[static_cast<std::size_t>(preset)];
}

constexpr bool shows(Preset preset, SurfaceKind kind) {
  if (kind == SurfaceKind::skin) return preset != Preset::bones;
  return preset != Preset::bones || kind != SurfaceKind::forbidden;
}

}  // namespace bodkin::scene
