#include "app/hand/mouse_hand.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "app/hand/needle_control.h"
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin::app {
namespace {

constexpr double dt = 0.001;
constexpr double unease = 0.02;  // mm, the tremor of the hand and its effect on speeds

HandGoal goal_at(const Vec3& at, double depth) {
  HandGoal goal;
  goal.at = at;
  goal.axis = Vec3(0.0, -0.8, 0.6);
  goal.depth = depth;
  goal.is_down = true;
  return goal;
}

MouseHand hand_at_rest(const HandGoal& goal, double seconds = 3.0) {
  MouseHand hand(dt);
  hand.start(goal);
  for (int i = 0; i < seconds / dt; ++i) hand.step(goal, Vec3::Zero());
  return hand;
}

TEST(MouseHand, waits_above_the_skin_until_it_is_put_down) {
  HandGoal goal = goal_at(Vec3(3.0, 20.0, -5.0), 10.0);
  goal.is_down = false;
  const MouseHand hand = hand_at_rest(goal);
  EXPECT_NEAR(hand.report().depth, -MouseHand::waiting, unease);
}

TEST(MouseHand, goes_to_the_wished_depth_without_overshoot) {
  HandGoal goal = goal_at(Vec3(3.0, 20.0, -5.0), 0.3);
  MouseHand hand = hand_at_rest(goal);
  EXPECT_NEAR(hand.report().depth, 0.3, unease);
  goal.depth = 25.0;
  double deepest = 0.0, fastest = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const double before = hand.report().meant.translation().dot(goal.axis);
    hand.step(goal, Vec3::Zero());
    fastest = std::max(fastest, (hand.report().meant.translation().dot(goal.axis) - before) / dt);
    deepest = std::max(deepest, hand.report().depth);
  }
  EXPECT_NEAR(hand.report().depth, 25.0, unease);
  EXPECT_LT(deepest, 25.0 + 0.1);
  EXPECT_LE(fastest, goal.speed + 1e-9);
}

// Clockwise when looking along the needle: a vector to the right turns down, so that right, down and ahead are a
// right-handed system.
TEST(MouseHand, turns_about_the_axis_at_a_human_pace_and_moves_nowhere_else) {
  HandGoal goal = goal_at(Vec3(3.0, 20.0, -5.0), 12.0);
  MouseHand hand = hand_at_rest(goal);
  const Pose before = hand.report().needle;
  goal.turn = 90.0 * degree;
  const auto turned = [&] {
    return Eigen::AngleAxisd(Mat3(before.linear().transpose() * hand.report().needle.linear()));
  };
  for (int i = 0; i < 100; ++i) hand.step(goal, Vec3::Zero());
  EXPECT_NEAR(turned().angle(), 0.1 * MouseHand::twirling_speed, 1e-6);
  for (int i = 0; i < 900; ++i) hand.step(goal, Vec3::Zero());
  EXPECT_NEAR(turned().angle(), 90.0 * degree, 1e-6);
  EXPECT_NEAR(turned().axis().z(), 1.0, 1e-6) << "the third axis points along the needle";
  EXPECT_NEAR((hand.report().needle.translation() - before.translation()).norm(), 0.0, unease);
  EXPECT_NEAR(needle_axis(hand.report().needle).dot(goal.axis.normalized()), 1.0, 1e-9);
}

TEST(NeedleControl, a_key_that_is_held_turns_the_needle_half_a_turn_a_second_but_not_one_that_is_held_still) {
  NeedleControl control;
  control.begin({}, SkinPoint{Vec3::Zero(), Vec3::UnitY()});
  control.hold_turn(1);
  for (int i = 0; i < 60; ++i) control.update(1.0 / 60.0, {});
  EXPECT_NEAR(control.goal().turn, 180.0 * degree, 1e-9);
  control.hold_turn(-1);
  for (int i = 0; i < 30; ++i) control.update(1.0 / 60.0, {});
  EXPECT_NEAR(control.goal().turn, 90.0 * degree, 1e-9);
  control.hold(true);
  control.hold_turn(1);
  control.update(1.0, {});
  EXPECT_NEAR(control.goal().turn, 90.0 * degree, 1e-9);
}

// Braced against the patient: the needle stays in place, and after a drop of 4 N it advances by 0.8 mm, slowly.
TEST(MouseHand, a_braced_hand_gives_way_by_a_fifth_and_slowly) {
  HandGoal goal = goal_at(Vec3(3.0, 20.0, -5.0), 20.0);
  MouseHand hand = hand_at_rest(goal);
  const Vec3 push = -4.0 * goal.axis;
  for (int i = 0; i < 3000; ++i) hand.step(goal, push);
  EXPECT_NEAR(hand.report().depth, 16.0, unease);
  goal.is_braced = true;
  goal.depth = 16.8;
  double least = 16.0, most = 16.0;
  for (int i = 0; i < 3000; ++i) {
    hand.step(goal, push);
    least = std::min(least, hand.report().depth);
    most = std::max(most, hand.report().depth);
  }
  EXPECT_NEAR(least, 16.0, 0.05);
  EXPECT_NEAR(most, 16.0, 0.05);
  double fastest = 0.0;
  for (int i = 0; i < 3000; ++i) {
    hand.step(goal, Vec3::Zero());
    fastest = std::max(fastest, hand.velocity().dot(goal.axis));
  }
  EXPECT_NEAR(hand.report().depth, 16.8, 0.05);
  EXPECT_LT(fastest, 10.0);
}

TEST(MouseHand, a_resistance_holds_the_needle_back_by_a_millimetre_per_newton) {
  const HandGoal goal = goal_at(Vec3::Zero(), 20.0);
  MouseHand hand = hand_at_rest(goal);
  const Vec3 resistance = -4.0 * goal.axis;
  for (int i = 0; i < 2000; ++i) hand.step(goal, resistance);
  EXPECT_NEAR(hand.report().depth, 20.0 - 4.0 / MouseHand::stiffness, unease);
  EXPECT_NEAR((hand.report().meant.translation() - 20.0 * goal.axis).norm(), 0.0, 1e-3);
}

TEST(MouseHand, does_not_yield_across_its_axis) {
  const HandGoal goal = goal_at(Vec3::Zero(), 20.0);
  MouseHand hand = hand_at_rest(goal);
  const Vec3 across = goal.axis.unitOrthogonal();
  for (int i = 0; i < 500; ++i) hand.step(goal, 3.0 * across);
  EXPECT_NEAR(across.dot(hand.report().needle.translation()), 0.0, unease);
}

TEST(MouseHand, a_needle_in_tissue_comes_out_before_it_goes_elsewhere) {
  HandGoal goal = goal_at(Vec3::Zero(), 20.0);
  MouseHand hand = hand_at_rest(goal);
  goal.at = Vec3(30.0, 0.0, 0.0);
  while (hand.report().depth > 0.0) {
    hand.step(goal, Vec3::Zero());
    const Vec3 tip = hand.report().needle.translation();
    ASSERT_LT((tip - goal.axis * goal.axis.dot(tip)).norm(), unease) << "moved sideways in tissue";
  }
  for (int i = 0; i < 5000; ++i) hand.step(goal, Vec3::Zero());
  EXPECT_NEAR((hand.report().needle.translation() - (goal.at + 20.0 * goal.axis)).norm(), 0.0, 2.0 * unease);
}

TEST(MouseHand, the_axis_turns_about_the_skin_while_shallow_and_never_deeper) {
  HandGoal goal = goal_at(Vec3::Zero(), 5.0);
  MouseHand shallow = hand_at_rest(goal);
  HandGoal turned = goal;
  turned.axis = Vec3(0.1, -0.8, 0.6).normalized();
  for (int i = 0; i < 2000; ++i) shallow.step(turned, Vec3::Zero());
  EXPECT_NEAR((needle_axis(shallow.report().needle) - turned.axis).norm(), 0.0, 1e-3);
  goal.depth = turned.depth = 20.0;
  MouseHand deep = hand_at_rest(goal);
  for (int i = 0; i < 2000; ++i) deep.step(turned, Vec3::Zero());
  EXPECT_NEAR((needle_axis(deep.report().needle) - goal.axis).norm(), 0.0, 1e-3);
}

// For any input by pointer, wheel and keys, and however tightly the tissue holds the needle, also while it is
// withdrawn: in tissue it stays on the line through its entry, and deeper than a centimetre it keeps its axis.
TEST(MouseHand, keeps_its_line_in_tissue_whatever_is_wished) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    const auto chance = [&random](double size) {
      return Vec3(size * random.normal(), size * random.normal(), size * random.normal());
    };
    HandGoal goal = goal_at(chance(10.0), 5.0);
    MouseHand hand = hand_at_rest(goal);
    HandReport last = hand.report();
    double grip = 0.0;  // N
    int ticks_in_tissue = 0, turns = 0;
    for (int i = 0; i < 60'000; ++i) {
      if (random.uniform() < 0.002) goal.depth = -20.0 + 60.0 * random.uniform();
      if (random.uniform() < 0.001) goal.at += chance(10.0);
      if (random.uniform() < 0.002) goal.axis = (goal.axis + chance(0.2)).normalized();
      if (random.uniform() < 0.001) goal.is_down = random.uniform() < 0.8;
      if (random.uniform() < 0.001) goal.is_braced = random.uniform() < 0.5;
      if (random.uniform() < 0.005) grip = 20.0 * random.uniform();
      const Vec3 axis = needle_axis(last.meant);
      const double pulls = axis.dot(last.meant.translation() - last.needle.translation());
      hand.step(goal, last.depth > 0.0 ? Vec3(-std::clamp(pulls, -grip, grip) * axis) : Vec3(chance(0.1)));
      const HandReport& now = hand.report();
      if (last.depth > 0.0) {
        ++ticks_in_tissue;
        const Vec3 new_axis = needle_axis(now.meant);
        const Vec3 skin = last.meant.translation() - axis.dot(last.meant.translation()) * axis;
        const Vec3 new_skin = now.meant.translation() - axis.dot(now.meant.translation()) * axis;
        if (last.depth > MouseHand::shallow) {
          ASSERT_TRUE(new_axis == axis) << "seed " << seed << ", tick " << i;
          ASSERT_LT((new_skin - skin).norm(), 1e-9) << "seed " << seed << ", tick " << i;
        }
        turns += new_axis == axis ? 0 : 1;
      }
      last = now;
    }
    EXPECT_GT(ticks_in_tissue, 5000);
    EXPECT_GT(turns, 10);
  }
}

