#include "anatomy/volume.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
namespace {

// HU that grow linearly through the volume: trilinear interpolation must reproduce them exactly.
CtVolume ramp(const Grid& grid) {
  CtVolume volume(grid);
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) volume.at(i, j, k) = static_cast<std::int16_t>(3 * i - 7 * j + 11 * k);
  return volume;
}

Grid grid_10_8_6() {
  Grid grid;
  grid.size = {10, 8, 6};
  grid.spacing = {0.7, 1.3, 2.5};
  grid.origin = {5, -3, 100};
  return grid;
}

TEST(Volume, trilinear_sampling_reproduces_a_linear_field) {
  const CtVolume volume = ramp(grid_10_8_6());
  Random random(3);
  for (int trial = 0; trial < 2000; ++trial) {
    const Vec3 index(random.uniform(0, 9), random.uniform(0, 7), random.uniform(0, 5));
    const double expected = 3 * index.x() - 7 * index.y() + 11 * index.z();
    EXPECT_NEAR(linear(volume, volume.grid.to_patient(index), -1000.0), expected, 1e-9);
  }
}

TEST(Volume, sampling_at_the_border_takes_the_border_and_beyond_it_the_outside) {
  const CtVolume volume = ramp(grid_10_8_6());
  EXPECT_DOUBLE_EQ(linear_at_index(volume, Vec3(9.4, 0, 0), -1000.0), 27.0);
  EXPECT_DOUBLE_EQ(linear_at_index(volume, Vec3(-0.4, 0, 0), -1000.0), 0.0);
  EXPECT_DOUBLE_EQ(linear_at_index(volume, Vec3(9.6, 0, 0), -1000.0), -1000.0);
  EXPECT_EQ(nearest_at_index<std::int16_t>(volume, Vec3(9.4, 7.4, 5.4), -1000), 3 * 9 - 7 * 7 + 11 * 5);
  EXPECT_EQ(nearest_at_index<std::int16_t>(volume, Vec3(9.5, 0, 0), -1000), -1000);
  EXPECT_EQ(nearest_at_index<std::int16_t>(volume, Vec3(-0.51, 0, 0), -1000), -1000);
}

TEST(Volume, a_slice_one_voxel_thick_can_be_sampled) {
  Grid grid = grid_10_8_6();
  grid.size[2] = 1;
  const CtVolume volume = ramp(grid);
  EXPECT_DOUBLE_EQ(linear_at_index(volume, Vec3(2.5, 1.0, 0.3), -1000.0), 0.5);
}

TEST(Volume, a_point_that_is_not_a_number_is_outside) {
  const CtVolume volume = ramp(grid_10_8_6());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(linear(volume, Vec3(nan, 0, 100), -1000.0), -1000.0);
  EXPECT_EQ(nearest<std::int16_t>(volume, Vec3(5, nan, 100), -1000), -1000);
}

}  // namespace
}  // namespace bodkin
