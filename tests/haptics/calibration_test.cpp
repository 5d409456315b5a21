#include "haptics/calibration.h"

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

using ::testing::HasSubstr;

Pose placed(const Vec3& position, const Mat3& turn = Mat3::Identity()) {
  Pose hand = Pose::Identity();
  hand.translation() = position;
  hand.linear() = turn;
  return hand;
}

Mat3 turned(double about_x, double about_y, double about_z = 0.0) {
  return (Eigen::AngleAxisd(about_z * degree, Vec3::UnitZ()) * Eigen::AngleAxisd(about_y * degree, Vec3::UnitY()) *
          Eigen::AngleAxisd(about_x * degree, Vec3::UnitX()))
      .toRotationMatrix();
}

template <typename Work>
std::string refusal_of(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// The tool swivelled about its tip, which stands at `place`.
std::vector<Pose> swivelled(const Vec3& offset, const Vec3& place, double degrees, double noise) {
  Random random(3);
  std::vector<Pose> readings;
  for (int i = 0; i < 400; ++i) {
    const double phase = 0.1 * i;
    const Mat3 turn =
        turned(degrees * std::sin(phase), degrees * std::cos(0.7 * phase), 15.0 * std::sin(0.3 * phase));
    const Vec3 error = noise * Vec3(random.normal(), random.normal(), random.normal());
    readings.push_back(placed(place - turn * offset + error, turn));
  }
  return readings;
}

TEST(Calibration, a_tip_in_a_dimple_is_found_to_the_rounding) {
  const Vec3 offset(1.5, -2.0, 39.0), place(10.0, 120.0, -30.0);
  const TipFit fit = tip_of(swivelled(offset, place, 30.0, 0.0));
  EXPECT_NEAR((fit.offset - offset).norm(), 0.0, 1e-10);
  EXPECT_NEAR((fit.place - place).norm(), 0.0, 1e-10);
  EXPECT_NEAR(fit.residual, 0.0, 1e-10);
}

TEST(Calibration, noise_of_the_encoders_shows_as_the_residual) {
  const Vec3 offset(0.0, 0.0, 39.0);
  const TipFit fit = tip_of(swivelled(offset, {0.0, 0.0, 0.0}, 30.0, 0.1));
  EXPECT_NEAR((fit.offset - offset).norm(), 0.0, 0.1);
  EXPECT_NEAR(fit.residual, 0.1 * std::sqrt(3.0), 0.02);
}

TEST(Calibration, a_tip_that_cannot_be_told_is_refused) {
  EXPECT_THAT(refusal_of([] { tip_of(swivelled({0, 0, 39}, {0, 0, 0}, 3.0, 0.0)); }), HasSubstr("swivel it wider"));
  EXPECT_THAT(refusal_of([] { tip_of(swivelled({0, 0, 39}, {0, 0, 0}, 30.0, 4.0)); }), HasSubstr("into a dimple"));
  EXPECT_THAT(refusal_of([] { tip_of(std::vector<Pose>(3, Pose::Identity())); }), HasSubstr("gave 3 readings"));
  std::vector<Pose> about_one_axis;
  for (int i = 0; i < 100; ++i) about_one_axis.push_back(placed(Vec3::Zero(), turned(60.0 * std::sin(0.1 * i), 0.0)));
  EXPECT_THAT(refusal_of([&] { tip_of(about_one_axis); }), HasSubstr("about two axes"));
}

TEST(Calibration, the_tool_that_points_down_has_its_axis_there) {
  // The device's tool axes are turned so that their X points down.
  const std::vector<Pose> readings(50, placed({1, 2, 3}, turned(0.0, 90.0)));
  const Vec3 axis = tool_axis_of(readings);
  EXPECT_NEAR((readings[0].linear() * axis + Vec3::UnitZ()).norm(), 0.0, 1e-12);
  std::vector<Pose> unsteady = readings;
  unsteady.push_back(placed({1, 2, 3}, turned(0.0, 97.0)));
  EXPECT_THAT(refusal_of([&] { tool_axis_of(unsteady); }), HasSubstr("hold it still"));
}

TEST(Calibration, a_device_that_stands_turned_is_turned_back) {
  // Its "away" points to the operator's right: the hand goes away, the device says to the left.
  std::vector<Pose> readings;
  for (int i = 0; i <= 60; ++i) readings.push_back(placed({-1.0 * i, 0.02 * i, 5.0}));
  ServoSettings settings;
  DeviceCalibration calibration;
  calibration.mounting = mounting_of(readings);
  apply(calibration, settings);
  const Vec3 seen = settings.workspace.rotation * Vec3(-1.0, 0.02, 0.0).normalized();
  EXPECT_NEAR((seen - Vec3::UnitY()).norm(), 0.0, 1e-12);
  EXPECT_THAT(refusal_of([] { mounting_of(std::vector<Pose>(50, Pose::Identity())); }), HasSubstr("expected 40 mm"));
  readings.push_back(placed({-30.0, 25.0, 0.0}));
  EXPECT_THAT(refusal_of([&] { mounting_of(readings); }), HasSubstr("to the side"));
}

TEST(Calibration, the_reach_is_the_box_and_its_middle_the_middle) {
  std::vector<Pose> readings;
  for (int i = 0; i < 8; ++i) {
    for (int again = 0; again < 5; ++again) {
      readings.push_back(
          placed({(i & 1) != 0 ? 60.0 : -40.0, (i & 2) != 0 ? 30.0 : -30.0, (i & 4) != 0 ? 90.0 : 10.0}));
    }
  }
  DeviceCalibration calibration;
  calibration.reach = reach_of(readings);
  DeviceAbilities abilities;
  apply(calibration, abilities);
  EXPECT_EQ(abilities.workspace_low, Vec3(-40.0, -30.0, 10.0));
  EXPECT_EQ(abilities.workspace_high, Vec3(60.0, 30.0, 90.0));
  ServoSettings settings;
  settings.workspace.centre = {7.0, 8.0, 9.0};
  apply(calibration, settings);
  WorkspaceMap map(settings.workspace);
  EXPECT_EQ(map.step(placed({10.0, 0.0, 50.0}), 0.001).translation(), Vec3(7.0, 8.0, 9.0));
  EXPECT_THAT(refusal_of([] { reach_of(std::vector<Pose>(50, Pose::Identity())); }), HasSubstr("every corner"));
}

TEST(Calibration, the_needle_lies_where_tip_and_axis_say) {
  DeviceCalibration calibration;
  calibration.tip_offset = Vec3(-39.0, 0.0, 0.0);
  calibration.tool_axis = Vec3(-1.0, 0.0, 0.0);
  calibration.weight = 0.4;
  ServoSettings settings;
  apply(calibration, settings);
  EXPECT_EQ(settings.weight, 0.4);
  WorkspaceMap map(settings.workspace);
  const Pose needle = map.step(placed({100.0, 0.0, 0.0}), 0.001);
  EXPECT_NEAR((needle.translation() - Vec3(61.0, 0.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((needle_axis(needle) - Vec3(-1.0, 0.0, 0.0)).norm(), 0.0, 1e-12);
}

TEST(Calibration, weight_and_friction_come_from_lifting_and_lowering) {
  const WeightFit fit = weight_of(0.9, 0.7);
  EXPECT_NEAR(fit.weight, 0.8, 1e-12);
  EXPECT_NEAR(fit.friction, 0.1, 1e-12);
  EXPECT_EQ(weight_of(0.06, -0.05).weight, 0.0) << "a device that carries itself";
  EXPECT_THAT(refusal_of([] { weight_of(9.0, 8.0); }), HasSubstr("expected 0 to 5 N"));
  EXPECT_THAT(refusal_of([] { weight_of(-1.0, -1.2); }), HasSubstr("expected 0 to 5 N"));
  EXPECT_THAT(refusal_of([] { weight_of(3.0, -2.5); }), HasSubstr("leave it alone"));
}

}  // namespace
}  // namespace bodkin
