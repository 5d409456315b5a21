#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "anatomy/case.h"
#include "imaging/slice.h"

namespace bodkin::views {

// Conversion of the voxels of a thick slice into one pixel.
enum class SlabKind { mean, maximum };

// The thickness of a slice, half of it before the plane and half behind. 0: the plane itself.
struct Slab {
  double thickness = 0.0;  // mm, 0 to 50
  SlabKind kind = SlabKind::mean;

  bool operator==(const Slab&) const = default;
};

// HU of every pixel of a plane, row by row: trilinear, NaN outside the CT. A slab is sampled at least every
// millimetre; samples outside the CT are ignored.
void sample_hounsfield(const imaging::SlicePlane& plane, const anatomy::CtVolume& ct, const Slab& slab,
                       std::vector<float>& hounsfield);

// As above, for a patient without a CT: the typical HU of each tissue.
void sample_typical_hounsfield(const imaging::SlicePlane& plane, const anatomy::TissueVolume& tissues,
                               const anatomy::TissueLibrary& library, std::vector<float>& hounsfield);

// The tissue's colour over a pixel: 0xAARRGGBB, premultiplied, as in QImage::Format_ARGB32_Premultiplied.
using Tint = std::uint32_t;

// The tint of each tissue on the grey image. Tissues that are clearly visible in CT (bone, fat, muscle, gas) have
// none, to emphasise those that are hard to distinguish. `opacity`: 0 to 1 of the others.
std::array<Tint, 256> tissue_tints(const std::array<std::uint32_t, 256>& colours, double opacity);

// The tint of every pixel of a plane, row by row: linear between voxels, so that borders are smooth. None outside.
void sample_tints(const imaging::SlicePlane& plane, const anatomy::TissueVolume& tissues,
                  const std::array<Tint, 256>& tints, std::vector<Tint>& pixels);

// Regions forbidden to a needle: cord, nerve and vessel, and the critical structures of the case.
class ForbiddenPlaces {
 public:
  explicit ForbiddenPlaces(const anatomy::Case& patient);
  // LPS mm.
  bool holds(const Vec3& point) const;

 private:
  const anatomy::Case& patient_;
  std::vector<bool> critical_;  // by structure label
};

// 1 for every pixel of a plane in a forbidden region, else 0, row by row. Two by two pixels share the position
// between them: this suffices for the coarser hatching.
void sample_forbidden(const imaging::SlicePlane& plane, const ForbiddenPlaces& places,
                      std::vector<std::uint8_t>& forbidden);

// The grey level, 0 to 255, of a value in a window: black at level - window / 2 and below. NaN is black.
std::uint8_t grey_of(double hounsfield, double window, double level);

}  // namespace bodkin::views
