#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "anatomy/volume.h"
#include "io/image_grid.h"

namespace bodkin::io {

// Voxels in the type stored in the file, i fastest.
using VoxelBuffer =
    std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                 std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                 std::vector<std::int64_t>, std::vector<std::uint64_t>, std::vector<float>, std::vector<double>>;

struct ImageFile {
  anatomy::Grid grid;
  VoxelBuffer voxels;
};

// Reads one NIfTI, NRRD or MetaImage file: three-dimensional (or four with a single frame), one number per voxel. The
// geometry is kept exactly, cleaned of rounding noise (clean_grid). Throws InputError, one sentence, before it
// allocates memory for voxels that the file cannot contain.
ImageFile read_image_file(const std::filesystem::path& file);

}  // namespace bodkin::io
