// A device registered to a mannequin: the position of its tip on the mannequin is that of the needle in the patient.
#include "station/mannequin_place.h"

#include <random>

#include <gtest/gtest.h>

#include "haptics/calibration.h"

namespace bodkin::station {
namespace {

Pose random_pose(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
                      .normalized()
                      .toRotationMatrix();
  pose.translation() = 50.0 * Vec3(normal(random), normal(random), normal(random));
  return pose;
}

TEST(MannequinPlace, the_tip_is_in_the_patient_where_it_is_on_the_mannequin) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const MannequinPlace place{random_pose(random), false};
    haptics::DeviceCalibration calibration;
    calibration.tip_offset = Vec3(3.0, -120.0, 15.0);
    calibration.tool_axis = Vec3(0.1, -1.0, 0.2).normalized();
    calibration.mounting = 0.7;  // already included in the registration
    calibration.reach = {Vec3(-50, -20, -40), Vec3(90, 60, 70)};
    haptics::ServoSettings servo;
    haptics::apply(calibration, servo);
    place_on(place, 90.0, servo.workspace);
    const Pose hand = random_pose(random);
    haptics::WorkspaceMap map(servo.workspace);
    const Pose needle = map.step(hand, 0.001);
    EXPECT_LT((needle.translation() - place.patient_from_hand * (hand * *calibration.tip_offset)).norm(), 1e-9);
    const Vec3 axis = place.patient_from_hand.linear() * hand.linear() * *calibration.tool_axis;
    EXPECT_LT((needle.linear().col(2) - axis).norm(), 1e-9);

    // A hub instead: for the same hand, the needle's tip lies one needle length in front of the hub.
    haptics::ServoSettings of_hub;
    haptics::apply(calibration, of_hub);
    place_on({place.patient_from_hand, true}, 90.0, of_hub.workspace);
    haptics::WorkspaceMap hub_map(of_hub.workspace);
    const Pose in_front = hub_map.step(hand, 0.001);
    EXPECT_LT((in_front.translation() - needle.translation() - 90.0 * axis).norm(), 1e-9);
  }
}

TEST(TouchFit, finds_a_point_on_which_the_tool_turns_and_refuses_one_that_moves) {
  std::mt19937 random(3);
  std::normal_distribution<double> tremor(0.0, 0.2);
  const Vec3 offset(0.0, -100.0, 10.0), hole(20.0, 35.0, -60.0);
  std::vector<Pose> readings;
  for (int i = 0; i < 500; ++i) {
    Pose hand = random_pose(random);
    hand.translation() = hole + Vec3(tremor(random), tremor(random), tremor(random)) - hand.linear() * offset;
    readings.push_back(hand);
  }
  const haptics::TouchFit fit = haptics::touch_of(readings, offset);
  EXPECT_LT((fit.place - hole).norm(), 0.05);
  EXPECT_NEAR(fit.spread, 0.2 * std::sqrt(3.0), 0.03);
  for (std::size_t i = 0; i < readings.size(); ++i)
    readings[i].translation() += Vec3(0.01 * static_cast<double>(i), 0, 0);
  EXPECT_THROW(haptics::touch_of(readings, offset), InputError);
  EXPECT_THROW(haptics::touch_of({}, offset), InputError);
}

}  // namespace
}  // namespace bodkin::station
