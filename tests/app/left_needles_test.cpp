#include "app/models/left_needles.h"

#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

const anatomy::NeedlePath left_first{Vec3(0.0, 0.0, 0.0), Vec3(0.0, -30.0, 0.0)};
const anatomy::NeedlePath left_second{Vec3(20.0, 0.0, 0.0), Vec3(20.0, -12.0, 5.0)};

TEST(LeftNeedles, go_with_the_tissue_that_the_session_tells_of) {
  LeftNeedles needles;
  needles.begin({left_first});
  needles.add(left_second);
  const std::vector<Vec3> skin = {Vec3(1.0, 0.0, 0.0), Vec3(2.0, 0.0, 0.0)};
  const std::vector<Vec3> followed = needles.follow(skin, {});
  ASSERT_GT(followed.size(), 4U);
  EXPECT_EQ(followed[1], skin[1]);
  std::vector<float> moved;
  for (std::size_t i = 0; i < followed.size(); ++i) {
    const float down = i < skin.size() ? 100.0F : followed[i].x() < 10.0 ? -2.0F : -5.0F;
    moved.insert(moved.end(), {1.0F, down, 0.0F});
  }
  ASSERT_EQ(needles.of_others(moved).size(), 6U);
  const std::span<const views::LeftNeedle> now = needles.now(moved, 0.0);
  ASSERT_EQ(now.size(), 2U);
  EXPECT_LT((now[0].pose.translation() - left_first.target - Vec3(1.0, -2.0, 0.0)).norm(), 1e-5);
  EXPECT_LT((now[1].pose.translation() - left_second.target - Vec3(1.0, -5.0, 0.0)).norm(), 1e-5);
  EXPECT_NEAR(now[1].depth, left_second.length(), 1e-12);
}

TEST(LeftNeedles, one_that_is_taken_out_while_the_session_runs_leaves_the_others_where_they_are) {
  LeftNeedles needles;
  needles.begin({left_first, left_second});
  const std::vector<Vec3> followed = needles.follow({}, {});
  std::vector<float> moved;
  for (std::size_t i = 0; i < followed.size(); ++i) moved.insert(moved.end(), {0.0F, -3.0F, 0.0F});
  ASSERT_TRUE(needles.take_out());
  const std::span<const views::LeftNeedle> now = needles.now(moved, 0.0);
  ASSERT_EQ(now.size(), 1U);
  EXPECT_LT((now[0].pose.translation() - left_first.target - Vec3(0.0, -3.0, 0.0)).norm(), 1e-5);
  EXPECT_TRUE(needles.of_others(moved).empty());
  ASSERT_TRUE(needles.take_out());
  EXPECT_FALSE(needles.take_out());
}

// The drawn skin must not change its length between two sessions.
TEST(LeftNeedles, one_that_was_left_just_now_is_shown_at_rest) {
  LeftNeedles needles;
  needles.begin({});
  needles.follow({Vec3::Zero()}, {});
  needles.add(left_first);
  const std::vector<float> moved = {1.0F, 2.0F, 3.0F};
  EXPECT_EQ(needles.of_others(moved).size(), 3U);
  const std::span<const views::LeftNeedle> now = needles.now(moved, 0.7);
  ASSERT_EQ(now.size(), 1U);
  EXPECT_LT((now[0].pose.translation() - left_first.target).norm(), 1e-12);
  EXPECT_TRUE(needles.now({}, 0.0).size() == 1U);
}

TEST(LeftNeedles, displacements_that_nobody_asked_for_here_are_of_the_skin) {
  LeftNeedles needles;
  needles.begin({});
  const std::vector<float> moved(12, 1.0F);
  EXPECT_EQ(needles.of_others(moved).size(), 12U);
}

}  // namespace
}  // namespace bodkin::app
