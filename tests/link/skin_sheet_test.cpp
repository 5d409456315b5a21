// The skin that clients draw.
#include "link/skin_sheet.h"

#include <algorithm>

#include "tests/session/slab_case.h"
#include <gtest/gtest.h>

namespace bodkin::link {
namespace {

Pose needle_at(const Vec3& tip, const Vec3& along) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), along).toRotationMatrix();
  pose.translation() = tip;
  return pose;
}

TEST(SkinSheet, lies_on_the_skin_and_is_closed) {
  const SkinSheet sheet(slab_case(lumbar_slabs()));  // its back is the plane y = 0, 62 mm wide
  ASSERT_FALSE(sheet.empty());
  for (const Vec3& point : sheet.rest()) EXPECT_NEAR(point.y(), 0.0, 0.5);
  double area = 0.0;
  for (const std::array<int, 3>& corners : sheet.triangles()) {
    const Vec3& a = sheet.rest().at(static_cast<std::size_t>(corners[0]));
    const Vec3& b = sheet.rest().at(static_cast<std::size_t>(corners[1]));
    const Vec3& c = sheet.rest().at(static_cast<std::size_t>(corners[2]));
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  EXPECT_NEAR(area, 60.0 * 60.0, 1.0) << "21 x 21 points, 3 mm apart, lie on a back that is 62 mm wide";
}

TEST(SkinSheet, goes_down_with_the_needle_by_the_depth_of_the_dimple) {
  const SkinSheet sheet(slab_case(lumbar_slabs()));
  const Vec3 inwards = -Vec3::UnitY();
  const std::vector<Vec3> moved = sheet.moved(needle_at(5.0 * inwards, inwards), 4.0, {});
  double lowest = 1e9, highest = -1e9;
  for (const Vec3& point : moved) {
    lowest = std::min(lowest, point.y());
    highest = std::max(highest, point.y());
  }
  EXPECT_NEAR(lowest, -4.0, 0.3) << "at the needle, which goes through a point of the sheet";
  EXPECT_GT(highest, -0.6) << "far away it hardly moves";
}

TEST(SkinSheet, follows_a_deformable_body_point_by_point) {
  const SkinSheet sheet(slab_case(lumbar_slabs()));
  std::vector<float> displacements(3 * sheet.rest().size(), 0.0F);
  displacements[4] = -2.5F;  // of the second point, y
  const std::vector<Vec3> moved = sheet.moved(Pose::Identity(), 9.0, displacements);
  EXPECT_EQ(moved[0], sheet.rest()[0]) << "the dimple is in the displacements already";
  EXPECT_NEAR(moved[1].y(), sheet.rest()[1].y() - 2.5, 1e-6);
}

TEST(SkinSheet, is_empty_where_nothing_is_planned) {
  anatomy::Case patient = slab_case(lumbar_slabs());
  patient.description.procedure.path.reset();
  EXPECT_TRUE(SkinSheet(patient).empty());
  EXPECT_TRUE(SkinSheet().moved(Pose::Identity(), 1.0, {}).empty());
}

}  // namespace
}  // namespace bodkin::link
