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

// Where a ray from `from` along `direction` (unit) first meets the body, within `reach` mm. Nothing when it does not,
// or when it begins inside.
std::optional<SkinPoint> skin_on_ray(const anatomy::TissueVolume& tissues, const Vec3& from, const Vec3& direction,
                                     double reach);

// The direction out of the body at `point` on the skin, averaged over a few mm; nothing where no air is near.
std::optional<Vec3> outwards_at(const anatomy::TissueVolume& tissues, const Vec3& point);

// How a needle that is put down at `skin` points into the body: as the plan does, unless that were flatter than 30
// degrees to the skin; then, and without a plan, straight in.
Vec3 aimed_axis(const SkinPoint& skin, const std::optional<anatomy::NeedlePath>& plan);

}  // namespace bodkin::app
