#include "station/axial_needle.h"

#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::station;
namespace {

Pose pose_at(double x, double y, double z, double tilt = 0.0) {
  Pose pose = Pose::Identity();
  pose.translation() = Vec3(x, y, z);
  pose.linear() = Eigen::AngleAxisd(tilt, Vec3::UnitX()).toRotationMatrix();
  return pose;
}

TEST(AxialNeedle, outside_it_is_where_the_hand_is) {
  AxialNeedle needle;
  for (int i = 0; i < 100; ++i) {
    const Pose hand = pose_at(0.1 * i, -0.05 * i, 0.02 * i, 0.001 * i);
    EXPECT_TRUE(needle.step(hand, false, 0.001).isApprox(hand, 1e-12));
  }
}

TEST(AxialNeedle, in_tissue_it_goes_in_and_out_and_turns_about_itself_alone) {
  AxialNeedle needle;
  needle.step(pose_at(0, 0, 0), false, 0.001);
  Pose last = Pose::Identity();
  for (int i = 1; i <= 200; ++i) last = needle.step(pose_at(0.05 * i, 0.03 * i, 0.1 * i, 0.002 * i), true, 0.001);
  EXPECT_NEAR(last.translation().x(), 0.0, 1e-12);
  EXPECT_NEAR(last.translation().y(), 0.0, 1e-12);
  EXPECT_NEAR(last.translation().z(), 20.0, 1e-12);
  EXPECT_NEAR(last.linear().col(2).dot(Vec3::UnitZ()), 1.0, 1e-12) << "levering does not turn its axis";
  const Mat3 before = last.linear();
  Pose rolled = pose_at(10.0, 6.0, 20.0, 0.4);
  rolled.linear() = Eigen::AngleAxisd(0.01, Vec3::UnitZ()) * rolled.linear();
  last = needle.step(rolled, true, 0.001);
  EXPECT_GT((last.linear() - before).norm(), 0.005) << "it may be rolled";
  EXPECT_NEAR(last.linear().col(2).z(), 1.0, 1e-12);
}

TEST(AxialNeedle, withdrawn_it_comes_back_to_the_hand_without_a_jump) {
  AxialNeedle needle;
  needle.step(pose_at(0, 0, 0), false, 0.001);
  for (int i = 1; i <= 100; ++i) needle.step(pose_at(0.2 * i, 0, 0.1 * i), true, 0.001);
  Pose last = needle.step(pose_at(20, 0, 10), true, 0.001);
  const Pose hand = pose_at(20, 0, -1);
  last = needle.step(hand, true, 0.001);
  int ticks = 0;
  while (!last.isApprox(hand, 1e-12) && ticks < 1000) {
    const Pose next = needle.step(hand, false, 0.001);
    EXPECT_LE((next.translation() - last.translation()).norm(), 0.05 + 1e-9);
    last = next;
    ++ticks;
  }
  EXPECT_NEAR(ticks, 400, 3) << "20 mm at 50 mm/s";
}

// Hands that move and turn at random, with needles that enter and leave tissue by chance, ten minutes altogether: in
// tissue neither the line nor the axis changes; outside, and where it changes, nothing jumps.
TEST(AxialNeedle, keeps_its_line_in_tissue_whatever_the_hand_does) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const auto chance = [&random](double size) {
      return Vec3(size * random.normal(), size * random.normal(), size * random.normal());
    };
    AxialNeedle needle;
    Pose hand = pose_at(0, 0, 0);
    Pose last = needle.step(hand, false, 0.001);
    Vec3 speed = Vec3::Zero(), turning = Vec3::Zero();
    bool in_tissue = false;
    Vec3 entered = Vec3::Zero(), axis = Vec3::UnitZ();
    for (int i = 0; i < 30'000; ++i) {
      speed = 0.99 * speed + chance(0.01);        // mm per tick
      turning = 0.99 * turning + chance(0.0003);  // rad per tick
      hand.translation() += speed;
      hand.linear() = Eigen::AngleAxisd(turning.norm(), turning.normalized()) * hand.linear();
      if (random.uniform() < 0.002) {
        in_tissue = !in_tissue;
        entered = last.translation();
        axis = last.linear().col(2);
      }
      const Pose next = needle.step(hand, in_tissue, 0.001);
      const Vec3 way = next.translation() - last.translation();
      ASSERT_LE(way.norm(), speed.norm() + 0.05 + 1e-9) << "seed " << seed << ", tick " << i;
      if (in_tissue) {
        const Vec3 from_entry = next.translation() - entered;
        ASSERT_LT((from_entry - axis.dot(from_entry) * axis).norm(), 1e-6) << "seed " << seed << ", tick " << i;
        ASSERT_NEAR(next.linear().col(2).dot(axis), 1.0, 1e-9) << "seed " << seed << ", tick " << i;
        ASSERT_NEAR(axis.dot(way), axis.dot(speed), 1e-9) << "as far along as the hand";
      }
      ASSERT_TRUE((next.linear().transpose() * next.linear()).isIdentity(1e-9)) << "a rotation";
      last = next;
    }
  }
}

}  // namespace
}  // namespace bodkin
