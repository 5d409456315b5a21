#include "app/models/probe_outline.h"

#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

TEST(ProbeOutline, begins_with_the_border_of_the_picture_and_puts_the_head_behind_the_face) {
  anatomy::UltrasoundProbe probe;
  probe.kind = anatomy::ProbeKind::linear;
  Pose pose = Pose::Identity();
  pose.translation() = Vec3(10.0, 20.0, 30.0);
  pose.linear() = Eigen::AngleAxisd(90.0 * degree, Vec3::UnitZ()).toRotationMatrix();
  const double half = 0.5 * probe.aperture(), depth = 60.0;
  ASSERT_GT(half, 8.0);
  const std::vector<scene::Trail> lines = probe_outline(probe, depth, pose);
  ASSERT_GT(lines.size(), 2U);
  const std::vector<Vec3>& border = lines.front().points;
  ASSERT_EQ(border.size(), 5U);
  EXPECT_EQ(border.front(), border.back()) << "a closed line";
  // Sideways x is the patient's y here, and depth y the patient's -x.
  EXPECT_LT((border[0] - Vec3(10.0, 20.0 - half, 30.0)).norm(), 1e-12);
  EXPECT_LT((border[2] - Vec3(10.0 - depth, 20.0 + half, 30.0)).norm(), 1e-12);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    for (const Vec3& point : lines[i].points) {
      const Vec3 own = pose.inverse() * point;
      EXPECT_LE(own.y(), 1e-12) << "nothing of the head is in the picture";
      EXPECT_LE(std::abs(own.x()), half + 1e-12);
    }
  }
}

}  // namespace
}  // namespace bodkin::app
