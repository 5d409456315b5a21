#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "anatomy/case.h"
#include "core/progress.h"

namespace bodkin::imaging {

// A patient as rays are cast through it: HU, tissues and gradients on one lattice, with a border of one voxel on
// every side that repeats the outermost ones, so that no ray asks whether a neighbour exists.
struct PreparedVolume {
  struct Range {
    std::int16_t least = 0, most = 0;  // HU
  };

  anatomy::Grid grid;         // without the border
  std::array<int, 3> size{};  // with it: voxels along i, j, k
  std::vector<std::int16_t> hounsfield;
  std::vector<anatomy::TissueId> tissues;
  // HU/mm along i, j, k, compressed to a byte each: see gradient_byte(). The fourth is unused.
  std::vector<std::array<std::int8_t, 4>> gradients;

  static constexpr int block = 8;  // voxels along each side
  std::array<int, 3> blocks{};     // along i, j, k
  std::vector<Range> ranges;       // of all voxels that samples within a block can meet

  std::array<std::uint32_t, 256> histogram{};  // voxels in each 16 HU from -1024 on
  // mm of water that take as much of an X-ray as the patient does where he is thickest, from the front or the side.
  double thickest = 1.0;

  // LPS mm to the index with the border.
  Vec3 to_index(const Vec3& point) const { return grid.to_index(point) + Vec3::Ones(); }
};

// The direction is kept, a size g becomes 127 g / (g + 60 HU/mm): edges of weak contrast keep a direction too.
std::array<std::int8_t, 4> gradient_byte(const Eigen::Vector3f& gradient);

// The HU are those of `ct`; without one, those that are typical of each tissue. A volume of more than `most_voxels`
// is made coarser by a whole number along its finest axes. Throws InputError when there is neither CT nor tissues.
PreparedVolume prepare_volume(const anatomy::CtVolume& ct, const anatomy::TissueVolume& tissues,
                              const anatomy::TissueLibrary& library, std::size_t most_voxels = std::size_t{1} << 25U,
                              const Progress& progress = {});

}  // namespace bodkin::imaging
