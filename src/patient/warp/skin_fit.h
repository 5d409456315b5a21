#pragma once

#include <memory>
#include <vector>

#include "anatomy/grid.h"
#include "anatomy/surface.h"
#include "core/geometry.h"

namespace bodkin::patient {

// [D] our choices.
struct SkinFitSettings {
  double reach = 120.0;   // mm around the middle within which skin is laid on skin; 30 to 500
  double spacing = 15.0;  // mm between the points that are brought together; 5 to 60
};

// Throws InputError naming the first number out of range.
void check(const SkinFitSettings& settings);

// A skin, and the lattice of the volume that it was drawn from: where that ends, the surface is a lid and no skin.
struct Skin {
  anatomy::Surface surface;
  anatomy::Grid grid;
};

// Distances of the one skin from the other within reach, mm.
struct SkinDistances {
  double rms = 0.0, p95 = 0.0, most = 0.0;
};

// A patient laid upon a body of another shape, so that skin lies on skin: first moved as it is (iterative closest
// points, Besl and McKay 1992; vtkIterativeClosestPointTransform), then bent by a thin-plate spline (Bookstein 1989;
// vtkThinPlateSplineTransform) through pairs of points of both skins. What lies up to 80 mm below moves with the skin
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

  // What is at a place of the body, in the patient.
  Vec3 to_patient(const Vec3& place) const;
  // Where a place of the patient comes to lie.
  Vec3 to_body(const Vec3& place) const;

  const Pose& moved() const noexcept;  // body from patient, as the closest points have it
  std::size_t pairs() const noexcept;
  SkinDistances at_start() const noexcept;
  SkinDistances when_moved() const noexcept;
  SkinDistances when_bent() const noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace bodkin::patient
