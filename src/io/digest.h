#pragma once

#include <string>
#include <string_view>

#include "anatomy/volume.h"

namespace bodkin::io {

// A digest of an image: XXH3, 128 bits, as 32 hexadecimal digits. It covers the bytes of the voxels and the grid.
// Coordinates are rounded to single precision, so that the last bits of a double, which a file format may lose, do
// not change it. It detects accidents, not attacks.
template <typename Voxel>
std::string volume_digest(const anatomy::Volume<Voxel>& volume);

extern template std::string volume_digest(const anatomy::CtVolume& volume);
extern template std::string volume_digest(const anatomy::LabelVolume& volume);
extern template std::string volume_digest(const anatomy::TissueVolume& volume);

// A digest of any bytes.
std::string bytes_digest(std::string_view bytes);

}  // namespace bodkin::io
