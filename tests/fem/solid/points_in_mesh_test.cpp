#include "fem/solid/points_in_mesh.h"

#include <algorithm>
#include <cmath>

#include "tests/fem/lattice_body.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

Vec3 place_in_mesh(const TetrahedralMesh& mesh, const PointInMesh& point) {
  Vec3 place = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) place += point.weights[i] * mesh.nodes[point.nodes[i]];
  return place;
}

TEST(PointsInMesh, points_inside_are_the_weighted_corners_of_their_element) {
  const TetrahedralMesh mesh = kuhn_lattice(7, 30.0, 0.2);
  Random random(1);
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i)
    points.emplace_back(random.uniform(0.0, 30.0), random.uniform(0.0, 30.0), random.uniform(0.0, 30.0));
  points.insert(points.end(), mesh.nodes.begin(), mesh.nodes.end());
  const std::vector<PointInMesh> found = find_points(mesh, points);
  for (std::size_t p = 0; p < points.size(); ++p) {
    ASSERT_TRUE(found[p].moves());
    EXPECT_LT((place_in_mesh(mesh, found[p]) - points[p]).norm(), 1e-9) << points[p].transpose();
    EXPECT_GE(*std::min_element(found[p].weights.begin(), found[p].weights.end()), -1e-8);
  }
}

TEST(PointsInMesh, points_outside_go_with_the_closest_place_within_reach) {
  const TetrahedralMesh mesh = kuhn_lattice(5, 20.0);
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    const Vec3 point(random.uniform(-8.0, 28.0), random.uniform(-8.0, 28.0), random.uniform(-8.0, 28.0));
    const Vec3 closest = point.cwiseMax(Vec3::Zero()).cwiseMin(Vec3::Constant(20.0));  // of a cube
    const double away = (point - closest).norm();
    const std::vector<PointInMesh> found = find_points(mesh, std::vector<Vec3>{point}, 4.0);
    ASSERT_EQ(found[0].moves(), away < 4.0) << point.transpose();
    if (away < 4.0) {
      EXPECT_LT((place_in_mesh(mesh, found[0]) - closest).norm(), 1e-9) << point.transpose();
    }
  }
}

TEST(PointsInMesh, a_mesh_without_elements_moves_nothing) {
  EXPECT_FALSE(find_points({}, std::vector<Vec3>{Vec3::Zero()})[0].moves());
}

}  // namespace
}  // namespace bodkin
