// Where a needle lies that was left in tissue which moves: against motions whose answer is known, and the least of
// the squares that it is to be.
#include "station/left_needle_motion.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace bodkin::station {
namespace {

const anatomy::NeedlePath slanted_needle{Vec3(10.0, 20.0, -5.0), Vec3(22.0, -17.0, 4.0)};

std::vector<float> displacements_of(const LeftNeedleMotion& motion, const std::function<Vec3(const Vec3&)>& moved) {
  std::vector<float> all;
  for (const Vec3& point : motion.points()) {
    const Vec3 by = moved(point) - point;
    for (int axis = 0; axis < 3; ++axis) all.push_back(static_cast<float>(by[axis]));
  }
  return all;
}

TEST(LeftNeedleMotion, tissue_at_rest_leaves_it_where_it_was) {
  LeftNeedleMotion motion({slanted_needle, {Vec3::Zero(), Vec3(0.0, -1.0, 0.0)}});
  ASSERT_EQ(motion.needles(), 2U);
  for (const std::vector<float>& nothing : {std::vector<float>(), std::vector<float>(4, 1.0F)}) {
    const std::vector<Pose>& poses = motion.poses(nothing, 1.0);
    EXPECT_LT((poses[0].translation() - slanted_needle.target).norm(), 1e-12);
    EXPECT_LT((needle_axis(poses[0]) - slanted_needle.direction()).norm(), 1e-12);
    EXPECT_LT((poses[1].translation() - Vec3(0.0, -1.0, 0.0)).norm(), 1e-12);
  }
}

TEST(LeftNeedleMotion, goes_with_tissue_that_moves_as_a_whole) {
  LeftNeedleMotion motion({slanted_needle, {slanted_needle.target, slanted_needle.entry}});
  Pose whole = Pose::Identity();
  whole.rotate(Eigen::AngleAxisd(0.4, Vec3(1.0, -2.0, 0.5).normalized()));
  whole.pretranslate(Vec3(3.0, -8.0, 12.0));
  const std::vector<Pose> poses =
      motion.poses(displacements_of(motion, [&](const Vec3& at) { return Vec3(whole * at); }), 0.0);
  EXPECT_LT((poses[0].translation() - whole * slanted_needle.target).norm(), 1e-5);
  EXPECT_LT((needle_axis(poses[0]) - whole.linear() * slanted_needle.direction()).norm(), 1e-6);
  EXPECT_LT((poses[1].translation() - whole * slanted_needle.entry).norm(), 1e-5);
}

// Strained evenly, the tissue along it is a line still, which the needle lies in; it is not stretched, so that its
// middle alone is where its tissue is.
TEST(LeftNeedleMotion, keeps_its_length_in_tissue_that_is_strained) {
  LeftNeedleMotion motion({slanted_needle});
  Mat3 strain;
  strain << 0.05, 0.2, 0.0, -0.1, -0.15, 0.03, 0.0, 0.07, 0.1;
  const auto moved = [&](const Vec3& at) { return Vec3(at + strain * at); };
  const Pose now = motion.poses(displacements_of(motion, moved), 0.0)[0];
  const Vec3 axis = (moved(slanted_needle.target) - moved(slanted_needle.entry)).normalized();
  const Vec3 middle = moved(0.5 * (slanted_needle.entry + slanted_needle.target));
  EXPECT_LT((needle_axis(now) - axis).norm(), 1e-6);
  EXPECT_LT((now.translation() - middle - 0.5 * slanted_needle.length() * axis).norm(), 1e-5);
}

TEST(LeftNeedleMotion, no_other_place_is_nearer_to_its_tissue) {
  LeftNeedleMotion motion({slanted_needle});
  const auto moved = [](const Vec3& at) {
    return Vec3(at + Vec3(2.0 * std::sin(0.1 * at.y()), 0.01 * at.x() * at.x(), -0.02 * at.y() * at.z()));
  };
  const Pose best = motion.poses(displacements_of(motion, moved), 0.0)[0];
  const auto squares = [&](const Pose& needle) {
    double sum = 0.0;
    for (const Vec3& point : motion.points()) {
      const double before_tip = (slanted_needle.target - point).norm();
      sum += (needle.translation() - before_tip * needle_axis(needle) - moved(point)).squaredNorm();
    }
    return sum;
  };
  const double least = squares(best);
  EXPECT_GT(least, 0.01) << "the tissue is bent";
  for (int trial = 0; trial < 300; ++trial) {
    const double angle = 0.002 * (trial + 1), far = 0.02 * (trial + 1);
    Pose other = best;
    other.rotate(Eigen::AngleAxisd(trial % 3 == 0 ? 0.0 : angle, Vec3(std::cos(trial), std::sin(trial), 0.0)));
    if (trial % 3 != 1) other.pretranslate(far * Vec3(std::sin(3.0 * trial), std::cos(trial), std::sin(trial)));
    ASSERT_GE(squares(other), least) << trial;
  }
}

TEST(LeftNeedleMotion, breath_and_what_else_moves_the_tissue_add_up) {
  anatomy::Breathing breathing;
  breathing.motion = Vec3(0.0, -2.0, -9.0);
  breathing.centre = slanted_needle.target;
  breathing.radius = 1e5;  // everything moves alike
  LeftNeedleMotion motion({slanted_needle}, anatomy::BreathField(breathing));
  const auto pressed = [](const Vec3& at) { return Vec3(at + Vec3(0.0, -3.0, 1.0)); };
  const Pose both = motion.poses(displacements_of(motion, pressed), 0.5)[0];
  EXPECT_LT((both.translation() - slanted_needle.target - Vec3(0.0, -4.0, -3.5)).norm(), 1e-4);
  const Pose breath = motion.poses({}, 1.0)[0];
  EXPECT_LT((breath.translation() - slanted_needle.target - breathing.motion).norm(), 1e-4);
  EXPECT_LT((needle_axis(breath) - slanted_needle.direction()).norm(), 1e-6);
}

TEST(LeftNeedleMotion, tissue_in_one_point_gives_a_pose_still) {
  LeftNeedleMotion motion({slanted_needle});
  const Pose now = motion.poses(displacements_of(motion, [](const Vec3&) { return Vec3(1.0, 2.0, 3.0); }), 0.0)[0];
  EXPECT_TRUE(now.matrix().allFinite());
  EXPECT_NEAR(needle_axis(now).norm(), 1.0, 1e-12);
}

}  // namespace
}  // namespace bodkin::station
