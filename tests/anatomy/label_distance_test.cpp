#include "anatomy/label_distance.h"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
namespace {

using Labels = Volume<std::uint8_t>;

Labels patches(std::uint64_t seed, const std::array<int, 3>& size, const Vec3& spacing) {
  Grid grid;
  grid.size = size;
  grid.spacing = spacing;
  Labels labels(grid);
  Random random(seed);
  // Blocks rather than noise, so that there are thick and thin parts.
  for (int block = 0; block < 25; ++block) {
    const auto label = static_cast<std::uint8_t>(1 + static_cast<int>(random.uniform() * 4.0));
    std::array<int, 3> low, high;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = static_cast<int>(random.uniform() * size[axis]);
      high[axis] = std::min(size[axis], low[axis] + 1 + static_cast<int>(random.uniform() * 5.0));
    }
    for (int k = low[2]; k < high[2]; ++k) {
      for (int j = low[1]; j < high[1]; ++j) {
        for (int i = low[0]; i < high[0]; ++i) labels.at(i, j, k) = label;
      }
    }
  }
  return labels;
}

template <typename Visit>
void for_voxels(const Grid& grid, const Visit& visit) {
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) visit(grid.offset(i, j, k), grid.to_patient(Vec3(i, j, k)));
    }
  }
}

TEST(LabelDistance, is_what_looking_at_every_pair_of_voxels_gives) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Labels labels = patches(seed, {11, 9, 7}, {1.0, 0.7, 2.5});
    const std::vector<float> distance = distance_to_other_label(labels);
    for_voxels(labels.grid, [&](std::size_t a, const Vec3& at) {
      double nearest = std::numeric_limits<double>::infinity();
      for_voxels(labels.grid, [&](std::size_t b, const Vec3& other) {
        if (labels.voxels[a] != labels.voxels[b]) nearest = std::min(nearest, (at - other).norm());
      });
      EXPECT_NEAR(static_cast<double>(distance[a]), nearest, 1e-5);
    });
  }
}

TEST(LabelDistance, a_volume_of_one_label_has_no_border) {
  const Labels labels = patches(1, {1, 1, 1}, Vec3::Ones());
  EXPECT_TRUE(std::isinf(distance_to_other_label(labels).front()));
  EXPECT_EQ(thick_enough(labels, distance_to_other_label(labels), {3.0F}).front(), 1);
}

TEST(LabelDistance, thick_parts_are_the_union_of_balls_that_fit) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Labels labels = patches(seed, {11, 9, 7}, {1.0, 0.8, 1.5});
    const std::vector<float> distance = distance_to_other_label(labels);
    std::vector<float> radius(distance.size());
    Random random(seed + 100);
    for (float& r : radius) r = static_cast<float>(0.4 + 1.5 * random.uniform());
    const std::vector<std::uint8_t> kept = thick_enough(labels, distance, radius);
    for_voxels(labels.grid, [&](std::size_t p, const Vec3& at) {
      bool in_a_ball = false;
      for_voxels(labels.grid, [&](std::size_t c, const Vec3& middle) {
        const double reach = static_cast<double>(distance[c]);
        if (labels.voxels[c] == labels.voxels[p] && reach - 0.4 + 1e-5 >= static_cast<double>(radius[c]) &&
            (at - middle).norm() < reach - 1e-4) {
          in_a_ball = true;
        }
      });
      EXPECT_EQ(kept[p] != 0, in_a_ball);
    });
  }
}

TEST(LabelDistance, a_sheet_is_thick_enough_up_to_half_its_thickness) {
  Grid grid;
  grid.size = {20, 20, 20};
  Labels labels(grid);
  for_voxels(grid, [&](std::size_t at, const Vec3& place) { labels.voxels[at] = place.z() >= 8 && place.z() <= 10; });
  const std::vector<float> distance = distance_to_other_label(labels);
  const auto sheet_kept = [&](float radius) {
    return thick_enough(labels, distance, std::vector<float>(distance.size(), radius))[grid.offset(10, 10, 9)] != 0;
  };
  EXPECT_TRUE(sheet_kept(1.5F));
  EXPECT_FALSE(sheet_kept(1.51F));
}

TEST(LabelDistance, labels_left_out_change_nothing_for_the_others) {
  const Labels labels = patches(5, {11, 9, 7}, {1.0, 0.7, 2.5});
  const std::vector<float> distance = distance_to_other_label(labels), radius(distance.size(), 1.0F);
  const std::vector<std::uint8_t> kept = thick_enough(labels, distance, radius);
  const std::array<std::uint8_t, 2> left_out = {0, 3};
  const std::vector<float> of_some = distance_to_other_label(labels, left_out);
  const std::vector<std::uint8_t> kept_of_some = thick_enough(labels, of_some, radius, left_out);
  for (std::size_t i = 0; i < distance.size(); ++i) {
    const bool is_left_out = labels.voxels[i] == 0 || labels.voxels[i] == 3;
    EXPECT_EQ(of_some[i], is_left_out ? std::numeric_limits<float>::infinity() : distance[i]);
    EXPECT_EQ(kept_of_some[i], is_left_out ? 0 : kept[i]);
  }
}

}  // namespace
}  // namespace bodkin
