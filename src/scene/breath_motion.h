#pragma once

#include <optional>

#include "anatomy/breathing.h"
#include "core/geometry.h"

namespace bodkin::scene {

// How breath has moved the patient who is drawn; by default not at all.
struct BreathMotion {
  std::optional<anatomy::BreathField> field = {};
  double drawn_in = 0.0;  // 0 to 1

  bool moves() const { return field.has_value() && drawn_in > 0.0; }
  // mm, of what lies at `rest` (LPS mm) when the patient has breathed out.
  Vec3 of(const Vec3& rest) const { return moves() ? field->moved(rest, drawn_in) : Vec3(Vec3::Zero()); }
  // LPS mm, where what now is at `place` lies when the patient has breathed out.
  Vec3 at_rest(const Vec3& place) const { return moves() ? field->material(place, drawn_in) : place; }
};

}  // namespace bodkin::scene
