#include "anatomy/tissue_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "core/settings_check.h"

namespace bodkin::anatomy {
namespace {

constexpr float half = 0.5F;
constexpr int margin = 2;  // empty cells around the region, so that its surface closes

std::size_t axis_index(int axis) {
  return static_cast<std::size_t>(axis);
}

// Fraction of each block of voxels in the region, with a margin of zeros.
Volume<float> shares(const TissueVolume& tissues, const TissueSet& region, double edge) {
  const Grid& fine = tissues.grid;
  std::array<int, 3> block{};
  Grid grid = fine;
  Vec3 first;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t a = axis_index(axis);
    block[a] = std::max(1, static_cast<int>(std::lround(edge / fine.spacing[axis])));
    grid.size[a] = (fine.size[a] + block[a] - 1) / block[a] + 2 * margin;
    grid.spacing[axis] = fine.spacing[axis] * block[a];
    first[axis] = 0.5 * (block[a] - 1) - margin * block[a];
  }
  grid.origin = fine.to_patient(first);
  Volume<float> share(grid);
  const float one = 1.0F / static_cast<float>(block[0] * block[1] * block[2]);
  for (int k = 0; k < fine.size[2]; ++k) {
    for (int j = 0; j < fine.size[1]; ++j) {
      for (int i = 0; i < fine.size[0]; ++i) {
        if (!region[tissues.at(i, j, k)]) continue;
        share.at(i / block[0] + margin, j / block[1] + margin, k / block[2] + margin) += one;
      }
    }
  }
  return share;
}

// Filters of weights a, 1 - 2 a, a along each axis, a at most 1/4; each adds 2 a cells squared to the variance.
void smooth(Volume<float>& share, double sigma) {
  std::array<std::size_t, 3> stride = {1, axis_index(share.grid.size[0]),
                                       axis_index(share.grid.size[0]) * axis_index(share.grid.size[1])};
  std::vector<float> row;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t length = axis_index(share.grid.size[axis_index(axis)]), step = stride[axis_index(axis)];
    const double cells = sigma / share.grid.spacing[axis];
    const int passes = static_cast<int>(std::ceil(2.0 * cells * cells));
    const auto weight = static_cast<float>(0.5 * cells * cells / std::max(1, passes));
    row.assign(length + 2, 0.0F);
    for (std::size_t line = 0; line < share.voxels.size() / length && passes > 0; ++line) {
      const std::size_t start = line / step * step * length + line % step;
      for (std::size_t i = 0; i < length; ++i) row[i + 1] = share.voxels[start + i * step];
      for (int pass = 0; pass < passes; ++pass) {
        float before = 0.0F;
        for (std::size_t i = 1; i <= length; ++i) {
          const float here = row[i];
          row[i] = here + weight * (before - 2.0F * here + row[i + 1]);
          before = here;
        }
      }
      for (std::size_t i = 0; i < length; ++i) share.voxels[start + i * step] = row[i + 1];
    }
  }
}

// Bit c of a cell's pattern: corner (c & 1, c >> 1 & 1, c >> 2 & 1) is inside.
int pattern(const Volume<float>& share, int i, int j, int k) {
  int bits = 0;
  for (int c = 0; c < 8; ++c) {
    if (share.at(i + (c & 1), j + ((c >> 1) & 1), k + ((c >> 2) & 1)) >= half) bits |= 1 << c;
  }
  return bits;
}

// For each pattern the corners to fill where inside or outside touches itself only across a face or through the cell.
// They lie within the box around the inside, so that filling never spreads into the margin.
std::array<int, 256> fillings() {
  std::array<int, 256> filling{};
  for (int bits = 0; bits < 256; ++bits) {
    int& fill = filling[static_cast<std::size_t>(bits)];
    const auto in = [bits](int corner) { return ((bits >> corner) & 1) != 0; };
    for (int axis = 0; axis < 3; ++axis) {
      const int u = 1 << ((axis + 1) % 3), v = 1 << ((axis + 2) % 3);
      for (const int base : {0, 1 << axis}) {
        const bool diagonal =
            in(base) == in(base + u + v) && in(base + u) == in(base + v) && in(base) != in(base + u);
        if (diagonal) fill |= (1 << base) | (1 << (base + u)) | (1 << (base + v)) | (1 << (base + u + v));
      }
    }
    for (int corner = 0; corner < 4; ++corner) {
      const int two = (1 << corner) | (1 << (7 - corner));
      if (bits == two || bits == (255 ^ two)) fill = 255;
    }
  }
  return filling;
}

template <typename Visit>
void for_each_cell(const Grid& grid, const Visit& visit) {
  for (int k = 0; k + 1 < grid.size[2]; ++k) {
    for (int j = 0; j + 1 < grid.size[1]; ++j) {
      for (int i = 0; i + 1 < grid.size[0]; ++i) visit(i, j, k);
    }
  }
}

