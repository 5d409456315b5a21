#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "anatomy/volume.h"

namespace bodkin {

// Voxels in the type that the file stores, i fastest.
using VoxelBuffer =
    std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                 std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                 std::vector<std::int64_t>, std::vector<std::uint64_t>, std::vector<float>, std::vector<double>>;

struct ImageFile {
  Grid grid;
  VoxelBuffer voxels;
};

// The most voxels an image may have: 800 x 800 x 800.
inline constexpr std::uintmax_t most_voxels = 512'000'000;

// Throws InputError when an image of this size is empty, absurd, or larger than `limit_bytes`, the most that the
// bytes of its file can hold. `sizes` are the declared numbers of voxels along each axis.
void require_plausible_size(const std::string& name, const std::vector<std::uintmax_t>& sizes,
                            std::uintmax_t voxel_bytes, double limit_bytes);

// Reads one NIfTI, NRRD or MetaImage file: three-dimensional (or four with a single frame), one number a voxel. The
// geometry is carried exactly; only rounding noise is removed: a direction cosine within 1e-6 of 0 or +-1 becomes it,
// and axes that are orthogonal to 1e-4 (a NIfTI affine has single precision) are made orthonormal to double
// precision. Throws InputError, one sentence, before it takes memory for voxels that the file cannot hold.
ImageFile read_image_file(const std::filesystem::path& file);

// A lattice cleaned of rounding noise as above. Throws InputError naming `name` when spacing, origin or direction is
// not a lattice's: zero, negative or not finite, or sheared.
Grid clean_grid(const Grid& grid, const std::string& name);

}  // namespace bodkin
