#include "scene/skin_patch.h"

#include <map>
#include <set>

#include "scene/picking.h"
#include "tests/scene/test_bodies.h"
#include <gtest/gtest.h>

namespace bodkin::scene {
namespace {

const Vec3 into_ball = Vec3(-1.0, -2.0, 0.5).normalized();
const Vec3 ball_entry = ball_middle - ball_radius * into_ball;

TEST(FirstHit, a_ray_meets_the_near_side_of_a_ball_with_its_normal) {
  const SceneMesh& skin = ball_surfaces().skin();
  const auto hit = first_hit(skin, {ball_middle - 200.0 * into_ball, into_ball});
  ASSERT_TRUE(hit);
  EXPECT_LT((hit->point - ball_entry).norm(), 0.6);
  EXPECT_GT(hit->normal.dot(-into_ball), 0.99);
  EXPECT_FALSE(first_hit(skin, {ball_middle - 200.0 * into_ball, into_ball.unitOrthogonal()}));
  EXPECT_FALSE(first_hit(skin, {ball_middle, into_ball})) << "from inside all triangles are seen from behind";
}

TEST(SkinPatch, the_bottom_of_a_dent_is_where_the_force_model_has_the_tip) {
  SkinPatch patch(ball_surfaces().skin(), ball_entry, into_ball);
  ASSERT_FALSE(patch.empty());
  for (const double depth : {-4.0, -0.3, 0.5, 3.0, 8.0}) {
    patch.deform({ball_entry, into_ball, depth});
    const Vec3 bottom = patch.mesh().points[patch.bottom()].cast<double>();
    EXPECT_LT((bottom - (ball_entry + depth * into_ball)).norm(), 1e-4) << depth;
    // No other point is deeper.
    for (const Eigen::Vector3f& point : patch.mesh().points) {
      const double moved = (point.cast<double>() - ball_entry).dot(into_ball);
      if (depth > 0.0) {
        EXPECT_LE(moved, (depth < 3.0 ? std::max(depth, 20.0) : 20.0) + 1e-3);
      }
    }
  }
  patch.deform({ball_entry, into_ball, 0.0});
  for (std::size_t i = 0; i < patch.rest().size(); ++i) {
    EXPECT_LT((patch.mesh().points[i].cast<double>() - patch.rest()[i]).norm(), 1e-4);
  }
}

TEST(SkinPatch, a_dent_is_rounded_falls_off_and_ends_before_the_border) {
  SkinPatch patch(ball_surfaces().skin(), ball_entry, into_ball);
  patch.deform({ball_entry, into_ball, 5.0});
  std::map<int, double> moved_by_distance;
  for (std::size_t i = 0; i < patch.rest().size(); ++i) {
    const Vec3 moved = patch.mesh().points[i].cast<double>() - patch.rest()[i];
    EXPECT_LT(moved.cross(into_ball).norm(), 1e-3) << "along the needle only";
    const double distance = (patch.rest()[i] - patch.rest()[patch.bottom()]).norm();
    if (distance > SkinPatch::radius) {
      EXPECT_LT(moved.norm(), 1e-4);
    }
    double& most = moved_by_distance[static_cast<int>(distance / 2.0)];
    most = std::max(most, moved.dot(into_ball));
  }
  double before = 1e9;
  for (const auto& [ring, most] : moved_by_distance) {
    EXPECT_LE(most, before + 1e-3) << 2 * ring << " mm away";
    before = most;
  }
}

TEST(SkinPatch, normals_are_those_of_the_dented_triangles) {
  SkinPatch patch(ball_surfaces().skin(), ball_entry, into_ball);
  patch.deform({ball_entry, into_ball, 4.0});
  const SceneMesh& mesh = patch.mesh();
  double lean = 0.0;
  for (const auto& corners : mesh.triangles) {
    const auto at = [&](std::size_t c) { return static_cast<std::size_t>(corners[c]); };
    const Vec3 a = mesh.points[at(0)].cast<double>(), b = mesh.points[at(1)].cast<double>();
    const Vec3 c = mesh.points[at(2)].cast<double>();
    const Vec3 across = (b - a).cross(c - a);
    if (across.norm() < 1e-6) continue;
    const Vec3 mean = (mesh.normals[at(0)] + mesh.normals[at(1)] + mesh.normals[at(2)]).cast<double>().normalized();
    lean += (1.0 - mean.dot(across.normalized())) / static_cast<double>(mesh.triangles.size());
    EXPECT_GT(mean.dot(across.normalized()), 0.7);
  }
  EXPECT_LT(lean, 0.01);
}

TEST(SkinPatch, patch_and_surroundings_cover_the_skin_once_and_meet_without_a_crack) {
  const SceneMesh& skin = ball_surfaces().skin();
  SkinPatch patch(skin, ball_entry, into_ball);
  patch.deform({ball_entry, into_ball, 6.0});
  // Every edge of both together, by the places of its ends, has exactly two triangles.
  using Corner = std::array<long, 3>;
  std::map<std::set<Corner>, int> edges;
  const auto count = [&](const std::vector<Eigen::Vector3f>& points, const auto& triangles) {
    const auto corner = [&](std::int32_t i) {
      const Eigen::Vector3f& point = points[static_cast<std::size_t>(i)];
      return Corner{std::lround(1e4 * static_cast<double>(point.x())),
                    std::lround(1e4 * static_cast<double>(point.y())),
                    std::lround(1e4 * static_cast<double>(point.z()))};
    };
    for (const auto& corners : triangles) {
      for (std::size_t c = 0; c < 3; ++c) ++edges[{corner(corners[c]), corner(corners[(c + 1) % 3])}];
    }
  };
  count(skin.points, patch.around());
  count(patch.mesh().points, patch.mesh().triangles);
  for (const auto& [ends, triangles] : edges) EXPECT_EQ(triangles, 2);
  EXPECT_LE(patch.mesh().triangles.size(), 5000u);
}

TEST(SkinPatch, displacements_of_a_body_move_it_and_the_bottom_stays_at_the_tip) {
  SkinPatch patch(ball_surfaces().skin(), ball_entry, into_ball);
  std::vector<float> moved;
  for (std::size_t i = 0; i < patch.rest().size(); ++i) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) moved.push_back(static_cast<float>(2.0 * into_ball[axis]));
  }
  patch.deform({ball_entry, into_ball, 3.0}, moved);
  EXPECT_LT((patch.mesh().points[patch.bottom()].cast<double>() - (ball_entry + 3.0 * into_ball)).norm(), 1e-4);
  patch.deform({ball_entry, into_ball, 0.0}, moved);
  EXPECT_LT(
      (patch.mesh().points[patch.bottom()].cast<double>() - (patch.rest()[patch.bottom()] + 2.0 * into_ball)).norm(),
      1e-4);
}

TEST(SkinPatch, nothing_is_cut_out_where_the_line_misses_the_skin) {
  const SkinPatch patch(ball_surfaces().skin(), ball_middle + Vec3(500.0, 0.0, 0.0), Vec3::UnitZ());
  EXPECT_TRUE(patch.empty());
  EXPECT_EQ(patch.around().size(), ball_surfaces().skin().triangles.size());
}

}  // namespace
}  // namespace bodkin::scene
