#pragma once

#include <optional>

#include "anatomy/breathing.h"
#include "core/geometry.h"

namespace bodkin::scene {

// Displacement of the displayed patient by breathing; by default none.
struct BreathMotion {
  std::optional<anatomy::BreathField> field = {};
  double drawn_in = 0.0;  // 0 to 1

  bool moves() const { return field.has_value() && drawn_in > 0.0; }
  // mm, displacement of the point `rest` (LPS mm after expiration).
  Vec3 of(const Vec3& rest) const { return moves() ? field->moved(rest, drawn_in) : Vec3(Vec3::Zero()); }
  // LPS mm, position after expiration of the point now at `place`.
  Vec3 at_rest(const Vec3& place) const { return moves() ? field->material(place, drawn_in) : place; }
};

}  // namespace bodkin::scene
