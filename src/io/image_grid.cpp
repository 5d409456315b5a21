#include "io/image_grid.h"

#include <Eigen/SVD>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"

namespace bodkin::io {

void require_plausible_size(const std::string& name, const std::vector<std::uintmax_t>& sizes,
                            std::uintmax_t voxel_bytes, double limit_bytes) {
  double voxels = 1.0;
  for (const std::uintmax_t size : sizes) voxels *= static_cast<double>(size);
  const std::string shape = fmt::format("{}", fmt::join(sizes, " x "));
  if (voxels < 1.0) throw InputError(fmt::format("{}: the image has {} voxels; expected at least one", name, shape));
  if (voxels > static_cast<double>(most_voxels)) {
    throw InputError(
        fmt::format("{}: the header declares {} voxels; Bodkin reads at most {} million, so crop or "
                    "resample the image",
                    name, shape, most_voxels / 1'000'000));
  }
  if (voxels * static_cast<double>(voxel_bytes) > limit_bytes) {
    throw InputError(
        fmt::format("{}: the header declares {} voxels, but the file is too short to hold them; it is "
                    "truncated or damaged, copy it again",
                    name, shape));
  }
}

anatomy::Grid clean_grid(const anatomy::Grid& grid, const std::string& name) {
  anatomy::Grid clean = grid;
  if (!grid.spacing.allFinite() || grid.spacing.minCoeff() <= 0.0) {
    throw InputError(fmt::format("{}: the voxel spacing is {} x {} x {} mm; expected lengths above zero", name,
                                 grid.spacing[0], grid.spacing[1], grid.spacing[2]));
  }
  if (grid.spacing.minCoeff() < 1e-3 || grid.spacing.maxCoeff() > 100.0) {
    throw InputError(
        fmt::format("{}: the voxel spacing is {} x {} x {} mm; expected 0.001 to 100 mm (is the unit mm?)", name,
                    grid.spacing[0], grid.spacing[1], grid.spacing[2]));
  }
  if (!grid.origin.allFinite() || grid.origin.cwiseAbs().maxCoeff() > 1e6) {
    throw InputError(
        fmt::format("{}: the first voxel lies at ({}, {}, {}) mm; expected finite coordinates within a "
                    "kilometre",
                    name, grid.origin[0], grid.origin[1], grid.origin[2]));
  }
  const bool orthonormal =
      grid.direction.allFinite() &&
      (grid.direction.transpose() * grid.direction - Mat3::Identity()).cwiseAbs().maxCoeff() < 1e-4;
  if (!orthonormal) {
    throw InputError(
        fmt::format("{}: the axes of the image are not orthogonal unit vectors; resample it onto a regular "
                    "grid",
                    name));
  }
  const Mat3 snapped = grid.direction.array().round();
  if ((snapped - grid.direction).cwiseAbs().maxCoeff() < 1e-6) {
    clean.direction = snapped;
  } else if ((grid.direction.transpose() * grid.direction - Mat3::Identity()).cwiseAbs().maxCoeff() > 1e-14) {
    // The nearest orthonormal axes (Higham 1986): the unitary factor of the polar decomposition.
    const Eigen::JacobiSVD<Mat3> svd(grid.direction, Eigen::ComputeFullU | Eigen::ComputeFullV);
    clean.direction = svd.matrixU() * svd.matrixV().transpose();
  }
  clean.direction.array() += 0.0;  // -0 becomes 0, so that equal grids are equal to the bit
  clean.origin.array() += 0.0;
  return clean;
}

}  // namespace bodkin::io
