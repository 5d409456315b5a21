// Tissue motion for the slices of an attempt, from displacements with a known law.
#include "app/models/slice_tissue.h"

#include <cmath>
#include <functional>
#include <memory>

#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

// Air before y = 0, tissue behind.
anatomy::TissueVolume half_space() {
  anatomy::Grid grid;
  grid.size = {100, 120, 100};
  grid.origin = Vec3(-50.0, -40.0, -50.0);
  anatomy::TissueVolume tissues(grid, anatomy::tissue::muscle);
  for (int k = 0; k < 100; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 100; ++i) tissues.at(i, j, k) = anatomy::tissue::air;
  return tissues;
}

// A dent about the path that becomes less with the distance from the entry.
Vec3 dent(const Vec3& rest) {
  return {0.0, 6.0 * std::exp(-rest.squaredNorm() / (2.0 * 20.0 * 20.0)), 0.0};
}

std::vector<float> displacements_of(const std::vector<Vec3>& points, double share) {
  std::vector<float> made;
  for (const Vec3& point : points)
    for (const double part : dent(point)) made.push_back(static_cast<float>(share * part));
  return made;
}

class SliceTissueTest : public testing::Test {
 protected:
  const anatomy::TissueVolume tissues_ = half_space();
  SliceTissue tissue_;
  const std::vector<Vec3> skin_ = {Vec3(1.0, 2.0, 3.0), Vec3(4.0, 5.0, 6.0)};
  const std::vector<Vec3> points_ = tissue_.follow(skin_, {Vec3(0.0, -0.5, 0.0), Vec3(0.0, 40.0, 0.0)}, tissues_);
};

TEST_F(SliceTissueTest, asks_for_what_others_ask_first_and_then_for_tissue_alone) {
  ASSERT_GT(points_.size(), 200U);
  EXPECT_LT(points_.size(), 1600U);
  EXPECT_EQ(points_[0], skin_[0]);
  EXPECT_EQ(points_[1], skin_[1]);
  const std::vector<float> all = displacements_of(points_, 1.0);
  const auto others = tissue_.of_others(all);
  ASSERT_EQ(others.size(), 6U);
  EXPECT_EQ(others.data(), all.data());
  int of_skin = 0;
  for (const Vec3& point : points_) of_skin += std::abs(point.y() + 0.5) < 0.6 ? 1 : 0;
  EXPECT_GT(of_skin, 20) << "points in the air above it ask for the skin";
}

TEST_F(SliceTissueTest, is_the_law_where_the_needle_is_and_rests_at_the_border) {
  const auto moved = tissue_.now(displacements_of(points_, 1.0));
  ASSERT_NE(moved, nullptr);
  for (const Vec3& rest : {Vec3(0.0, 0.0, 0.0), Vec3(5.0, 0.0, -7.0), Vec3(3.0, 20.0, 4.0), Vec3(0.0, 35.0, 0.0)})
    EXPECT_LT((moved->of(rest) - dent(rest)).norm(), 0.35) << rest.transpose();
  EXPECT_EQ(moved->of(Vec3(45.0, 10.0, 0.0)), Vec3::Zero());
}

TEST_F(SliceTissueTest, is_drawn_anew_only_for_what_can_be_seen) {
  EXPECT_EQ(tissue_.now(displacements_of(points_, 0.0)), nullptr);
  const auto first = tissue_.now(displacements_of(points_, 0.5));
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(tissue_.now(displacements_of(points_, 0.53)), first) << "0.18 mm further";
  const auto second = tissue_.now(displacements_of(points_, 0.7));
  EXPECT_NE(second, first);
  EXPECT_EQ(tissue_.now({}), nullptr) << "another patient, or a station that does not tell";
}

}  // namespace
}  // namespace bodkin::app