void fill_touching_cells(Volume<float>& share) {
  static const std::array<int, 256> filling = fillings();
  constexpr float filled = 0.75F;
  bool changed = true;
  while (changed) {  // terminates: cells are only ever filled
    changed = false;
    for_each_cell(share.grid, [&](int i, int j, int k) {
      const int fill = filling[static_cast<std::size_t>(pattern(share, i, j, k))];
      for (int c = 0; c < 8 && fill != 0; ++c) {
        float& corner = share.at(i + (c & 1), j + ((c >> 1) & 1), k + ((c >> 2) & 1));
        if (((fill >> c) & 1) == 0 || corner >= half) continue;
        corner = filled;
        changed = true;
      }
    });
  }
}

// Mean of the places where the edges of a mixed cell cross one half; continuous index.
Vec3 net_vertex(const Volume<float>& share, int i, int j, int k) {
  Vec3 sum = Vec3::Zero();
  double crossings = 0.0;
  for (int c = 0; c < 8; ++c) {
    for (int axis = 0; axis < 3; ++axis) {
      if ((c & (1 << axis)) != 0) continue;
      const int d = c | (1 << axis);
      const double from = share.at(i + (c & 1), j + ((c >> 1) & 1), k + ((c >> 2) & 1));
      const double to = share.at(i + (d & 1), j + ((d >> 1) & 1), k + ((d >> 2) & 1));
      if ((from >= half) == (to >= half)) continue;
      Vec3 place(c & 1, (c >> 1) & 1, (c >> 2) & 1);
      place[axis] = std::clamp((half - from) / (to - from), 0.01, 0.99);  // vertices of two cells never meet
      sum += place;
      crossings += 1.0;
    }
  }
  return Vec3(i, j, k) + sum / crossings;
}

// The four cells around each mixed edge of the lattice give two triangles.
std::vector<std::array<int, 3>> net_triangles(const Volume<float>& share, const std::vector<int>& vertex_of,
                                              const std::vector<Vec3>& vertices) {
  const Grid& grid = share.grid;
  const bool mirrored = grid.direction.determinant() < 0.0;
  std::vector<std::array<int, 3>> triangles;
  const auto at = [&](int v) -> const Vec3& { return vertices[static_cast<std::size_t>(v)]; };
  for_each_cell(grid, [&](int i, int j, int k) {
    const std::array<int, 3> here = {i, j, k};
    const bool inside = share.at(i, j, k) >= half;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      if (here[u] == 0 || here[v] == 0) continue;
      std::array<int, 3> next = here;
      ++next[axis];
      if ((share.at(next[0], next[1], next[2]) >= half) == inside) continue;
      std::array<int, 4> quad{};  // around the axis, right-handed
      for (std::size_t corner = 0; corner < 4; ++corner) {
        std::array<int, 3> cell = here;
        cell[u] -= corner == 0 || corner == 3 ? 1 : 0;
        cell[v] -= corner < 2 ? 1 : 0;
        quad[corner] = vertex_of[grid.offset(cell[0], cell[1], cell[2])];
      }
      if (inside == mirrored) std::swap(quad[1], quad[3]);
      if ((at(quad[0]) - at(quad[2])).squaredNorm() <= (at(quad[1]) - at(quad[3])).squaredNorm()) {
        triangles.push_back({quad[0], quad[1], quad[2]});
        triangles.push_back({quad[0], quad[2], quad[3]});
      } else {
        triangles.push_back({quad[0], quad[1], quad[3]});
        triangles.push_back({quad[1], quad[2], quad[3]});
      }
    }
  });
  return triangles;
}

}  // namespace

TissueSet body_tissues() {
  TissueSet tissues;
  tissues.set();
  tissues.reset(tissue::air);
  return tissues;
}

TissueSet bone_tissues() {
  TissueSet tissues;
  tissues.set(tissue::cortical_bone);
  tissues.set(tissue::cancellous_bone);
  return tissues;
}

Surface tissue_surface(const TissueVolume& tissues, const TissueSet& region, const TissueSurfaceSettings& settings) {
  check_range("tissue surface", "edge", settings.edge, {0.2, 20.0}, "mm");
  check_range("tissue surface", "smoothing", settings.smoothing, {0.0, 10.0}, "mm");
  if (tissues.empty()) throw InputError("tissue surface: the tissue map is empty; give that of a patient");
  Volume<float> share = shares(tissues, region, settings.edge);
  smooth(share, settings.smoothing);
  fill_touching_cells(share);
  std::vector<Vec3> vertices;
  std::vector<int> vertex_of(share.voxels.size(), -1);
  for_each_cell(share.grid, [&](int i, int j, int k) {
    const int bits = pattern(share, i, j, k);
    if (bits == 0 || bits == 255) return;
    vertex_of[share.grid.offset(i, j, k)] = static_cast<int>(vertices.size());
    vertices.push_back(share.grid.to_patient(net_vertex(share, i, j, k)));
  });
  if (vertices.empty()) {
    throw InputError(
        "tissue surface: none of the wished tissues is left at this edge and smoothing; choose tissues that the "
        "patient has, or take edge and smoothing smaller");
  }
  std::vector<std::array<int, 3>> triangles = net_triangles(share, vertex_of, vertices);
  return Surface(std::move(vertices), std::move(triangles));
}

}  // namespace bodkin::anatomy
