#pragma once

#include <cstdint>
#include <string_view>

#include "scene/surfaces.h"

namespace bodkin::scene {

// What is shown of the patient.
enum class Preset : std::uint8_t {
  skin,        // the outside
  cut_away,    // the skin with an opening about the path, inside all that a needle can meet
  bones,       // bones and what lies between them
  see_through  // all of it under a faint skin
};

inline constexpr Preset presets[] = {Preset::skin, Preset::cut_away, Preset::bones, Preset::see_through};

constexpr std::string_view name_of(Preset preset) {
  constexpr std::string_view names[] = {"skin", "cut_away", "bones", "see_through"};
  return names[static_cast<std::size_t>(preset)];
}

// 0: the skin is not drawn, 1: nothing behind it is seen; within the opening of a cut-away it is 0.
constexpr float skin_opacity(Preset preset) {
  constexpr float opacities[] = {1.0F, 1.0F, 0.0F, 0.15F};
  return opacities[static_cast<std::size_t>(preset)];
}

constexpr bool shows(Preset preset, SurfaceKind kind) {
  if (kind == SurfaceKind::skin) return preset != Preset::bones;
  return preset != Preset::bones || kind != SurfaceKind::forbidden;
}

}  // namespace bodkin::scene
