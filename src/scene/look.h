#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/presets.h"
#include "scene/surfaces.h"

namespace bodkin::scene {

// The appearance of one part of the patient; missing values are the preset's.
struct PartLook {
  std::string name;  // of a surface ("organ") or of one of its sections ("kidney_right")
  std::optional<bool> shown;
  std::optional<double> opacity;        // 0 to 1
  std::optional<std::uint32_t> colour;  // 0xRRGGBB

  bool operator==(const PartLook&) const = default;
};

// A preset, and the deviations of parts of the patient from it. A section follows its surface unless it is listed
// itself.
struct Look {
  Preset preset = Preset::cut_away;
  std::vector<PartLook> changed;  // by name, each once

  bool operator==(const Look&) const = default;
};

// The resulting appearance of one part.
struct Appearance {
  bool shown = true;
  float opacity = 1.0F;  // 0 to 1
  std::uint32_t colour = 0x808080;

  // Whether any of it is drawn.
  bool drawn() const { return shown && opacity > 0.0F; }
};

// Of a surface (`section` empty) or of one of its sections.
Appearance appearance(const Look& look, const PatientSurface& surface, std::string_view section = {});

// The look with the values of `change` set for its part. For a whole surface with sections, the same values of its
// sections are dropped, so that all of it follows.
Look changed(Look look, const PatientSurface& surface, const PartLook& change);

// The look of another preset: visibility and opacity are the preset's, colours stay.
Look with_preset(const Look& look, Preset preset);

// Whether the skin hides everything under it.
bool skin_is_closed(const Look& look, const PatientSurfaces& surfaces);

}  // namespace bodkin::scene
