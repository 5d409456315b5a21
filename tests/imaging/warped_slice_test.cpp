#include "imaging/warped_slice.h"

#include <cmath>

#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

// HU rise by 10 a mm along z; bone for z > 20.
struct RampPatient {
  CtVolume ct;
  TissueVolume tissues;
  RampPatient() {
    Grid grid;
    grid.size = {41, 41, 41};
    ct = CtVolume(grid);
    tissues = TissueVolume(grid);
    for (int k = 0; k < 41; ++k) {
      for (int j = 0; j < 41; ++j) {
        for (int i = 0; i < 41; ++i) {
          ct.at(i, j, k) = static_cast<std::int16_t>(10 * k);
          tissues.at(i, j, k) = k > 20 ? tissue::cortical_bone : tissue::muscle;
        }
      }
    }
  }
};

SlicePlane middle_plane() {
  return {Vec3(5.0, 20.0, 5.0), Vec3::UnitX(), Vec3::UnitZ(), 0.5, 61, 51};
}

std::vector<float> displacements_of(const SlicePlane& grid, const std::function<Vec3(const Vec3&)>& law) {
  std::vector<float> values;
  for (const Vec3& point : points_of(grid)) {
    const Vec3 moved = law(point);
    for (Eigen::Index axis = 0; axis < 3; ++axis) values.push_back(static_cast<float>(moved[axis]));
  }
  return values;
}

TEST(WarpedSlice, the_grid_covers_the_plane) {
  const SlicePlane plane = middle_plane();
  for (const double spacing : {0.7, 3.0, 100.0}) {
    const SlicePlane grid = warp_grid(plane, spacing);
    EXPECT_LE(grid.pixel, std::max(spacing, 30.0) + 1e-9);
    EXPECT_NEAR(grid.pixel * (grid.width - 1), 30.0, 1e-9);
    EXPECT_GE(grid.pixel * (grid.height - 1), 25.0 - 1e-9);
    EXPECT_EQ(points_of(grid).size(), static_cast<std::size_t>(grid.width * grid.height));
    EXPECT_LT((points_of(grid).front() - plane.corner).norm(), 1e-12);
  }
}

TEST(WarpedSlice, without_displacement_it_is_the_slice) {
  const RampPatient patient;
  const SlicePlane grid = warp_grid(middle_plane(), 2.0);
  const Slice rest = cut(middle_plane(), patient.ct, patient.tissues);
  const Slice same = cut_deformed(middle_plane(), patient.ct, patient.tissues, grid,
                                  displacements_of(grid, [](const Vec3&) { return Vec3::Zero(); }));
  EXPECT_EQ(same.hounsfield, rest.hounsfield);
  EXPECT_EQ(same.tissues, rest.tissues);
}

TEST(WarpedSlice, shows_at_each_pixel_what_has_moved_there) {
  const RampPatient patient;
  const SlicePlane plane = middle_plane(), grid = warp_grid(plane, 1.0);
  // Linear, so that the grid holds it exactly: x(X) = X + 2 + 0.3 (X - 10) along z, the more so to the right.
  const auto law = [](const Vec3& rest) { return Vec3(0.5, 3.0, 2.0 + 0.3 * (rest.z() - 10.0) + 0.05 * rest.x()); };
  const Slice moved = cut_deformed(plane, patient.ct, patient.tissues, grid, displacements_of(grid, law));
  int compared = 0;
  for (int row = 20; row < 50; ++row) {
    for (int column = 4; column < 60; ++column) {
      const Vec3 pixel = plane.point(column, row);
      const double x = pixel.x() - 0.5;
      const double z = (pixel.z() - 2.0 + 3.0 - 0.05 * x) / 1.3;
      if (x < 5.0 || z < 5.0 || z > 29.0) continue;  // beyond the grid
      const auto at = static_cast<std::size_t>(row * plane.width + column);
      EXPECT_NEAR(static_cast<double>(moved.hounsfield[at]), 10.0 * z, 0.1);
      if (std::abs(z - 20.5) > 0.02) {
        EXPECT_EQ(moved.tissues[at], z > 20.5 ? tissue::cortical_bone : tissue::muscle);
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace bodkin
