#pragma once

#include <memory>
#include <vector>

#include "anatomy/grid.h"
#include "anatomy/surface.h"
#include "core/geometry.h"

namespace bodkin::patient {

// [D] our choices.
struct SkinFitSettings {
  double reach = 120.0;   // mm around the middle within which the skins are matched; 30 to 500
  double spacing = 15.0;  // mm between the matched points; 5 to 60
};

// Throws InputError naming the first number out of range.
void check(const SkinFitSettings& settings);

// A skin, and the lattice of the volume from which it was drawn: at the volume's border the surface is a lid, not
// skin.
struct Skin {
  anatomy::Surface surface;
  anatomy::Grid grid;
};

// Distances of one skin from the other within reach, mm.
struct SkinDistances {
  double rms = 0.0, p95 = 0.0, most = 0.0;
};

// Fits a patient to a body of another shape, so that their skins coincide: first by a rigid motion (iterative closest
// points, Besl and McKay 1992; vtkIterativeClosestPointTransform), then by a thin-plate spline (Bookstein 1989;
// vtkThinPlateSplineTransform) through pairs of points of both skins. Tissue up to 80 mm below moves with the skin
// above it, so that its depth is kept; bone bends too.
class SkinFit {
 public:
  // `start`: body from patient, roughly. `middle`: LPS mm of the patient, about which the skins are fitted. Throws
  // InputError when fewer than 12 pairs of points are found.
  SkinFit(const Skin& patient, const Skin& body, const Pose& start, const Vec3& middle,
          const SkinFitSettings& settings);
  ~SkinFit();
  SkinFit(SkinFit&&) noexcept;
  SkinFit& operator=(SkinFit&&) noexcept;

  // The point of the patient at a place of the body.
  Vec3 to_patient(const Vec3& place) const;
  // The place in the body of a point of the patient.
  Vec3 to_body(const Vec3& place) const;

  const Pose& moved() const noexcept;  // body from patient, by the closest points
  std::size_t pairs() const noexcept;
  SkinDistances at_start() const noexcept;
  SkinDistances when_moved() const noexcept;
  SkinDistances when_bent() const noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace bodkin::patient
