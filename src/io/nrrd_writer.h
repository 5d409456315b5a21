#pragma once

#include <filesystem>

#include "anatomy/volume.h"

namespace bodkin {

// Writes a volume as NRRD (gzip, little endian, LPS). Every number of the geometry is written with 17 digits, so
// reading the file gives the same grid: to the bit for axis-aligned grids, to 1e-12 for oblique ones (NRRD stores
// spacing times direction). Throws SystemError when the file cannot be written.
template <typename Voxel>
void write_nrrd(const Volume<Voxel>& volume, const std::filesystem::path& file);

extern template void write_nrrd(const CtVolume& volume, const std::filesystem::path& file);
extern template void write_nrrd(const LabelVolume& volume, const std::filesystem::path& file);
extern template void write_nrrd(const TissueVolume& volume, const std::filesystem::path& file);

}  // namespace bodkin
