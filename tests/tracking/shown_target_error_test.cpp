#include "tracking/shown_target_error.h"

#include <gtest/gtest.h>

namespace bodkin::tracking {
namespace {

TrackedPose away(double distance, TrackingStatus status) {
  TrackedPose pose;
  pose.status = status;
  pose.camera_from_body.translation() = Vec3(0.0, 0.0, distance);
  return pose;
}

Registration predicted() {
  Registration registration;
  registration.fixed_from_moving.shift = Vec3(0.0, 0.0, 40.0);
  registration.at_target =
      TargetError{.target = Vec3(5.0, 0.0, 60.0), .tre = {.low = 0.5, .estimate = 1.0, .high = 2.0}};
  return registration;
}

// The target lies 100 mm behind the body's centre, so with the body at 300 mm it is at 400.
TEST(ShownTargetError, is_the_focal_length_over_the_depth) {
  CameraModel camera;
  camera.fx = 990.0;
  camera.fy = 1010.0;
  ShownTargetError error(predicted(), camera);
  EXPECT_FALSE(error.in_pixels()) << "no picture yet";
  error.add(away(300.0, TrackingStatus::ok));
  error.add(away(5.0, TrackingStatus::lost));
  ASSERT_TRUE(error.in_pixels());
  EXPECT_NEAR(error.in_pixels()->low, 1.25, 1e-12);
  EXPECT_NEAR(error.in_pixels()->estimate, 2.5, 1e-12);
  EXPECT_NEAR(error.in_pixels()->high, 5.0, 1e-12);
  error.add(away(900.0, TrackingStatus::uncertain));
  EXPECT_NEAR(error.in_pixels()->estimate, 0.5 * (2.5 + 1.0), 1e-12);
}

TEST(ShownTargetError, is_nothing_where_nothing_was_predicted) {
  ShownTargetError error(Registration{}, CameraModel{.width = 640, .height = 480, .fx = 800.0, .fy = 800.0});
  error.add(away(300.0, TrackingStatus::ok));
  EXPECT_FALSE(error.in_mm());
  EXPECT_FALSE(error.in_pixels());
}

}  // namespace
}  // namespace bodkin::tracking
