#pragma once

#include <optional>

#include "anatomy/volume.h"

namespace bodkin::imaging {

// A place where the body ends.
struct SkinPoint {
  Vec3 place = Vec3::Zero();     // LPS mm
  Vec3 outward = Vec3::UnitY();  // unit, away from the body
};

// Where the ray from `inside` along `direction` (need not be unit) leaves the body for good: air for 15
// mm, which a couch behind the back does not end. Nothing when the walk begins in air or the image ends before the
// body.
std::optional<SkinPoint> skin_along(const anatomy::TissueVolume& tissues, const Vec3& inside, const Vec3& direction);

// The skin on the line through `point` along `outward` (need not be unit) that is nearest to the point, at most
// `reach` mm from it. Nothing when it finds none.
std::optional<SkinPoint> skin_near(const anatomy::TissueVolume& tissues, const Vec3& point, const Vec3& outward,
                                   double reach);

// Unit, out of the body at a place on the skin; `fallback` (unit) where the neighbourhood is ambiguous.
Vec3 outward_of_skin(const anatomy::TissueVolume& tissues, const Vec3& place, const Vec3& fallback);

}  // namespace bodkin::imaging
