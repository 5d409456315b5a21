#pragma once

#include <optional>

#include "anatomy/needle_path.h"
#include "anatomy/volume.h"
#include "core/geometry.h"

namespace bodkin::app {

struct SkinPoint {
  Vec3 point = Vec3::Zero();      // LPS mm
  Vec3 outwards = Vec3::UnitY();  // unit
};

// The first intersection of a ray from `from` along `direction` (unit) with the body, within `reach` mm. Empty if
// there is none, or if it begins inside.
std::optional<SkinPoint> skin_on_ray(const anatomy::TissueVolume& tissues, const Vec3& from, const Vec3& direction,
                                     double reach);

// The direction out of the body at `point` on the skin, averaged over a few mm; empty if no air is near.
std::optional<Vec3> outwards_at(const anatomy::TissueVolume& tissues, const Vec3& point);

// The direction into the body of a needle put down at `skin`: that of the plan, unless that were flatter than 30
// degrees to the skin; then, and without a plan, perpendicular to the skin.
Vec3 aimed_axis(const SkinPoint& skin, const std::optional<anatomy::NeedlePath>& plan);

}  // namespace bodkin::app
