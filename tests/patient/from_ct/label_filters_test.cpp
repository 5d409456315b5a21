#include "patient/from_ct/label_filters.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin::patient {
namespace {

anatomy::Grid cube_grid(int size, double spacing) {
  anatomy::Grid grid;
  grid.size = {size, size, size};
  grid.spacing = Vec3::Constant(spacing);
  return grid;
}

template <typename Voxel>
anatomy::Volume<Voxel> filled_volume(const anatomy::Grid& grid, const std::function<Voxel(const Vec3&)>& value) {
  anatomy::Volume<Voxel> volume(grid);
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) volume.at(i, j, k) = value(grid.to_patient(Vec3(i, j, k)));
    }
  }
  return volume;
}

std::size_t set_voxels(const MaskVolume& mask) {
  return static_cast<std::size_t>(std::count(mask.voxels.begin(), mask.voxels.end(), 1));
}

// Two unconnected balls of 400 HU in water.
anatomy::CtVolume two_balls() {
  return filled_volume<std::int16_t>(cube_grid(40, 1.0), [](const Vec3& p) {
    const bool first = (p - Vec3(10, 20, 20)).norm() <= 6.0, second = (p - Vec3(30, 20, 20)).norm() <= 6.0;
    return static_cast<std::int16_t>(first || second ? 400 : 0);
  });
}

TEST(LabelFilters, a_threshold_takes_the_range_with_its_ends) {
  const anatomy::CtVolume ct = two_balls();
  const MaskVolume mask = threshold_region(ct, 400, 400, {});
  for (std::size_t i = 0; i < ct.voxels.size(); ++i) EXPECT_EQ(mask.voxels[i] != 0, ct.voxels[i] == 400);
  EXPECT_EQ(set_voxels(threshold_region(ct, 401, 3000, {})), 0U);
  const MaskVolume near = threshold_region(ct, 400, 400, {{10, 20, 20}, 8.0});
  EXPECT_EQ(2 * set_voxels(near), set_voxels(mask)) << "one of the two balls is within reach";
  EXPECT_THROW(threshold_region(ct, 10, 5, {}), InputError);
}

TEST(LabelFilters, a_region_grows_to_what_hangs_together_with_its_seed) {
  const anatomy::CtVolume ct = two_balls();
  const MaskVolume mask = grown_region(ct, 300, 500, {{10, 20, 20}, 0.0});
  EXPECT_EQ(2 * set_voxels(mask), set_voxels(threshold_region(ct, 400, 400, {})));
  EXPECT_EQ(mask.at(30, 20, 20), 0);
  EXPECT_EQ(mask.at(10, 20, 20), 1);
  EXPECT_EQ(set_voxels(grown_region(ct, 300, 500, {{10, 20, 20}, 3.0})), 123U) << "the voxels within 3 of the middle";
  EXPECT_THROW(grown_region(ct, 300, 500, {{20, 20, 20}, 0.0}), InputError);
  EXPECT_THROW(grown_region(ct, 300, 500, {{40, 20, 20}, 0.0}), InputError);
}

TEST(LabelFilters, slices_between_take_the_shape_between) {
  for (int axis = 0; axis < 3; ++axis) {
    // Discs of radius 12 and 6 in slices 5 and 17 make a cone.
    const anatomy::Grid grid = cube_grid(40, 1.0);
    MaskVolume mask(grid);
    const auto radius = [](int slice) { return 12.0 - 6.0 * (slice - 5) / 12.0; };
    const auto away = [axis](const Vec3& p) {
      Vec3 flat = p - Vec3(20, 20, 20);
      flat[axis] = 0.0;
      return flat.norm();
    };
    for (const int slice : {5, 17}) {
      const MaskVolume disc = filled_volume<std::uint8_t>(grid, [&](const Vec3& p) {
        return static_cast<std::uint8_t>(std::lround(p[axis]) == slice && away(p) <= radius(slice) ? 1 : 0);
      });
      for (std::size_t i = 0; i < mask.voxels.size(); ++i) mask.voxels[i] |= disc.voxels[i];
    }
    const MaskVolume filled = filled_between_slices(mask, axis);
    for (int k = 0; k < 40; ++k) {
      for (int j = 0; j < 40; ++j) {
        for (int i = 0; i < 40; ++i) {
          const Vec3 p(i, j, k);
          const int slice = static_cast<int>(std::lround(p[axis]));
          if (slice < 5 || slice > 17) {
            EXPECT_EQ(filled.at(i, j, k), 0);
          } else if (slice == 5 || slice == 17) {
            EXPECT_EQ(filled.at(i, j, k), mask.at(i, j, k));
          } else if (std::abs(away(p) - radius(slice)) > 1.0) {  // a voxel about the outline
            EXPECT_EQ(filled.at(i, j, k) != 0, away(p) < radius(slice)) << axis << ": " << p.transpose();
          }
        }
      }
    }
  }
  MaskVolume one(cube_grid(10, 1.0));
  EXPECT_THROW(filled_between_slices(one, 2), InputError);
  one.at(5, 5, 5) = 1;
  EXPECT_THROW(filled_between_slices(one, 2), InputError);
}

TEST(LabelFilters, smoothing_keeps_planes_and_takes_specks_and_holes) {
  const anatomy::Grid grid = cube_grid(48, 0.8);
  MaskVolume mask = filled_volume<std::uint8_t>(
      grid, [](const Vec3& p) { return static_cast<std::uint8_t>(p.z() < 20.0 ? 1 : 0); });
  const MaskVolume half = mask;
  mask.at(24, 24, 40) = 1;  // a speck in the air
  mask.at(24, 24, 8) = 0;   // a hole in the bone
  const MaskVolume smooth = smoothed(mask, 1.5);
  EXPECT_EQ(smooth.voxels, half.voxels);
  // A ball keeps its volume except for the shrinkage by curvature: sigma^2 / r.
  const MaskVolume ball = filled_volume<std::uint8_t>(
      grid, [](const Vec3& p) { return static_cast<std::uint8_t>((p - Vec3(19, 19, 19)).norm() <= 12.0 ? 1 : 0); });
  const double expected = 4.0 / 3.0 * M_PI * std::pow(12.0 - 1.0 / 12.0, 3) / std::pow(0.8, 3);
  EXPECT_NEAR(static_cast<double>(set_voxels(smoothed(ball, 1.0))), expected, 0.02 * expected);
  EXPECT_THROW(smoothed(ball, 0.0), InputError);
}

}  // namespace
}  // namespace bodkin::patient
