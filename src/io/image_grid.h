#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "anatomy/grid.h"

namespace bodkin::io {

// The largest number of voxels of an image: 800 x 800 x 800.
inline constexpr std::uintmax_t most_voxels = 512'000'000;

// Throws InputError when an image of this size is empty, implausible, or larger than `limit_bytes`, the capacity of
// its file. `sizes` are the declared numbers of voxels along each axis.
void require_plausible_size(const std::string& name, const std::vector<std::uintmax_t>& sizes,
                            std::uintmax_t voxel_bytes, double limit_bytes);

// The lattice declared by a file, cleaned of rounding noise: a direction cosine within 1e-6 of 0 or +-1 is rounded to
// it, and axes that are orthogonal to 1e-4 (a NIfTI affine has single precision) are made orthonormal to double
// precision. Everything else is kept to the bit. Throws InputError naming `name` when spacing, origin or direction is
// invalid: zero, negative or not finite, or sheared.
anatomy::Grid clean_grid(const anatomy::Grid& grid, const std::string& name);

}  // namespace bodkin::io
