#pragma once

#include <string>
#include <vector>

#include "anatomy/volume.h"
#include "io/images/image_file.h"

namespace bodkin::io {

// Losses in the conversion of values to HU, accumulated over all voxels of an image.
struct HounsfieldLosses {
  double largest_rounding = 0.0;  // HU
  std::size_t padded = 0;         // voxels below -1024, the scanner's padding
  std::size_t too_high = 0;       // voxels above 32767
  std::size_t not_numbers = 0;    // voxels that are NaN or infinite

  std::vector<std::string> notes() const;  // one sentence each; empty when every value was kept
};

// A value as HU: rounded to a whole number, clamped to -1024 (air) and 32767; values that are not finite become
// -1024.
std::int16_t to_hounsfield(double value, HounsfieldLosses& losses);

// A CT from a file's voxels. Whole numbers in range are kept exactly.
anatomy::CtVolume to_ct(ImageFile&& image, std::vector<std::string>& notes);

// Labels or tissue ids from a file's voxels. Throws InputError naming `name` when a voxel is not a whole number from
// 0 to the maximum of the type.
anatomy::LabelVolume to_labels(ImageFile&& image, const std::string& name);
anatomy::TissueVolume to_tissues(ImageFile&& image, const std::string& name);
anatomy::LabelVolume to_labels(anatomy::CtVolume&& image, const std::string& name);

// Throws InputError naming `name` when the values cannot be HU: every body has fat below -50 HU or air at -1000, so
// an image without a voxel below -50 HU was windowed, scaled, or is not a CT.
void require_hounsfield(const anatomy::CtVolume& ct, const std::string& name);

}  // namespace bodkin::io
