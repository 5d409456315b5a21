#include "station/station_checks.h"

#include "station/hand_session.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "forces/device_stability.h"

namespace bodkin::station {
namespace {

haptics::StableStiffness of_axes(const Vec3& axis) {
  haptics::StableStiffness stiffness;
  stiffness.published = 5.0;
  stiffness.by_delay = axis.maxCoeff();
  stiffness.by_encoder = axis;
  stiffness.axis = axis;
  return stiffness;
}

TEST(StationChecks, the_needle_gets_the_stiffness_of_the_axes_along_it_and_what_holds_it_that_of_the_weakest) {
  // Into the back of a prone patient in front of the operator: downwards for the device.
  const anatomy::NeedlePath path{Vec3(0.0, 100.0, 0.0), Vec3(0.0, 40.0, 0.0)};
  const haptics::WorkspaceSettings workspace = workspace_about(path);
  const anatomy::DeviceLimits weak_aside =
      with_stiffness(of_axes(Vec3(1.0, 4.0, 4.0)), workspace, path, anatomy::DeviceLimits());
  // 30 degrees to the side: 1 / (sin^2 / 1 + cos^2 / 4).
  EXPECT_NEAR(weak_aside.stiffness, 1.0 / (0.25 + 0.75 / 4.0), 0.01);
  EXPECT_DOUBLE_EQ(weak_aside.across(), 1.0);
  const anatomy::DeviceLimits weak_along =
      with_stiffness(of_axes(Vec3(4.0, 4.0, 1.0)), workspace, path, anatomy::DeviceLimits());
  EXPECT_DOUBLE_EQ(weak_along.stiffness, 1.0);
  EXPECT_DOUBLE_EQ(weak_along.across(), 1.0);
  const anatomy::DeviceLimits alike =
      with_stiffness(of_axes(Vec3::Constant(2.5)), workspace, path, anatomy::DeviceLimits());
  EXPECT_DOUBLE_EQ(alike.stiffness, 2.5);
  EXPECT_EQ(alike.lateral_stiffness, 0.0) << "nothing to say";
  const anatomy::DeviceLimits unknown =
      with_stiffness(of_axes(Vec3::Zero()), workspace, path, anatomy::DeviceLimits());
  EXPECT_EQ(unknown.stiffness, anatomy::DeviceLimits().stiffness) << "what the case says";
}

TEST(StationChecks, what_was_cut_is_said_for_each_axis_that_differs) {
  const std::string differing = stiffness_sentence(of_axes(Vec3(1.0, 4.0, 4.0)));
  EXPECT_THAT(differing, testing::HasSubstr("1 N/mm to the right, 4 away from you and 4 upwards"));
  haptics::StableStiffness alike = of_axes(Vec3::Constant(2.0));
  alike.by_encoder = Vec3::Constant(9.0);
  alike.delay = 0.002;
  EXPECT_EQ(stiffness_sentence(alike),
            "of the published 5 N/mm the delay leaves 2 N/mm along each axis: a force reaches the hand 2.0 ms after "
            "its tick");
}

TEST(StationChecks, a_spring_across_the_needle_is_checked_against_the_weakest_axis) {
  anatomy::DeviceLimits device;
  device.stiffness = 3.0;
  device.lateral_stiffness = 0.8;
  EXPECT_NO_THROW(forces::require_stable("rail", "stiffness", 2.0, device));
  try {
    forces::require_stable_across("rail", "stiffness", 2.0, device);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "rail: stiffness is 2 N/mm, but the device (generic) renders at most 0.8 N/mm stably on its weakest "
                 "axis; lower it, or give the device its true lateral_stiffness_N_per_mm");
  }
  EXPECT_NO_THROW(forces::require_stable_across("rail", "stiffness", 0.8, device));
}

}  // namespace
}  // namespace bodkin::station
