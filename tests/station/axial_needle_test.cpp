#include "station/axial_needle.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace bodkin
