#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "anatomy/case.h"
#include "imaging/slice.h"

namespace bodkin::views {

// How the voxels of a thick slice become one pixel.
enum class SlabKind { mean, maximum };

// The thickness of a slice, half of it before the plane and half behind. 0: the plane itself.
struct Slab {
  double thickness = 0.0;  // mm, 0 to 50
  SlabKind kind = SlabKind::mean;

  bool operator==(const Slab&) const = default;
};

// HU of every pixel of a plane, row by row: trilinear, NaN outside the CT. A slab is sampled at least every
// millimetre; samples outside the CT do not count.
void sample_hounsfield(const imaging::SlicePlane& plane, const anatomy::CtVolume& ct, const Slab& slab,
                       std::vector<float>& hounsfield);

// The same for a patient without a CT: the HU that is typical of each tissue.
void sample_typical_hounsfield(const imaging::SlicePlane& plane, const anatomy::TissueVolume& tissues,
                               const anatomy::TissueLibrary& library, std::vector<float>& hounsfield);

// The tissue's colour over a pixel: 0xAARRGGBB, premultiplied, as QImage::Format_ARGB32_Premultiplied has it.
using Tint = std::uint32_t;

// What each tissue adds to the grey picture. Tissues that a CT shows well by itself (bone, fat, muscle, gas) add
// nothing, so that what is hard to tell apart stands out. `opacity`: 0 to 1 of the others.
std::array<Tint, 256> tissue_tints(const std::array<std::uint32_t, 256>& colours, double opacity);

// The tint of every pixel of a plane, row by row: linear between voxels, so that borders are smooth. None outside.
void sample_tints(const imaging::SlicePlane& plane, const anatomy::TissueVolume& tissues,
                  const std::array<Tint, 256>& tints, std::vector<Tint>& pixels);

// Where a needle must not go: cord, nerve and vessel, and the structures that the case calls critical.
class ForbiddenPlaces {
 public:
  explicit ForbiddenPlaces(const anatomy::Case& patient);
  // LPS mm.
  bool holds(const Vec3& point) const;

 private:
  const anatomy::Case& patient_;
  std::vector<bool> critical_;  // by structure label
};

// 1 for every pixel of a plane that lies where a needle must not go, else 0, row by row. Two by two pixels share the
// place between them: it is for a hatch that is coarser.
void sample_forbidden(const imaging::SlicePlane& plane, const ForbiddenPlaces& places,
                      std::vector<std::uint8_t>& forbidden);

// The grey, 0 to 255, that a window shows for a value: black at level - window / 2 and below. NaN is black.
std::uint8_t grey_of(double hounsfield, double window, double level);

}  // namespace bodkin::views