class Control : public testing::Test {
 protected:
  Control() {
    control_.begin(anatomy::NeedlePath{Vec3::Zero(), Vec3(0.0, -60.0, 0.0)}, {Vec3::Zero(), Vec3::UnitY()});
  }
  void at_depth(double depth) {
    HandReport hand;
    hand.depth = depth;
    hand.meant = needle_pose(control_.goal().at + depth * control_.goal().axis, control_.goal().axis);
    control_.update(0.016, hand);
  }
  NeedleControl control_;
};

TEST_F(Control, the_first_notch_brings_the_tip_to_the_skin) {
  EXPECT_FALSE(control_.is_down());
  control_.push(1.0, false);
  EXPECT_TRUE(control_.is_down());
  EXPECT_GT(control_.goal().depth, 0.0);
  EXPECT_LT(control_.goal().depth, 1.0);
}

TEST_F(Control, a_notch_out_of_the_air_does_nothing) {
  control_.push(-3.0, false);
  EXPECT_FALSE(control_.is_down());
}

TEST_F(Control, notches_are_half_a_millimetre_and_fine_ones_a_tenth) {
  control_.put_down();
  const double before = control_.goal().depth;
  control_.push(1.0, false);
  EXPECT_NEAR(control_.goal().depth - before, 0.5, 1e-12);
  control_.push(1.0, true);
  EXPECT_NEAR(control_.goal().depth - before, 0.6, 1e-12);
}

