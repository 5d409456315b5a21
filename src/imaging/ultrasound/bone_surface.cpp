#include "imaging/ultrasound/bone_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace bodkin::imaging {

namespace {

constexpr int least_of_tissue = 410;  // AcousticVolume::unit, 0.1 MRayl: below it is gas

// Sharpening of the fraction of bone around a voxel: at 2 the voxels on both sides of a flat surface along the
// lattice, whose fractions are 3/4 and 1/4, become bone and not bone.
constexpr double steeper = 2.0;

// Weighted, of impedances.
struct Mean {
  double sum = 0.0, weights = 0.0;

  void add(int impedance, int weight) {
    sum += static_cast<double>(weight) * impedance;
    weights += weight;
  }
  double value() const { return sum / weights; }
};

struct Neighbour {
  std::array<int, 3> step;
  int weight = 0;
};

// The voxels around one, including itself.
std::vector<Neighbour> neighbours_of(const anatomy::Grid& grid) {
  std::array<int, 3> reach{};
  for (int axis = 0; axis < 3; ++axis)
    reach[static_cast<std::size_t>(axis)] = grid.spacing[axis] <= 1.5 * grid.spacing.minCoeff() ? 1 : 0;
  std::vector<Neighbour> neighbours;
  for (int k = -reach[2]; k <= reach[2]; ++k) {
    for (int j = -reach[1]; j <= reach[1]; ++j) {
      for (int i = -reach[0]; i <= reach[0]; ++i)
        neighbours.push_back({{i, j, k}, (2 - std::abs(i)) * (2 - std::abs(j)) * (2 - std::abs(k))});
    }
  }
  return neighbours;
}

bool of_bone(anatomy::TissueId id) {
  return id == anatomy::tissue::cortical_bone || id == anatomy::tissue::cancellous_bone;
}

// Calls `visit(position, weight)` for every neighbour within the volume.
template <typename Visit>
void around(const anatomy::Grid& grid, const std::vector<Neighbour>& neighbours, const std::array<int, 3>& at,
            Visit&& visit) {
  for (const Neighbour& neighbour : neighbours) {
    const int i = at[0] + neighbour.step[0], j = at[1] + neighbour.step[1], k = at[2] + neighbour.step[2];
    if (grid.contains(i, j, k)) visit(grid.offset(i, j, k), neighbour.weight);
  }
}

std::array<int, 3> index_of(const anatomy::Grid& grid, std::size_t position) {
  const auto row = static_cast<std::size_t>(grid.size[0]), column = static_cast<std::size_t>(grid.size[1]);
  return {static_cast<int>(position % row), static_cast<int>(position / row % column),
          static_cast<int>(position / (row * column))};
}

// Bone voxels with a neighbour of another kind, and those neighbours; in order.
std::vector<std::size_t> border_of_bone(const AcousticVolume& volume, const std::vector<Neighbour>& neighbours) {
  std::vector<std::size_t> border;
  for (std::size_t position = 0; position < volume.voxels.size(); ++position) {
    if (!of_bone(volume.tissue(position))) continue;
    const std::size_t before = border.size();
    around(volume.grid, neighbours, index_of(volume.grid, position), [&](std::size_t at, int /*weight*/) {
      if (!of_bone(volume.tissue(at))) border.push_back(at);
    });
    if (border.size() > before) border.push_back(position);
  }
  std::sort(border.begin(), border.end());
  border.erase(std::unique(border.begin(), border.end()), border.end());
  return border;
}

}  // namespace

void smooth_bone_surface(AcousticVolume& volume) {
  const std::vector<Neighbour> neighbours = neighbours_of(volume.grid);
  const std::vector<std::size_t> border = border_of_bone(volume, neighbours);
  std::vector<std::int16_t> smooth(border.size());
  for (std::size_t n = 0; n < border.size(); ++n) {
    Mean bone, soft;
    around(volume.grid, neighbours, index_of(volume.grid, border[n]), [&](std::size_t at, int weight) {
      const int impedance = volume.impedance(at);
      if (impedance >= least_of_tissue) (of_bone(volume.tissue(at)) ? bone : soft).add(impedance, weight);
    });
    const std::int16_t own = volume.impedance(border[n]);
    const double share = bone.weights / std::max(1.0, bone.weights + soft.weights);
    const double sharp = std::clamp(0.5 + steeper * (share - 0.5), 0.0, 1.0);
    const bool mixed = own >= least_of_tissue && bone.weights > 0.0 && soft.weights > 0.0;
    smooth[n] =
        !mixed ? own : static_cast<std::int16_t>(std::lround(soft.value() + sharp * (bone.value() - soft.value())));
  }
  for (std::size_t n = 0; n < border.size(); ++n)
    volume.voxels[border[n]] = AcousticVolume::voxel(smooth[n], volume.tissue(border[n]));
}

}  // namespace bodkin::imaging
