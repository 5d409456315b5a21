#include "scene/look.h"

#include <algorithm>

namespace bodkin::scene {

namespace {

const PartLook* find_part(const Look& look, std::string_view name) {
  const auto found = std::find_if(look.changed.begin(), look.changed.end(),
                                  [name](const PartLook& part) { return part.name == name; });
  return found == look.changed.end() ? nullptr : &*found;
}

void lay_over(const PartLook& part, Appearance& result) {
  if (part.shown) result.shown = *part.shown;
  if (part.opacity) result.opacity = static_cast<float>(std::clamp(*part.opacity, 0.0, 1.0));
  if (part.colour) result.colour = *part.colour & 0xFFFFFFU;
}

bool says_nothing(const PartLook& part) {
  return !part.shown && !part.opacity && !part.colour;
}

}  // namespace

Appearance appearance(const Look& look, const PatientSurface& surface, std::string_view section) {
  Appearance result{shows(look.preset, surface.kind), 1.0F, surface.colour};
  if (surface.kind == SurfaceKind::skin && result.shown) result.opacity = skin_opacity(look.preset);
  if (const PartLook* whole = find_part(look, surface.name)) lay_over(*whole, result);
  if (section.empty() || section == surface.name) return result;
  if (const PartLook* part = find_part(look, section)) lay_over(*part, result);
  return result;
}

Look changed(Look look, const PatientSurface& surface, const PartLook& change) {
  if (change.name == surface.name) {
    for (PartLook& part : look.changed) {
      const bool is_section =
          std::any_of(surface.sections.begin(), surface.sections.end(),
                      [&part](const SurfaceSection& section) { return section.name == part.name; });
      if (!is_section) continue;
      if (change.shown) part.shown.reset();
      if (change.opacity) part.opacity.reset();
      if (change.colour) part.colour.reset();
    }
  }
  auto found = std::find_if(look.changed.begin(), look.changed.end(),
                            [&change](const PartLook& part) { return part.name == change.name; });
  if (found == look.changed.end()) {
    look.changed.push_back({change.name, {}, {}, {}});
    found = look.changed.end() - 1;
  }
  if (change.shown) found->shown = change.shown;
  if (change.opacity) found->opacity = change.opacity;
  if (change.colour) found->colour = change.colour;
  std::erase_if(look.changed, says_nothing);
  return look;
}

Look with_preset(const Look& look, Preset preset) {
  Look result{preset, {}};
  for (const PartLook& part : look.changed) {
    if (part.colour) result.changed.push_back({part.name, {}, {}, part.colour});
  }
  return result;
}

bool skin_is_closed(const Look& look, const PatientSurfaces& surfaces) {
  const Appearance skin = appearance(look, surfaces.parts.front());
  return skin.shown && skin.opacity >= 1.0F && look.preset != Preset::cut_away;
}

}  // namespace bodkin::scene
