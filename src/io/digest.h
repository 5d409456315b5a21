#pragma once

#include <string>
#include <string_view>

#include "anatomy/volume.h"

namespace bodkin::io {

// A fingerprint of an image: XXH3, 128 bits, as 32 hexadecimal digits. It covers the bytes of the voxels and the
// grid. Coordinates enter rounded to single precision, so that the last bits of a double, which a file format may not
// keep, do not change it. It finds accidents, not attacks.
template <typename Voxel>
std::string volume_digest(const anatomy::Volume<Voxel>& volume);

extern template std::string volume_digest(const anatomy::CtVolume& volume);
extern template std::string volume_digest(const anatomy::LabelVolume& volume);
extern template std::string volume_digest(const anatomy::TissueVolume& volume);

// The same of any bytes.
std::string bytes_digest(std::string_view bytes);

}  // namespace bodkin::io
