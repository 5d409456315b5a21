#include "forces/tissue_path.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::forces;
namespace {

// Slabs along z: tissue z / 4 + 1 in voxels of 1 mm.
TissueVolume slabs() {
  Grid grid;
  grid.size = {10, 10, 40};
  TissueVolume volume(grid);
  for (int k = 0; k < 40; ++k) {
    for (int j = 0; j < 10; ++j) {
      for (int i = 0; i < 10; ++i) volume.at(i, j, k) = static_cast<TissueId>(k / 4 + 1);
    }
  }
  return volume;
}

TEST(TissuePath, every_layer_carries_the_tissue_at_its_middle) {
  const TissueVolume volume = slabs();
  TissuePath path(0.5, 100.0);
  path.restart({5.0, 5.0, -0.5}, Vec3::UnitZ());
  path.extend_to(39.9, volume);
  ASSERT_EQ(path.layers().size(), 80u);
  for (std::size_t layer = 0; layer < 80; ++layer) EXPECT_EQ(path.layers()[layer], layer / 8 + 1);
  path.restart({5.0, 5.0, -0.7}, Vec3::UnitZ());  // a border between tissues goes through a layer before its middle
  path.extend_to(39.9, volume);
  for (std::size_t layer = 0; layer < 80; ++layer) EXPECT_EQ(path.layers()[layer], layer / 8 + 1);
}

TEST(TissuePath, layers_do_not_depend_on_how_often_they_are_asked_for) {
  const TissueVolume volume = slabs();
  const Vec3 direction = Vec3(1.0, 1.0, 3.0).normalized();
  TissuePath once(0.5, 100.0), often(0.5, 100.0);
  once.restart({1.0, 1.0, 0.0}, direction);
  often.restart({1.0, 1.0, 0.0}, direction);
  once.extend_to(30.0, volume);
  for (double depth = -1.0; depth <= 30.0; depth += 0.013) often.extend_to(depth, volume);
  often.extend_to(30.0, volume);
  often.extend_to(2.0, volume);  // going back forgets nothing
  EXPECT_TRUE(std::ranges::equal(once.layers(), often.layers()));
}

TEST(TissuePath, beyond_the_volume_is_air_and_beyond_the_longest_depth_is_nothing) {
  const TissueVolume volume = slabs();
  TissuePath path(1.0, 60.0);
  path.restart({5.0, 5.0, -0.5}, Vec3::UnitZ());
  path.extend_to(1e300, volume);
  EXPECT_EQ(path.layers().size(), 61u);
  EXPECT_EQ(path.layers()[39], 10);
  EXPECT_EQ(path.layers()[40], tissue::air);
  path.restart({5.0, 5.0, -0.5}, Vec3::UnitZ());
  EXPECT_TRUE(path.layers().empty());
  path.extend_to(std::numeric_limits<double>::quiet_NaN(), volume);
  EXPECT_TRUE(path.layers().empty());
}

}  // namespace
}  // namespace bodkin
