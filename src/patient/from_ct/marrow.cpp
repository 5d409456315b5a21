#include "patient/from_ct/marrow.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/parallel_for.h"

namespace bodkin::patient {
namespace {

constexpr double half_breadth = 14.0;   // mm about the midline
constexpr double largest_area = 400.0;  // mm^2

// One sagittal section, j to the right and k upwards; 1 where the mask is set.
struct MarrowSection {
  int width, height;
  std::vector<std::uint8_t> cells;
  bool inside(int j, int k) const { return j >= 0 && k >= 0 && j < width && k < height; }
  std::uint8_t& at(int j, int k) {
    return cells[static_cast<std::size_t>(k) * static_cast<std::size_t>(width) + static_cast<std::size_t>(j)];
  }
  std::uint8_t at(int j, int k) const {
    return cells[static_cast<std::size_t>(k) * static_cast<std::size_t>(width) + static_cast<std::size_t>(j)];
  }
};

MarrowSection widened(const MarrowSection& section) {
  MarrowSection out = section;
  for (int k = 0; k < section.height; ++k) {
    for (int j = 0; j < section.width; ++j) {
      for (int n = 0; n < 9 && out.at(j, k) == 0; ++n) {
        const int dj = n % 3 - 1, dk = n / 3 - 1;
        if (section.inside(j + dj, k + dk) && section.at(j + dj, k + dk) != 0) out.at(j, k) = 1;
      }
    }
  }
  return out;
}

// The holes of a section: free cells that are not connected to its border through free cells, unless they cover more
// than `most`.
MarrowSection holes_of(const MarrowSection& walls, double most) {
  MarrowSection seen = walls, holes = walls;
  std::fill(holes.cells.begin(), holes.cells.end(), std::uint8_t{0});
  std::vector<std::pair<int, int>> piece;
  for (int k = 0; k < walls.height; ++k) {
    for (int j = 0; j < walls.width; ++j) {
      if (seen.at(j, k) != 0) continue;
      piece.assign(1, {j, k});
      seen.at(j, k) = 1;
      bool open = false;
      for (std::size_t n = 0; n < piece.size(); ++n) {
        const auto [a, b] = piece[n];
        static constexpr std::array<std::pair<int, int>, 4> steps = {{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
        for (const auto& [da, db] : steps) {
          if (!walls.inside(a + da, b + db)) {
            open = true;
          } else if (seen.at(a + da, b + db) == 0) {
            seen.at(a + da, b + db) = 1;
            piece.emplace_back(a + da, b + db);
          }
        }
      }
      if (open || static_cast<double>(piece.size()) > most) continue;
      for (const auto& [a, b] : piece) holes.at(a, b) = 1;
    }
  }
  return holes;
}

}  // namespace

void fill_marrow(SpineView& view, anatomy::TissueVolume& tissues, const SpinalCanal& canal) {
  const auto& size = view.grid().size;
  const double x = canal.at(0.5 * (canal.lowest + canal.highest())).x;
  MaskVolume marrow(view.grid());
  for (int i = std::max(0, view.i_of(x - half_breadth)); i <= std::min(size[0] - 1, view.i_of(x + half_breadth));
       ++i) {
    MarrowSection bone{size[1], size[2], {}};
    bone.cells.resize(static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]));
    for (int k = 0; k < size[2]; ++k) {
      for (int j = 0; j < size[1]; ++j) bone.at(j, k) = view.bone.at(i, j, k);
    }
    const double cell = view.grid().spacing.y() * view.grid().spacing.z();
    const MarrowSection holes = widened(holes_of(widened(bone), largest_area / cell));
    for (int k = 0; k < size[2]; ++k) {
      const double back = canal.at(view.z_of(k)).back;
      for (int j = 0; j < size[1]; ++j) {
        if (holes.at(j, k) == 0 || bone.at(j, k) != 0 || view.y_of(j) < back) continue;
        marrow.at(i, j, k) = view.bone.at(i, j, k) = 1;
      }
    }
  }
  const anatomy::Grid& grid = tissues.grid;
  parallel_for(grid.size[2], [&](int k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      anatomy::TissueId* row = &tissues.at(0, j, k);
      for (int i = 0; i < grid.size[0]; ++i) {
        if (row[i] != anatomy::tissue::muscle && row[i] != anatomy::tissue::soft && row[i] != anatomy::tissue::fat)
          continue;
        if (anatomy::nearest(marrow, grid.to_patient(Vec3(i, j, k)), std::uint8_t{0}) != 0)
          row[i] = anatomy::tissue::cancellous_bone;
      }
    }
  });
}

}  // namespace bodkin::patient
