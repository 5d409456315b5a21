// The skin that clients draw.
#include "link/skin_sheet.h"

#include <algorithm>

#include "tests/session/slab_case.h"
#include <gtest/gtest.h>

#include "core/shortest_turn.h"

namespace bodkin::link {
namespace {

Pose needle_at(const Vec3& tip, const Vec3& along) {
  Pose pose = Pose::Identity();
  pose.linear() = shortest_turn(Vec3::UnitZ(), along).toRotationMatrix();
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

TEST(SkinSheet, tells_how_far_what_lies_between_its_points_has_moved) {
  const SkinSheet sheet(slab_case(lumbar_slabs()));
  std::vector<Vec3> moved = sheet.rest();
  const auto field = [](const Vec3& at) { return Vec3(0.01 * at.x(), -2.0 + 0.02 * at.z() - 0.03 * at.x(), 0.5); };
  for (Vec3& point : moved) point += field(point);
  const Vec3 middle = sheet.rest()[sheet.rest().size() / 2];
  std::vector<Vec3> points;
  for (double x = -20.0; x <= 20.0; x += 3.7)
    for (double z = -20.0; z <= 20.0; z += 4.3) points.push_back(middle + Vec3(x, 0.8, z));
  points.push_back(middle + Vec3(200.0, 0.0, 0.0));
  const std::vector<float> found = sheet.displacements_at(points, moved);
  ASSERT_EQ(found.size(), 3 * points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 is = Eigen::Map<const Eigen::Vector3f>(&found[3 * i]).cast<double>();
    const Vec3 expected = i + 1 < points.size() ? field(points[i]) : Vec3(Vec3::Zero());
    EXPECT_LT((is - expected).norm(), 1e-5) << "what is linear is kept; beyond the sheet nothing moves";
  }
  moved.pop_back();
  for (const float each : sheet.displacements_at(points, moved)) EXPECT_EQ(each, 0.0F);
}

TEST(SkinSheet, is_empty_where_nothing_is_planned) {
  anatomy::Case patient = slab_case(lumbar_slabs());
  patient.description.procedure.path.reset();
  EXPECT_TRUE(SkinSheet(patient).empty());
  EXPECT_TRUE(SkinSheet().moved(Pose::Identity(), 1.0, {}).empty());
}

}  // namespace
}  // namespace bodkin::link
