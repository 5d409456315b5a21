#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "anatomy/acoustic_tissue.h"
#include "anatomy/case.h"
#include "core/large_pages.h"
#include "core/progress.h"

namespace bodkin::imaging {

// Impedance of soft tissue from its HU, MRayl: density by the fit to Schneider, Pedroni and Lomax 1996, speed by Mast
// 2000. Held between 0.0004 (air) and 8.
double impedance_of_hounsfield(double hounsfield);

// The acoustic properties of a patient, on the lattice of its tissues, so that only one array is read along a line.
struct AcousticVolume {
  static constexpr double unit = 1.0 / 4096.0;  // MRayl of one step of an impedance

  anatomy::Grid grid;
  // Voxel by voxel: the impedance in `unit`, 0 to 32767, that of the tissue, varied by the HU there; and from bit 16
  // on the tissue's id.
  LargePageVector<std::uint32_t> voxels;
  std::array<anatomy::AcousticTissue, 256> media;  // by tissue id
  std::array<double, 256> young{};  // MPa by tissue id, for tissue under the probe; 0 if the library has no value

  static std::uint32_t voxel(std::int16_t impedance, anatomy::TissueId id) noexcept {
    return static_cast<std::uint32_t>(impedance) | static_cast<std::uint32_t>(id) << 16;
  }
  std::int16_t impedance(std::size_t position) const noexcept {
    return static_cast<std::int16_t>(voxels[position] & 0xFFFFU);
  }
  anatomy::TissueId tissue(std::size_t position) const noexcept {
    return static_cast<anatomy::TissueId>(voxels[position] >> 16);
  }
};

// The acoustic volume of a case. Bone (cortical or cancellous) has its own impedance whatever its HU, and so have
// thin tissues invisible in CT (skin, ligaments, contents of the spinal canal) and tissues other than soft tissue;
// all others have their tissue's impedance plus, within 8 %, the difference by impedance_of_hounsfield between the
// voxel's HU, smoothed against the noise of the CT, and the tissue's typical HU. Throws InputError when the CT is not
// in HU or contains only air.
std::shared_ptr<const AcousticVolume> acoustic_volume(const anatomy::Case& patient, const Progress& progress);

}  // namespace bodkin::imaging