TEST_F(Control, the_hand_does_not_run_away_from_a_needle_that_stays) {
  control_.put_down();
  at_depth(12.0);
  control_.push(1000.0, false);
  EXPECT_NEAR(control_.goal().depth, 12.0 + NeedleControl::lead, 1e-12);
}

TEST_F(Control, the_pointer_moves_no_needle_that_is_down) {
  control_.put_down();
  const Vec3 at = control_.goal().at;
  control_.aim({Vec3(10.0, 0.0, 0.0), Vec3::UnitY()});
  EXPECT_EQ(control_.goal().at, at);
}

TEST_F(Control, tilting_deeper_than_a_centimetre_is_refused) {
  control_.put_down();
  at_depth(5.0);
  EXPECT_TRUE(control_.tilt(0.1, 0.0));
  at_depth(11.0);
  const Vec3 axis = control_.goal().axis;
  EXPECT_FALSE(control_.tilt(0.1, 0.0));
  EXPECT_EQ(control_.goal().axis, axis);
}

TEST_F(Control, a_tilt_near_the_plan_takes_its_direction) {
  control_.put_down();
  EXPECT_TRUE(control_.tilt(0.2, 0.0));
  EXPECT_GT((control_.goal().axis + Vec3::UnitY()).norm(), 0.1);
  EXPECT_TRUE(control_.tilt(-0.2 + 0.5 * degree, 0.0));
  EXPECT_NEAR((control_.goal().axis + Vec3::UnitY()).norm(), 0.0, 1e-12);
}

TEST_F(Control, a_withdrawn_needle_is_free_again) {
  control_.put_down();
  at_depth(20.0);
  control_.withdraw();
  EXPECT_LT(control_.goal().depth, 0.0);
  at_depth(3.0);
  EXPECT_TRUE(control_.is_down());
  at_depth(-5.0);
  EXPECT_FALSE(control_.is_down());
}

TEST_F(Control, a_held_needle_takes_no_push) {
  control_.put_down();
  at_depth(8.0);
  control_.push(6.0, false);
  control_.hold(true);
  const double depth = control_.goal().depth;
  EXPECT_NEAR(depth, 8.0, 1e-9) << "it stays where it is, not where it was on its way to";
  control_.push(5.0, false);
  control_.withdraw();
  EXPECT_EQ(control_.goal().depth, depth);
  control_.hold(false);
  control_.push(1.0, false);
  EXPECT_NEAR(control_.goal().depth, depth + 0.5, 1e-12);
}

}  // namespace
}  // namespace bodkin::app
