#include "views/path_offset.h"

#include <cmath>

#include <gtest/gtest.h>

namespace bodkin::views {
namespace {

// Straight in from the back.
const anatomy::NeedlePath path{Vec3(0, 30, 0), Vec3(0, -10, 0)};

TEST(PathOffset, on_the_path_there_is_none) {
  const PathOffset offset = path_offset(path, Vec3(0, 10, 0), Vec3(0, -1, 0));
  EXPECT_NEAR(offset.distance, 0.0, 1e-12);
  EXPECT_NEAR(offset.angle, 0.0, 1e-9);
  EXPECT_NEAR(offset.to_target, 20.0, 1e-12);
  EXPECT_EQ(offset.side, Side::none);
}

TEST(PathOffset, seen_from_behind_the_patients_left_is_left_and_the_head_is_up) {
  const PathOffset left = path_offset(path, Vec3(3, 10, 0), Vec3(0, -1, 0));
  EXPECT_NEAR(left.tip.x(), -3.0, 1e-12);
  EXPECT_NEAR(left.tip.y(), 0.0, 1e-12);
  EXPECT_EQ(left.side, Side::left);
  const PathOffset up = path_offset(path, Vec3(0, 10, 4), Vec3(0, -1, 0));
  EXPECT_NEAR(up.tip.y(), 4.0, 1e-12);
  EXPECT_EQ(up.side, Side::cranial);
}

TEST(PathOffset, a_tilted_shaft_leads_back_to_where_it_passes_the_entry) {
  const double angle = 10.0 * degree;
  const Vec3 axis(0.0, -std::cos(angle), std::sin(angle));  // towards the head
  const PathOffset offset = path_offset(path, Vec3(0, 10, 0), axis);
  EXPECT_NEAR(offset.angle, 10.0, 1e-9);
  EXPECT_NEAR(offset.hub.y(), -20.0 * std::tan(angle), 1e-9);
  EXPECT_NEAR(offset.tip.norm(), 0.0, 1e-12);
}

TEST(PathOffset, beyond_the_target_the_way_is_negative) {
  EXPECT_NEAR(path_offset(path, Vec3(0, -15, 0), Vec3(0, -1, 0)).to_target, -5.0, 1e-12);
}

TEST(PathOffset, a_path_along_the_body_has_the_front_up) {
  const anatomy::NeedlePath along{Vec3(0, 0, 100), Vec3(0, 0, 0)};
  const PathOffset offset = path_offset(along, Vec3(0, -5, 50), Vec3(0, 0, -1));
  EXPECT_NEAR(offset.tip.y(), 5.0, 1e-12);
  EXPECT_EQ(offset.side, Side::anterior);
}

TEST(PathOffset, a_path_without_length_says_nothing) {
  const PathOffset offset = path_offset({Vec3::Zero(), Vec3::Zero()}, Vec3(1, 2, 3), Vec3(0, 0, 1));
  EXPECT_EQ(offset.distance, 0.0);
  EXPECT_EQ(offset.angle, 0.0);
}

}  // namespace
}  // namespace bodkin::views
