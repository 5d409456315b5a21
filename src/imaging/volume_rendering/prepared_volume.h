#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "anatomy/case.h"
#include "core/large_pages.h"
#include "core/progress.h"

namespace bodkin::imaging {

// A patient prepared for ray casting: HU, tissues and gradients on one lattice, with a border of one voxel on every
// side that repeats the outermost ones, so that rays need not check whether a neighbour exists. HU and gradients are
// stored in bricks: those of one block of voxels and of the neighbours behind it are contiguous, so a ray in any
// direction mostly reads near its previous reads.
struct PreparedVolume {
  struct Range {
    std::int16_t least = 0, most = 0;  // HU
  };

  anatomy::Grid grid;                        // without the border
  std::array<int, 3> size{};                 // with the border: voxels along i, j, k
  LargePageVector<std::int16_t> hounsfield;  // see offset()
  std::vector<anatomy::TissueId> tissues;    // row by row
  // HU/mm along i, j, k, compressed to a byte each: see gradient_byte(). The fourth is unused. See offset().
  LargePageVector<std::array<std::int8_t, 4>> gradients;

  static constexpr int block = 8;                    // voxels along each side
  static constexpr int brick_side = block + 1;       // with the first voxels of the next blocks
  static constexpr std::ptrdiff_t brick_size = 736;  // voxels: brick_side^3, up to a whole number of cache lines
  std::array<int, 3> blocks{};                       // along i, j, k
  std::vector<Range> ranges;                         // of all voxels that samples within a block can use

  std::array<std::uint32_t, 256> histogram{};  // voxels in each 16 HU from -1024 on
  // mm of water with the X-ray attenuation of the patient's thickest part, from the front or the side.
  double thickest = 1.0;

  // Position of a voxel in `hounsfield` and `gradients`; index with the border. That of its neighbour along i, j or k
  // is 1, brick_side or brick_side^2 more.
  std::size_t offset(int i, int j, int k) const {
    const int in_order = (k / block * blocks[1] + j / block) * blocks[0] + i / block;
    const int within = (k % block * brick_side + j % block) * brick_side + i % block;
    return static_cast<std::size_t>(in_order * brick_size + within);
  }
  // LPS mm to the index with the border.
  Vec3 to_index(const Vec3& point) const { return grid.to_index(point) + Vec3::Ones(); }
};

// The direction is kept, a magnitude g becomes 127 g / (g + 60 HU/mm), so that edges of weak contrast keep a
// direction too.
std::array<std::int8_t, 4> gradient_byte(const Eigen::Vector3f& gradient);

// The HU are those of `ct`; without one, the typical ones of each tissue. A volume of more than `most_voxels` is
// coarsened by a whole number along its finest axes. Throws InputError when there is neither CT nor tissues.
PreparedVolume prepare_volume(const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues,
                              const anatomy::TissueLibrary& library, std::size_t most_voxels = std::size_t{1} << 25U,
                              const Progress& progress = {});

}  // namespace bodkin::imaging
