#include "haptics/motion_watch.h"

#include <limits>

#include "tests/one_tick.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::haptics;
namespace {

const Vec3 no_velocity = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());

Pose at(double x) {
  Pose pose = Pose::Identity();
  pose.translation().x() = x;
  return pose;
}

TEST(MotionWatch, a_reading_is_still_when_it_repeats_the_one_before_to_the_bit) {
  MotionWatch watch(one_tick);
  watch.step(at(3.0), no_velocity, one_tick);
  EXPECT_FALSE(watch.is_still());  // there is none before it
  watch.step(at(3.0), no_velocity, one_tick);
  EXPECT_TRUE(watch.is_still());
  watch.step(at(3.0 + 1e-12), no_velocity, one_tick);
  EXPECT_FALSE(watch.is_still());
}

TEST(MotionWatch, a_jump_is_long_and_too_fast_for_a_hand) {
  MotionWatch watch(one_tick);
  watch.step(at(0.0), no_velocity, one_tick);
  watch.step(at(6.0), no_velocity, one_tick);
  EXPECT_TRUE(watch.jumped());
  watch.step(at(12.0), no_velocity, 0.010);  // the same distance after a late tick: 0.6 m/s
  EXPECT_FALSE(watch.jumped());
}

TEST(MotionWatch, speed_is_the_reported_one_or_else_the_change_of_position) {
  MotionWatch watch(one_tick);
  watch.step(at(0.0), no_velocity, one_tick);
  watch.step(at(0.5), no_velocity, one_tick);
  EXPECT_NEAR(watch.speed(), 500.0, 1e-9);
  watch.step(at(0.5), Vec3(0.0, 70.0, 0.0), one_tick);
  EXPECT_NEAR(watch.speed(), 70.0, 1e-9);
}

}  // namespace
}  // namespace bodkin
