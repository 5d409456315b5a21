#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "anatomy/volume.h"

namespace bodkin::io {

// Writes a volume as NRRD (gzip, little endian, LPS). Every number of the geometry is written with 17 digits, so
// reading the file gives the same grid: to the bit for axis-aligned grids, to 1e-12 for oblique ones (NRRD stores
// spacing times direction). Throws SystemError when the file cannot be written.
template <typename Voxel>
void write_nrrd(const anatomy::Volume<Voxel>& volume, const std::filesystem::path& file);

// The content of such a file: the same header, with faster but weaker compression.
template <typename Voxel>
std::vector<std::uint8_t> nrrd_bytes(const anatomy::Volume<Voxel>& volume);

extern template void write_nrrd(const anatomy::CtVolume& volume, const std::filesystem::path& file);
extern template void write_nrrd(const anatomy::LabelVolume& volume, const std::filesystem::path& file);
extern template void write_nrrd(const anatomy::TissueVolume& volume, const std::filesystem::path& file);
extern template std::vector<std::uint8_t> nrrd_bytes(const anatomy::LabelVolume& volume);
extern template std::vector<std::uint8_t> nrrd_bytes(const anatomy::TissueVolume& volume);

}  // namespace bodkin::io
