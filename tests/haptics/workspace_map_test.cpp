#include "haptics/workspace_map.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

Mat3 any_rotation(Random& random) {
  const Vec3 axis = Vec3(random.normal(), random.normal(), random.normal()).normalized();
  return Eigen::AngleAxisd(random.uniform(0.0, 3.0), axis).toRotationMatrix();
}

Pose any_hand(Random& random) {
  Pose hand = Pose::Identity();
  hand.linear() = any_rotation(random);
  hand.translation() = Vec3(random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0));
  return hand;
}

WorkspaceSettings any_settings(Random& random, double scale = 1.0) {
  WorkspaceSettings settings;
  settings.rotation = any_rotation(random);
  settings.centre = Vec3(random.uniform(-300.0, 300.0), random.uniform(-300.0, 300.0), 40.0);
  settings.scale = scale;
  settings.tool_rotation = any_rotation(random);
  settings.tip_offset = Vec3(3.0, -4.0, 39.0);
  return settings;
}

double difference(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

TEST(WorkspaceMap, puts_the_middle_of_the_workspace_at_the_centre_and_scales_about_it) {
  WorkspaceSettings settings;
  settings.centre = Vec3(10.0, 20.0, 30.0);
  settings.scale = 2.0;
  // Operator's +Y (away) is the patient's +Z here.
  settings.rotation = Eigen::AngleAxisd(std::acos(0.0), Vec3::UnitX()).toRotationMatrix();
  WorkspaceMap map(settings);
  EXPECT_LT((map.step(Pose::Identity(), 0.001).translation() - Vec3(10.0, 20.0, 30.0)).norm(), 1e-12);
  Pose away = Pose::Identity();
  away.translation().y() = 5.0;
  EXPECT_LT((map.step(away, 0.001).translation() - Vec3(10.0, 20.0, 40.0)).norm(), 1e-12);
  EXPECT_LT((needle_axis(map.needle()) - Vec3(0.0, -1.0, 0.0)).norm(), 1e-12) << "the tool's z, turned";
}

TEST(WorkspaceMap, the_tip_is_where_the_offset_says_and_the_tool_rotation_turns_the_needle) {
  WorkspaceSettings settings;
  settings.tip_offset = Vec3(0.0, 0.0, -39.0);  // the tip lies behind the reported point
  settings.tool_rotation = Eigen::AngleAxisd(2.0 * std::acos(0.0), Vec3::UnitX()).toRotationMatrix();
  WorkspaceMap map(settings);
  const Pose needle = map.step(Pose::Identity(), 0.001);
  EXPECT_LT((needle.translation() - Vec3(0.0, 0.0, -39.0)).norm(), 1e-12);
  EXPECT_LT((needle_axis(needle) + Vec3::UnitZ()).norm(), 1e-12);
}

TEST(WorkspaceMap, the_pose_stays_rigid_and_there_and_back_is_the_identity) {
  Random random(4);
  for (int round = 0; round < 200; ++round) {
    const WorkspaceSettings settings = any_settings(random, random.uniform(0.2, 5.0));
    WorkspaceMap map(settings);
    const Pose hand = any_hand(random);
    const Pose needle = map.step(hand, 0.001);
    EXPECT_LT((needle.linear().transpose() * needle.linear() - Mat3::Identity()).cwiseAbs().maxCoeff(), 1e-12);
    const Mat3 turn = settings.rotation.transpose() * needle.linear() * settings.tool_rotation.transpose();
    const Vec3 place = settings.rotation.transpose() * (needle.translation() - settings.centre) / settings.scale -
                       turn * settings.tip_offset;
    EXPECT_LT((turn - hand.linear()).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((place - hand.translation()).norm(), 1e-9);
  }
}

// The hand's power equals the needle's, with or without a re-grasp on the way.
TEST(WorkspaceMap, the_hands_work_is_the_needles_work_at_scale_one) {
  Random random(9);
  for (int round = 0; round < 100; ++round) {
    WorkspaceMap map(any_settings(random));
    Pose hand = any_hand(random);
    map.step(hand, 0.001);
    if (round % 2 == 1) {
      map.freeze(true);
      map.step(any_hand(random), 0.001);
      map.freeze(false);
      map.step(hand, 0.001);
    }
    const Wrench on_needle{Vec3(random.normal(), random.normal(), random.normal()),
                           Vec3(random.normal(), random.normal(), 100.0 * random.normal())};
    const Wrench felt = map.felt(on_needle);
    const Pose before = map.needle();
    // A small motion in one step: the error is of second order.
    const double small = 1e-6;
    const Vec3 way = small * Vec3(random.normal(), random.normal(), random.normal());
    const Vec3 turn = small * Vec3(random.normal(), random.normal(), random.normal());
    Pose moved = hand;
    moved.translation() += way;
    moved.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * hand.linear();
    const Pose after = map.step(moved, 0.001);
    const Eigen::AngleAxisd turned(Mat3(after.linear() * before.linear().transpose()));
    const double of_hand = felt.force.dot(way) + felt.torque.dot(turn);
    const double of_needle = on_needle.force.dot(after.translation() - before.translation()) +
                             on_needle.torque.dot(turned.axis() * turned.angle());
    EXPECT_NEAR(of_hand, of_needle, 1e-8) << round;
  }
}

TEST(WorkspaceMap, scales_are_separate_and_the_hand_does_their_ratio_of_the_work) {
  Random random(2);
  WorkspaceSettings settings;
  settings.scale = 2.0;
  settings.force_scale = 0.25;
  WorkspaceMap map(settings);
  EXPECT_EQ(map.stiffness_factor(), 0.5);
  map.step(Pose::Identity(), 0.001);
  const Wrench felt = map.felt({Vec3(0.0, 0.0, -8.0), Vec3(40.0, 0.0, 0.0)});
  EXPECT_EQ(felt.force, Vec3(0.0, 0.0, -2.0));
  EXPECT_EQ(felt.torque, Vec3(10.0, 0.0, 0.0));
  Pose hand = Pose::Identity();
  hand.translation().z() = 3.0;
  const double needle_work = -8.0 * map.step(hand, 0.001).translation().z();
  EXPECT_NEAR(-2.0 * 3.0, needle_work * 0.25 / 2.0, 1e-12);
}

TEST(WorkspaceMap, a_frozen_needle_stays_and_is_not_felt_and_does_not_jump_when_it_is_grasped_again) {
  Random random(6);
  for (int round = 0; round < 100; ++round) {
    WorkspaceMap map(any_settings(random, random.uniform(0.5, 2.0)));
    map.step(any_hand(random), 0.001);
    const Pose stays = map.needle();
    map.freeze(true);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(difference(map.step(any_hand(random), 0.001), stays), 0.0);
    EXPECT_TRUE(map.felt({Vec3(1.0, 2.0, 3.0), Vec3(1.0, 0.0, 0.0)}).force.isZero(0.0));
    map.freeze(false);
    const Pose hand = any_hand(random);
    EXPECT_LT(difference(map.step(hand, 0.001), stays), 1e-9);
    // From now on it follows the hand as before.
    Pose moved = hand;
    moved.translation() += Vec3(1.0, 2.0, 3.0);
    const Vec3 expected = map.settings().rotation * (map.settings().scale * Vec3(1.0, 2.0, 3.0));
    EXPECT_LT((map.step(moved, 0.001).translation() - stays.translation() - expected).norm(), 1e-9);
    EXPECT_FALSE(map.felt({Vec3(1.0, 2.0, 3.0), Vec3::Zero()}).force.isZero(0.0));
  }
}

TEST(WorkspaceMap, the_clutch_brings_a_small_workspace_on_without_a_jump) {
  WorkspaceMap map(WorkspaceSettings{});
  double needle = 0.0;
  for (int stroke = 0; stroke < 4; ++stroke) {  // in by 30 mm, back with the clutch, again
    for (int i = 0; i <= 300; ++i) {
      Pose hand = Pose::Identity();
      hand.translation().z() = 0.1 * i;
      const double tip = map.step(hand, 0.001).translation().z();
      EXPECT_LE(std::abs(tip - needle), 0.1 + 1e-9) << stroke << ' ' << i;
      needle = tip;
    }
    map.clutch(true);
    for (int i = 300; i >= 0; --i) {
      Pose hand = Pose::Identity();
      hand.translation().z() = 0.1 * i;
      hand.linear() = Eigen::AngleAxisd(0.002 * i, Vec3::UnitX()).toRotationMatrix();
      EXPECT_EQ(map.step(hand, 0.001).translation().z(), needle);
    }
    map.clutch(false);
  }
  EXPECT_NEAR(needle, 120.0, 1e-9);
}

TEST(WorkspaceMap, the_needle_is_free_only_when_every_hold_has_ended) {
  WorkspaceMap map(WorkspaceSettings{});
  map.step(Pose::Identity(), 0.001);
  map.freeze(true);
  map.clutch(true);
  map.clutch(false);
  Pose hand = Pose::Identity();
  hand.translation().x() = 20.0;
  EXPECT_TRUE(map.step(hand, 0.001).translation().isZero(0.0));
  EXPECT_TRUE(map.is_held());
}

TEST(WorkspaceMap, a_body_that_is_moved_glides_and_a_frozen_needle_goes_with_it) {
  WorkspaceMap map(WorkspaceSettings{});
  map.step(Pose::Identity(), 0.001);
  const Mat3 turned = Eigen::AngleAxisd(0.3, Vec3::UnitZ()).toRotationMatrix();
  map.move_body(Vec3(0.0, 0.0, 20.0), turned);
  Vec3 last = Vec3::Zero();
  int ticks = 0;
  do {
    const Vec3 tip = map.step(Pose::Identity(), 0.001).translation();
    EXPECT_LE((tip - last).norm(), 0.05 + 1e-9);
    last = tip;
  } while (map.is_body_moving() && ++ticks < 5000);
  EXPECT_NEAR(ticks, 600, 3) << "the turn takes longer than the way";
  EXPECT_LT((last - Vec3(0.0, 0.0, 20.0)).norm(), 1e-12);
  EXPECT_LT((map.needle().linear() - turned).cwiseAbs().maxCoeff(), 1e-12);

  map.freeze(true);
  map.move_body(Vec3(50.0, 0.0, 20.0), Mat3::Identity());
  for (int i = 0; i < 2000; ++i) map.step(Pose::Identity(), 0.001);
  EXPECT_FALSE(map.is_body_moving());
  EXPECT_LT((map.needle().translation() - last).norm(), 1e-12) << "where it is in the body";
  map.freeze(false);
  EXPECT_LT((map.step(Pose::Identity(), 0.001).translation() - last).norm(), 1e-9);
}

// Moving tissue carries along a released needle; the hand takes it up at its new place.
TEST(WorkspaceMap, a_held_needle_is_carried_and_one_in_the_hand_is_not) {
  Random random(19);
  for (int trial = 0; trial < 20; ++trial) {
    WorkspaceMap map(any_settings(random, random.uniform(0.5, 2.0)));
    const Pose hand = any_hand(random);
    map.carry(Vec3(1.0, 2.0, 3.0));
    const Pose before = map.step(hand, 0.001);
    map.carry(Vec3(1.0, 2.0, 3.0));
    ASSERT_LT(difference(map.step(hand, 0.001), before), 1e-12);
    (trial % 2 == 0) ? map.freeze(true) : map.clutch(true);
    map.step(any_hand(random), 0.001);
    map.carry(Vec3(0.5, -1.0, 4.0));
    map.carry(Vec3(0.0, std::nan(""), 0.0));
    Pose carried = before;
    carried.translation() += Vec3(0.5, -1.0, 4.0);
    ASSERT_LT(difference(map.step(any_hand(random), 0.001), carried), 1e-12);
    map.freeze(false);
    map.clutch(false);
    ASSERT_LT(difference(map.step(any_hand(random), 0.001), carried), 1e-9) << "without a jump";
  }
}

// It turns with the tissue about its tip, many small turns keep it a rotation, and the hand takes it up in its new
// pose.
TEST(WorkspaceMap, a_held_needle_turns_with_the_tissue) {
  Random random(20);
  WorkspaceMap map(any_settings(random, 1.3));
  const Pose hand = any_hand(random);
  const Pose held = map.step(hand, 0.001);
  const Mat3 turn = Eigen::AngleAxisd(1e-3, Vec3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  map.carry(Vec3::Zero(), turn);
  ASSERT_LT(difference(map.step(hand, 0.001), held), 1e-12) << "a hand holds it";
  map.freeze(true);
  map.step(any_hand(random), 0.001);
  constexpr int turns = 20000;
  for (int i = 0; i < turns; ++i) map.carry(Vec3(1e-3, 0.0, 0.0), turn);
  map.carry(Vec3::Zero(), Mat3::Zero());
  map.carry(Vec3::Zero(), -Mat3::Identity());
  Pose expected = held;
  expected.translation() += Vec3(1e-3 * turns, 0.0, 0.0);
  expected.linear() =
      Eigen::AngleAxisd(1e-3 * turns, Vec3(1.0, -2.0, 0.5).normalized()).toRotationMatrix() * held.linear();
  ASSERT_LT(difference(map.step(any_hand(random), 0.001), expected), 1e-9);
  EXPECT_LT((map.needle().linear().transpose() * map.needle().linear() - Mat3::Identity()).norm(), 1e-14);
  map.freeze(false);
  ASSERT_LT(difference(map.step(any_hand(random), 0.001), expected), 1e-9) << "without a jump";
}

TEST(WorkspaceMap, a_body_moved_to_nowhere_stays) {
  WorkspaceMap map(WorkspaceSettings{});
  map.move_body(Vec3(std::nan(""), 0.0, 0.0), Mat3::Identity());
  map.move_body(Vec3(1.0, 0.0, 0.0), Mat3::Zero());
  EXPECT_FALSE(map.is_body_moving());
  EXPECT_TRUE(map.step(Pose::Identity(), 0.001).translation().isZero(0.0));
}

TEST(WorkspaceMap, settings_that_cannot_be_are_refused_in_a_sentence) {
  WorkspaceSettings settings;
  settings.scale = 0.0;
  try {
    const WorkspaceMap map(settings);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "workspace: scale is 0, expected 0.1 to 10");
  }
  settings = {};
  settings.rotation.col(0) *= -1.0;
  EXPECT_THROW(WorkspaceMap{settings}, InputError);
  settings = {};
  settings.tool_rotation.setZero();
  EXPECT_THROW(WorkspaceMap{settings}, InputError);
  settings = {};
  settings.force_scale = std::nan("");
  EXPECT_THROW(WorkspaceMap{settings}, InputError);
  settings = {};
  settings.tip_offset.x() = std::nan("");
  EXPECT_THROW(WorkspaceMap{settings}, InputError);
}

}  // namespace
}  // namespace bodkin
