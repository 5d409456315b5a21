#include "haptics/pointer_hand.h"

#include <cmath>
#include <numbers>

#include "tests/one_tick.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::haptics;
namespace {

using Key = PointerInput::Key;

// The hand after so many s in which nothing new was done.
Pose after(PointerHand& hand, const PointerState& state, double seconds) {
  Pose pose = Pose::Identity();
  for (int tick = 0; tick < static_cast<int>(std::lround(seconds / one_tick)); ++tick)
    pose = hand.step(state, one_tick);
  return pose;
}

class PointerHandTest : public testing::Test {
 protected:
  PointerHandTest() { hand_.step(input_.state(), one_tick); }
  Pose settled() { return after(hand_, input_.state(), 2.0); }

  PointerInput input_;
  PointerHand hand_{PointerSettings{}};
};

TEST_F(PointerHandTest, begins_in_the_middle_and_points_down) {
  const Pose pose = settled();
  EXPECT_TRUE(pose.translation().isZero());
  EXPECT_TRUE(needle_axis(pose).isApprox(-Vec3::UnitZ()));
  EXPECT_NEAR(pose.linear().determinant(), 1.0, 1e-12);
}

TEST_F(PointerHandTest, pixels_go_right_and_away_and_the_wheel_inwards) {
  input_.move(100.0, 40.0, false);  // 0.1 mm each
  input_.wheel(3.0);                // 1 mm each
  EXPECT_TRUE(settled().translation().isApprox(Vec3(10.0, 4.0, -3.0), 1e-9));
  input_.wheel(-5.0);
  EXPECT_TRUE(settled().translation().isApprox(Vec3(10.0, 4.0, 2.0), 1e-9));
}

TEST_F(PointerHandTest, fine_motion_is_a_fifth) {
  input_.fine(true);
  input_.move(100.0, 0.0, false);
  input_.wheel(10.0);
  EXPECT_TRUE(settled().translation().isApprox(Vec3(2.0, 0.0, -2.0), 1e-9));
}

TEST_F(PointerHandTest, a_key_that_is_held_is_a_speed_and_two_against_each_other_are_none) {
  input_.key(Key::inwards, true);
  EXPECT_NEAR(after(hand_, input_.state(), 1.0).translation().z(), -10.0 + 10.0 * 2.0 * 0.05, 0.02);  // lags by 2 T
  EXPECT_NEAR(hand_.velocity().z(), -10.0, 1e-3);
  input_.key(Key::outwards, true);
  const double stopped = settled().translation().z();
  EXPECT_NEAR(stopped, -10.0, 1e-6);
  input_.key(Key::inwards, false);
  EXPECT_GT(after(hand_, input_.state(), 0.5).translation().z(), stopped + 1.0);
  input_.release();
  const Pose still = settled();
  EXPECT_EQ(after(hand_, input_.state(), 0.5).translation().z(), still.translation().z());
}

TEST_F(PointerHandTest, every_key_has_its_own_way) {
  const std::pair<Key, Vec3> ways[] = {{Key::right, Vec3::UnitX()},    {Key::left, -Vec3::UnitX()},
                                       {Key::away, Vec3::UnitY()},     {Key::near, -Vec3::UnitY()},
                                       {Key::inwards, -Vec3::UnitZ()}, {Key::outwards, Vec3::UnitZ()}};
  for (const auto& [key, way] : ways) {
    PointerInput input;
    PointerHand hand{PointerSettings{}};
    input.key(key, true);
    after(hand, input.state(), 0.3);
    input.key(key, false);
    EXPECT_TRUE(after(hand, input.state(), 2.0).translation().isApprox(3.0 * way, 1e-6)) << way.transpose();
  }
}

TEST_F(PointerHandTest, a_drag_tilts_the_tip_and_the_push_follows_the_needle) {
  const double angle = 0.2;               // rad
  input_.move(0.0, angle / 0.002, true);  // the tip away from the operator
  Pose pose = settled();
  EXPECT_TRUE(needle_axis(pose).isApprox(Vec3(0.0, std::sin(angle), -std::cos(angle)), 1e-9))
      << needle_axis(pose).transpose();
  EXPECT_TRUE(pose.translation().isZero(1e-12));
  input_.wheel(10.0);
  pose = settled();
  EXPECT_TRUE(pose.translation().isApprox(10.0 * needle_axis(pose), 1e-6)) << pose.translation().transpose();
}

TEST_F(PointerHandTest, a_drag_to_the_right_tilts_the_tip_to_the_right) {
  input_.move(100.0, 0.0, true);
  EXPECT_TRUE(needle_axis(settled()).isApprox(Vec3(std::sin(0.2), 0.0, -std::cos(0.2)), 1e-9));
}

TEST_F(PointerHandTest, the_tilt_ends_at_sixty_degrees_and_the_motion_at_the_reach) {
  input_.move(0.0, 1e6, true);
  input_.move(1e6, -1e6, false);
  const Pose pose = settled();
  EXPECT_NEAR(needle_axis(pose).z(), -0.5, 1e-6);
  EXPECT_NEAR(pose.translation().x(), 150.0, 1e-6);
  EXPECT_NEAR(pose.translation().y(), -150.0, 1e-6);
}

// x(t) = 1 - (1 + t/T) exp(-t/T), the textbook's critically damped step.
TEST_F(PointerHandTest, a_step_becomes_a_smooth_motion_without_overshoot) {
  input_.wheel(1.0);
  for (int tick = 1; tick <= 500; ++tick) {
    const double z = -hand_.step(input_.state(), one_tick).translation().z();
    const double t = tick * one_tick / 0.05;
    ASSERT_NEAR(z, 1.0 - (1.0 + t) * std::exp(-t), 1e-9) << tick;
    ASSERT_LE(z, 1.0);
  }
}

TEST_F(PointerHandTest, the_motion_does_not_depend_on_how_often_it_is_asked) {
  PointerHand slow{PointerSettings{}};
  slow.step(input_.state(), 0.01);
  input_.wheel(7.0);
  Pose often, seldom;
  for (int tick = 0; tick < 100; ++tick) often = hand_.step(input_.state(), 0.001);
  for (int tick = 0; tick < 10; ++tick) seldom = slow.step(input_.state(), 0.01);
  EXPECT_NEAR((often.translation() - seldom.translation()).norm(), 0.0, 1e-9);
}

TEST(PointerHandStart, what_was_done_before_the_first_step_does_not_move_it) {
  PointerInput input;
  input.move(500.0, 500.0, false);
  PointerHand hand{PointerSettings{}};
  EXPECT_TRUE(after(hand, input.state(), 1.0).translation().isZero());
}

}  // namespace
}  // namespace bodkin
