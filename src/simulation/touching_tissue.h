#pragma once

#include <algorithm>
#include <variant>

#include "anatomy/case.h"
#include "anatomy/tissue.h"
#include "anatomy/volume.h"
#include "core/geometry.h"

namespace bodkin::simulation {

// Tissue moves before it is punctured, so the tissue at the tip is not that of the CT at the tip's position but that
// at the tip's depth in the tissue at rest (ResistanceForce::material).

// mm on either side of an unpunctured boundary, at which the tissue is looked up: half a layer of `layered`.
inline constexpr double beside_boundary = 0.3;

// Whether the tip's tissue is found by this rule: with mechanics="physical" in every model, and always with
// `embedded_needle`. Otherwise it is that of the voxel at the tip, as in older cases.
inline bool goes_by_material(const anatomy::HapticSettings& haptics) noexcept {
  if (haptics.mechanics == anatomy::Mechanics::physical) return true;
  return std::holds_alternative<anatomy::EmbeddedNeedleSettings>(haptics.resistance);
}

// The tissue at the tip. `depth`: of the tip; `material`: depth at rest of the tissue that touches it; `at_tip`: in
// the CT at the tip. Before the skin is punctured it is the skin.
inline anatomy::TissueId touching_tissue(const anatomy::TissueVolume& tissues, const Vec3& entry,
                                         const Vec3& direction, double depth, double material,
                                         anatomy::TissueId at_tip) noexcept {
  if (!(material < depth)) return at_tip;
  const double inside = std::max(material - beside_boundary, beside_boundary);
  return anatomy::nearest<anatomy::TissueId>(tissues, Vec3(entry + inside * direction), anatomy::tissue::air);
}

// The tissue that the tip pushes.
inline anatomy::TissueId pushed_tissue(const anatomy::TissueVolume& tissues, const Vec3& entry, const Vec3& direction,
                                       double depth, double material, anatomy::TissueId at_tip) noexcept {
  if (!(material < depth)) return at_tip;
  return anatomy::nearest<anatomy::TissueId>(
      tissues, Vec3(entry + (std::max(material, 0.0) + beside_boundary) * direction), anatomy::tissue::air);
}

}  // namespace bodkin::simulation
