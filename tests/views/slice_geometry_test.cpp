#include "views/slice_geometry.h"

#include <gtest/gtest.h>

namespace bodkin::views {
namespace {

const Vec3 middle(10.0, -20.0, 30.0);

imaging::SlicePlane plane_of(SliceKind kind, const Vec3& axis = Vec3(0, -1, 0)) {
  return slice_plane(kind, {middle, 100.0, 400, 200}, axis);
}

TEST(SliceGeometry, the_field_lies_along_the_longer_side) {
  const imaging::SlicePlane plane = plane_of(SliceKind::axial);
  EXPECT_DOUBLE_EQ(plane.pixel, 0.25);
  EXPECT_EQ(plane.width, 400);
  EXPECT_EQ(plane.height, 200);
  EXPECT_NEAR((plane.point(199.5, 99.5) - middle).norm(), 0.0, 1e-9);
}

TEST(SliceGeometry, patients_right_is_on_the_left_and_front_is_left_in_sagittal) {
  EXPECT_EQ(imaging::direction_letters(plane_of(SliceKind::axial).right), "L");
  EXPECT_EQ(imaging::direction_letters(plane_of(SliceKind::axial).down), "P");
  EXPECT_EQ(imaging::direction_letters(plane_of(SliceKind::coronal).right), "L");
  EXPECT_EQ(imaging::direction_letters(plane_of(SliceKind::coronal).down), "I");
  EXPECT_EQ(imaging::direction_letters(plane_of(SliceKind::sagittal).right), "P");
  EXPECT_EQ(imaging::direction_letters(plane_of(SliceKind::sagittal).down), "I");
}

TEST(SliceGeometry, the_slice_along_the_needle_holds_its_axis) {
  const Vec3 axis = Vec3(0.3, -0.9, 0.2).normalized();
  const imaging::SlicePlane plane = plane_of(SliceKind::along_needle, axis);
  EXPECT_NEAR(plane.normal().dot(axis), 0.0, 1e-12);
  EXPECT_NEAR(plane.distance(middle), 0.0, 1e-9);
  EXPECT_NEAR(plane.right.dot(plane.down), 0.0, 1e-12);
}

TEST(SliceGeometry, following_moves_the_plane_and_not_the_picture) {
  const imaging::SlicePlane plane = plane_of(SliceKind::sagittal);
  const Vec3 tip(13.0, -10.0, 25.0);
  const Vec3 moved = middle_that_shows(plane, middle, tip, 0.1);
  EXPECT_EQ(moved, Vec3(13.0, -20.0, 30.0));
  EXPECT_EQ(middle_that_shows(plane, middle, Vec3(13.0, 100.0, 25.0), 0.1), Vec3(13.0, 100.0, 25.0))
      << "out of sight, it comes into the middle";
}

TEST(SliceGeometry, a_needle_within_the_plane_is_drawn_where_it_lies) {
  const imaging::SlicePlane plane = plane_of(SliceKind::sagittal);
  const Vec3 tip = middle + Vec3(0, -10, 0), hub = middle + Vec3(0, 25, 0);
  const NeedleOnSlice needle = project_needle(plane, tip, hub, 2.0);
  EXPECT_NEAR(needle.tip.x(), 199.5 - 40.0, 1e-9);
  EXPECT_NEAR(needle.tip.y(), 99.5, 1e-9);
  EXPECT_NEAR(needle.hub.x(), 199.5 + 100.0, 1e-9);
  ASSERT_EQ(needle.ticks.size(), 3U);
  EXPECT_EQ(needle.ticks[2].millimetres, 30);
  EXPECT_NEAR(needle.ticks[2].at.x(), needle.tip.x() + 30.0 / 0.25, 1e-9);
  ASSERT_EQ(needle.pieces.size(), 1U);
  EXPECT_TRUE(needle.pieces[0].near);
  EXPECT_NEAR(needle.foreshortening, 1.0, 1e-12);
  EXPECT_NEAR((needle.along - Eigen::Vector2d(1, 0)).norm(), 0.0, 1e-12);
}

TEST(SliceGeometry, a_needle_across_the_plane_is_near_it_only_where_it_passes) {
  const imaging::SlicePlane plane = plane_of(SliceKind::sagittal);  // x = 10
  const Vec3 tip = middle + Vec3(-30, 0, 0), hub = middle + Vec3(30, 0, 0);
  const NeedleOnSlice needle = project_needle(plane, tip, hub, 2.0);
  ASSERT_EQ(needle.pieces.size(), 3U);
  EXPECT_FALSE(needle.pieces[0].near);
  EXPECT_TRUE(needle.pieces[1].near);
  EXPECT_FALSE(needle.pieces[2].near);
  EXPECT_NEAR(needle.foreshortening, 0.0, 1e-12);
  EXPECT_NEAR(std::abs(needle.distance), 30.0, 1e-9);
}

TEST(SliceGeometry, scale_bars_are_round_and_fit) {
  EXPECT_EQ(scale_bar(0.25, 100.0), 20.0);
  EXPECT_EQ(scale_bar(0.5, 100.0), 50.0);
  EXPECT_EQ(scale_bar(0.3, 99.0), 20.0);
  EXPECT_EQ(scale_bar(0.001, 10.0), 1.0);
}

TEST(SliceGeometry, places_are_said_as_a_scanner_says_them) {
  EXPECT_EQ(position_text(plane_of(SliceKind::sagittal), middle), "L 10.0");
  EXPECT_EQ(position_text(plane_of(SliceKind::axial), middle), "S 30.0");
  EXPECT_EQ(position_text(plane_of(SliceKind::coronal), middle), "A 20.0");
}

}  // namespace
}  // namespace bodkin::views
