#include "io/images/label_placement.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::io {
namespace {

constexpr double lattice_tolerance = 0.1;  // voxels: only the errors of single precision and rounded headers

// Index of a voxel of one lattice as a function of the index in another: matrix * index + offset.
struct IndexMap {
  Mat3 matrix;
  Vec3 offset;
};

IndexMap index_map(const anatomy::Grid& from, const anatomy::Grid& to) {
  const Mat3 per_voxel = to.spacing.cwiseInverse().asDiagonal() * to.direction.transpose();
  return {per_voxel * from.direction * from.spacing.asDiagonal(), per_voxel * (from.origin - to.origin)};
}

Vec3 corner_of(const anatomy::Grid& grid, int corner) {
  return {(corner & 1) != 0 ? grid.size[0] - 1.0 : 0.0, (corner & 2) != 0 ? grid.size[1] - 1.0 : 0.0,
          (corner & 4) != 0 ? grid.size[2] - 1.0 : 0.0};
}

// Largest distance, in target voxels, between the corners of a map and of its whole-number version.
double misfit(const IndexMap& map, const IndexMap& whole, const anatomy::Grid& from) {
  double worst = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 index = corner_of(from, corner);
    const Vec3 off = (map.matrix - whole.matrix) * index + map.offset - whole.offset;
    worst = std::max(worst, off.cwiseAbs().maxCoeff());
  }
  return worst;
}

// The nearest map that only permutes, flips and shifts whole voxels; its matrix may still fail to be a permutation.
IndexMap whole_map(const IndexMap& map, const anatomy::Grid& from) {
  IndexMap whole;
  whole.matrix = map.matrix.array().round();
  // The offset is rounded where it matters: at the middle of the image.
  const Vec3 middle = 0.5 * corner_of(from, 7);
  const Vec3 residue = map.matrix * middle + map.offset - whole.matrix * middle;
  whole.offset = residue.array().round();
  return whole;
}

bool permutes_axes(const Mat3& matrix) {
  return (matrix.cwiseAbs().colwise().sum().array() == 1.0).all() &&
         (matrix.cwiseAbs().rowwise().sum().array() == 1.0).all();
}

std::string describe(const anatomy::Grid& grid) {
  const Vec3 centre = grid.to_patient(0.5 * corner_of(grid, 7));
  return fmt::format("{} x {} x {} voxels of {:.4g} x {:.4g} x {:.4g} mm, axes {}, centre ({:.1f}, {:.1f}, {:.1f})",
                     grid.size[0], grid.size[1], grid.size[2], grid.spacing[0], grid.spacing[1], grid.spacing[2],
                     grid.axes(), centre.x(), centre.y(), centre.z());
}

// Copies labels by index. Returns the number of labelled voxels outside the CT.
std::size_t copy_by_index(const anatomy::LabelVolume& labels, const IndexMap& whole, anatomy::LabelVolume& result) {
  std::array<std::array<int, 3>, 3> step{};  // [axis of the CT][axis of the labels]
  std::array<int, 3> offset{};
  for (Eigen::Index row = 0; row < 3; ++row) {
    offset[static_cast<std::size_t>(row)] = static_cast<int>(whole.offset[row]);
    for (Eigen::Index column = 0; column < 3; ++column) {
      step[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
          static_cast<int>(whole.matrix(row, column));
    }
  }
  std::size_t outside = 0, position = 0;
  for (int k = 0; k < labels.grid.size[2]; ++k) {
    for (int j = 0; j < labels.grid.size[1]; ++j) {
      for (int i = 0; i < labels.grid.size[0]; ++i, ++position) {
        const std::uint16_t label = labels.voxels[position];
        if (label == 0) continue;
        std::array<int, 3> at{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          at[axis] = step[axis][0] * i + step[axis][1] * j + step[axis][2] * k + offset[axis];
        }
        if (result.grid.contains(at[0], at[1], at[2])) {
          result.at(at[0], at[1], at[2]) = label;
        } else {
          ++outside;
        }
      }
    }
  }
  return outside;
}

void copy_nearest(const anatomy::LabelVolume& labels, anatomy::LabelVolume& result) {
  const IndexMap map = index_map(result.grid, labels.grid);
  std::size_t position = 0;
  for (int k = 0; k < result.grid.size[2]; ++k) {
    for (int j = 0; j < result.grid.size[1]; ++j) {
      for (int i = 0; i < result.grid.size[0]; ++i, ++position) {
        const Vec3 index = map.matrix * Vec3(i, j, k) + map.offset;
        result.voxels[position] = anatomy::nearest_at_index(labels, index, std::uint16_t{0});
      }
    }
  }
}

std::size_t labelled(const anatomy::LabelVolume& labels) {
  return labels.voxels.size() -
         static_cast<std::size_t>(std::count(labels.voxels.begin(), labels.voxels.end(), std::uint16_t{0}));
}

}  // namespace

LabelPlacement place_labels(anatomy::LabelVolume&& labels, const anatomy::Grid& ct, bool resample,
                            const std::string& name) {
  LabelPlacement placed;
  if (labelled(labels) == 0) {
    throw InputError(
        fmt::format("{}: every voxel is 0, so nothing is labelled; give a segmentation of this CT", name));
  }
  const IndexMap map = index_map(labels.grid, ct);
  const IndexMap whole = whole_map(map, labels.grid);
  const double off = misfit(map, whole, labels.grid);
  const bool same_lattice_points = permutes_axes(whole.matrix) && off <= lattice_tolerance;
  if (same_lattice_points && whole.matrix == Mat3::Identity() && whole.offset.isZero() &&
      labels.grid.size == ct.size) {
    placed.labels.grid = ct;
    placed.labels.voxels = std::move(labels.voxels);
    return placed;
  }

  placed.labels = anatomy::LabelVolume(ct);
  if (same_lattice_points) {
    const std::size_t outside = copy_by_index(labels, whole, placed.labels);
    if (outside > 0) {
      placed.notes.push_back(fmt::format("Labels outside the CT (voxels: {}) were left out.", outside));
    }
  } else if (resample) {
    copy_nearest(labels, placed.labels);
    placed.notes.push_back("The labels lie on another lattice than the CT; each CT voxel took the nearest label.");
  } else {
    const std::string how_far =
        permutes_axes(whole.matrix) ? fmt::format(" (its voxels lie up to {:.2f} voxels off the CT's)", off) : "";
    throw InputError(
        fmt::format("{}: the labels do not lie on the CT's voxels{}: they are {}, the CT is {}; give the labels "
                    "of this CT, or say --resample-labels to take the nearest label at each CT voxel",
                    name, how_far, describe(labels.grid), describe(ct)));
  }
  if (labelled(placed.labels) == 0) {
    throw InputError(
        fmt::format("{}: no labelled voxel lies inside the CT: the labels are {}, the CT is {}; give the "
                    "labels of this CT",
                    name, describe(labels.grid), describe(ct)));
  }
  return placed;
}

}  // namespace bodkin::io
