#include "scene/surfaces.h"

#include "tests/scene/test_bodies.h"
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin::scene {
namespace {

TEST(PatientSurfaces, a_ball_with_a_bone_has_the_surfaces_of_both_spheres) {
  const PatientSurfaces& surfaces = ball_surfaces();
  ASSERT_EQ(surfaces.parts.size(), 2u);
  EXPECT_EQ(surfaces.parts[0].kind, SurfaceKind::skin);
  EXPECT_EQ(surfaces.parts[1].name, "bone");
  const double radii[] = {ball_radius, bone_radius};
  for (std::size_t p = 0; p < 2; ++p) {
    const SceneMesh& mesh = surfaces.parts[p].mesh;
    ASSERT_FALSE(mesh.empty());
    ASSERT_EQ(mesh.normals.size(), mesh.points.size());
    ASSERT_EQ(mesh.openness.size(), mesh.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      const Vec3 from = mesh.points[i].cast<double>() - ball_middle;
      EXPECT_NEAR(from.norm(), radii[p], 0.6);
      EXPECT_GT(mesh.normals[i].cast<double>().dot(from.normalized()), 0.97);
    }
  }
}

TEST(PatientSurfaces, triangles_face_outwards_and_close_the_surface) {
  for (const PatientSurface& part : ball_surfaces().parts) {
    double volume = 0.0;
    for (const auto& corners : part.mesh.triangles) {
      const auto at = [&](std::size_t c) {
        return Vec3(part.mesh.points[static_cast<std::size_t>(corners[c])].cast<double>() - ball_middle);
      };
      volume += at(0).dot(at(1).cross(at(2))) / 6.0;
    }
    const double radius = part.kind == SurfaceKind::skin ? ball_radius : bone_radius;
    EXPECT_NEAR(volume, 4.0 / 3.0 * 3.14159265 * radius * radius * radius, 0.03 * volume);
  }
}

TEST(PatientSurfaces, no_part_has_more_triangles_than_planned_and_all_together_60000) {
  int sum = 0;
  for (const SurfacePlan& plan : surface_plans()) sum += plan.most_triangles;
  EXPECT_LE(sum, 60000);
  // A finer lattice gives more triangles before the decimation.
  const PatientSurfaces fine = make_surfaces(ball_of_tissues(0.5));
  for (const PatientSurface& part : fine.parts) {
    for (const SurfacePlan& plan : surface_plans()) {
      if (plan.name == part.name) {
        EXPECT_LE(part.mesh.triangles.size(), static_cast<std::size_t>(plan.most_triangles));
      }
    }
  }
}

TEST(PatientSurfaces, nothing_hides_the_sky_over_a_ball_and_a_wall_hides_a_part) {
  for (const PatientSurface& part : ball_surfaces().parts) {
    for (const float open : part.mesh.openness) EXPECT_GT(open, 0.97F);
  }
  // Two slabs of bone with a gap of 6 mm between them: the sides of the gap see little of the sky.
  anatomy::Grid grid;
  grid.size = {60, 60, 60};
  anatomy::TissueVolume tissues(grid);
  for (int k = 10; k < 50; ++k) {
    for (int j = 10; j < 50; ++j) {
      for (int i = 10; i < 50; ++i) {
        if (i < 27 || i > 32) tissues.at(i, j, k) = anatomy::tissue::cortical_bone;
      }
    }
  }
  const PatientSurfaces slabs = make_surfaces(tissues);
  const SceneMesh& bone = slabs.parts.back().mesh;
  double in_gap = 0.0, outside = 0.0;
  int gap_count = 0, outside_count = 0;
  for (std::size_t i = 0; i < bone.points.size(); ++i) {
    const Eigen::Vector3f& point = bone.points[i];
    if ((point.tail<2>() - Eigen::Vector2f(29.5F, 29.5F)).norm() > 8.0F) continue;
    const bool between = std::abs(point.x() - 29.5F) < 6.0F;
    (between ? in_gap : outside) += static_cast<double>(bone.openness[i]);
    ++(between ? gap_count : outside_count);
  }
  ASSERT_GT(gap_count, 0);
  ASSERT_GT(outside_count, 0);
  EXPECT_LT(in_gap / gap_count, 0.55);
  EXPECT_GT(outside / outside_count, 0.9);
}

TEST(PatientSurfaces, a_patient_of_air_is_refused_with_a_sentence) {
  anatomy::Grid grid;
  grid.size = {5, 5, 5};
  EXPECT_THROW(make_surfaces(anatomy::TissueVolume(grid)), InputError);
}

TEST(PatientSurfaces, progress_may_cancel) {
  EXPECT_THROW(make_surfaces(ball_of_tissues(2.0),
                             [](std::string_view, double fraction) {
                               if (fraction > 0.05) throw SystemError("cancelled");
                             }),
               SystemError);
}

}  // namespace
}  // namespace bodkin::scene
