// Poses computed from a known tip, so that the answer is known.
#include "tracking/pivot_calibration.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin::tracking {
namespace {

using testing::HasSubstr;

const Vec3 true_tip(2.0, -3.0, 148.0), true_pivot(40.0, 60.0, 520.0);

// A body tilted in all directions about its tip, `cone` degrees to each side, with noise in its position.
std::vector<TimedPose> pivoted(int count, double cone, double noise, double seconds = 20.0) {
  Random random(7);
  std::vector<TimedPose> poses;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / count, round = 12.0 * share;
    TimedPose pose;
    pose.time = seconds * share;
    const double tilt = cone * degree * std::sin(2.5 * round);
    pose.camera_from_body.linear() =
        (Eigen::AngleAxisd(tilt, Vec3(std::cos(round), std::sin(round), 0.0)) * Eigen::AngleAxisd(0.3, Vec3::UnitX()))
            .toRotationMatrix();
    const double x = random.normal(), y = random.normal(), z = random.normal();
    pose.camera_from_body.translation() =
        true_pivot - pose.camera_from_body.linear() * true_tip + noise * Vec3(x, y, z);
    poses.push_back(pose);
  }
  return poses;
}

TEST(PivotCalibration, finds_the_tip_exactly_without_noise) {
  const PivotCalibration made = calibrate_pivot(pivoted(200, 30.0, 0.0));
  EXPECT_LT((made.tip - true_tip).norm(), 1e-8);
  EXPECT_LT((made.pivot - true_pivot).norm(), 1e-8);
  EXPECT_LT(made.rms, 1e-8);
  EXPECT_NEAR(made.cone, 60.0, 3.0);
}

TEST(PivotCalibration, its_residual_is_the_noise_and_its_deviation_the_error) {
  const PivotCalibration made = calibrate_pivot(pivoted(400, 30.0, 0.1));
  // The length of a vector of three normal numbers: RMS sqrt(3), mean sqrt(8 / pi) standard deviations.
  EXPECT_NEAR(made.rms, 0.1 * std::sqrt(3.0), 0.015);
  EXPECT_NEAR(made.mean, 0.1 * std::sqrt(8.0 / 3.14159265), 0.015);
  EXPECT_LT((made.tip - true_tip).norm(), 3.0 * made.deviation);
  EXPECT_LT(made.deviation, 0.05);
}

TEST(PivotCalibration, a_slipped_tip_and_wrong_poses_are_left_out) {
  std::vector<TimedPose> poses = pivoted(300, 30.0, 0.05);
  for (std::size_t i = 100; i < 130; ++i) poses[i].camera_from_body.translation() += Vec3(4.0, 0.0, 3.0);
  const PivotCalibration made = calibrate_pivot(poses);
  EXPECT_GE(made.outliers, 30);
  EXPECT_GE(made.used, 250);
  EXPECT_LT((made.tip - true_tip).norm(), 0.05);
}

TEST(PivotCalibration, fast_poses_do_not_count) {
  // The same tilts in two seconds are mostly faster than 90 degrees/s.
  const std::vector<TimedPose> poses = pivoted(300, 30.0, 0.05, 2.0);
  try {
    const PivotCalibration made = calibrate_pivot(poses);
    EXPECT_GT(made.too_fast, 100);
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("more slowly"));
  }
  EXPECT_EQ(calibrate_pivot(pivoted(300, 30.0, 0.05)).too_fast, 0);
}

TEST(PivotCalibration, refuses_what_leaves_the_tip_open) {
  EXPECT_THROW(calibrate_pivot(pivoted(200, 8.0, 0.05)), InputError);
  EXPECT_THROW(calibrate_pivot(pivoted(10, 30.0, 0.05)), InputError);
  std::vector<TimedPose> one_axis;
  for (int i = 0; i < 100; ++i) {
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::AngleAxisd(0.01 * i, Vec3::UnitX()).toRotationMatrix();
    pose.translation() = true_pivot - pose.linear() * true_tip;
    one_axis.push_back({0.1 * i, pose});
  }
  EXPECT_THROW(calibrate_pivot(one_axis), InputError);
}

std::vector<TimedPose> spun(double turned, double noise) {
  const Vec3 axis = Vec3(0.02, -0.05, 1.0).normalized();
  Random random(11);
  std::vector<TimedPose> poses;
  for (int i = 0; i < 200; ++i) {
    const double x = random.normal(), y = random.normal(), z = random.normal();
    Pose pose = Pose::Identity();
    const Mat3 jitter = (Eigen::AngleAxisd(noise * x, Vec3::UnitX()) * Eigen::AngleAxisd(noise * y, Vec3::UnitY()) *
                         Eigen::AngleAxisd(noise * z, Vec3::UnitZ()))
                            .toRotationMatrix();
    pose.linear() = Eigen::AngleAxisd(0.8, Vec3(1.0, 1.0, 0.0).normalized()) *
                    Eigen::AngleAxisd(turned * degree * i / 200.0, axis) * jitter;
    poses.push_back({0.1 * i, pose});
  }
  return poses;
}

TEST(SpinCalibration, finds_the_axis) {
  const Vec3 axis = Vec3(0.02, -0.05, 1.0).normalized();
  for (const double turned : {90.0, 300.0}) {
    EXPECT_LT(calibrate_spin(spun(turned, 0.0)).axis.cross(axis).norm(), 1e-6) << turned;
    const SpinCalibration noisy = calibrate_spin(spun(turned, 0.1 * degree));
    EXPECT_LT(noisy.axis.cross(axis).norm(), 0.05 * degree) << turned;
    // Two of the three angular errors tilt the axis.
    EXPECT_NEAR(noisy.rms, 0.1 * std::sqrt(2.0), 0.03) << turned;
    EXPECT_LT(noisy.mean, noisy.rms) << turned;
  }
}

TEST(SpinCalibration, refuses_a_body_that_hardly_turned) {
  EXPECT_THROW(calibrate_spin(spun(30.0, 0.0)), InputError);
}

}  // namespace
}  // namespace bodkin::tracking
