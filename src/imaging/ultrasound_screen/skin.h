#pragma once

#include <optional>

#include "anatomy/volume.h"

namespace bodkin::imaging {

// A point of the body's surface.
struct SkinPoint {
  Vec3 place = Vec3::Zero();     // LPS mm
  Vec3 outward = Vec3::UnitY();  // unit, away from the body
};

// The point where the ray from `inside` along `direction` (not necessarily unit) finally leaves the body: followed by
// 15 mm of air, ignoring a couch behind the back. Empty if the ray begins in air or the image ends before the body.
std::optional<SkinPoint> skin_along(const anatomy::TissueVolume& tissues, const Vec3& inside, const Vec3& direction);

// The skin on the line through `point` along `outward` (not necessarily unit) that is nearest to the point, at most
// `reach` mm from it. Empty if there is none.
std::optional<SkinPoint> skin_near(const anatomy::TissueVolume& tissues, const Vec3& point, const Vec3& outward,
                                   double reach);

// Unit, out of the body at a point on the skin; `fallback` (unit) if the neighbourhood is ambiguous.
Vec3 outward_of_skin(const anatomy::TissueVolume& tissues, const Vec3& place, const Vec3& fallback);

}  // namespace bodkin::imaging
