#include "anatomy/mesh_quality.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
namespace {

// A unit cube as six tetrahedra around its diagonal from (0,0,0) to (1,1,1).
TetrahedralMesh cube_of_six() {
  TetrahedralMesh mesh;
  for (int n = 0; n < 8; ++n) mesh.nodes.emplace_back(n & 1, (n >> 1) & 1, (n >> 2) & 1);
  for (const auto& [a, b] : {std::pair{1U, 3U}, {3U, 2U}, {2U, 6U}, {6U, 4U}, {4U, 5U}, {5U, 1U}}) {
    mesh.elements.push_back({0U, a, b, 7U});
    mesh.tissues.push_back(mesh.elements.size() <= 3 ? tissue::muscle : tissue::fat);
  }
  return mesh;
}

TEST(MeshQuality, a_regular_tetrahedron_has_six_angles_of_70_5_degrees) {
  for (const double angle : dihedral_angles({1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1})) {
    EXPECT_NEAR(angle, std::acos(1.0 / 3.0) / degree, 1e-12);
  }
}

TEST(MeshQuality, the_corner_of_a_cube_has_three_right_angles) {
  const auto angles = dihedral_angles({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(angles[i], 90.0, 1e-12);  // the edges at the corner
  for (std::size_t i = 3; i < 6; ++i) EXPECT_NEAR(angles[i], std::atan(std::sqrt(2.0)) / degree, 1e-12);
}

TEST(MeshQuality, a_flat_tetrahedron_has_angles_of_0_and_180_degrees) {
  const auto angles = dihedral_angles({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  for (const double angle : angles) EXPECT_TRUE(std::abs(angle) < 1e-9 || std::abs(angle - 180.0) < 1e-9) << angle;
  EXPECT_EQ(dihedral_angles({0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0})[0], 0.0);
}

TEST(MeshQuality, tiny_angles_keep_their_digits) {
  const double thin = 1e-9;
  const auto angles = dihedral_angles({0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 1, thin});
  EXPECT_NEAR(angles[0] * degree / thin, 1.0, 1e-6);
}

TEST(MeshQuality, a_cube_of_six_is_measured_by_hand) {
  const MeshQuality quality = measure_quality(cube_of_six(), [](const Vec3& p) { return p.z() > 0.9; });
  EXPECT_EQ(quality.nodes, 8U);
  EXPECT_EQ(quality.elements, 6U);
  EXPECT_EQ(quality.not_positive, 0U);
  EXPECT_NEAR(quality.volume, 1.0, 1e-14);
  EXPECT_NEAR(quality.smallest_volume, 1.0 / 6.0, 1e-14);
  EXPECT_NEAR(quality.largest_volume, 1.0 / 6.0, 1e-14);
  EXPECT_NEAR(quality.smallest_angle, 45.0, 1e-12);
  EXPECT_NEAR(quality.largest_angle, 90.0, 1e-12);
  // 12 edges of the cube, 6 diagonals of its faces, 1 of space.
  const double sum = 12.0 + 6.0 * std::sqrt(2.0) + std::sqrt(3.0);
  EXPECT_NEAR(quality.mean_edge, sum / 19.0, 1e-14);
  EXPECT_DOUBLE_EQ(quality.shortest_edge, 1.0);
  EXPECT_DOUBLE_EQ(quality.longest_edge, std::sqrt(3.0));
  // On the top face: four edges and one diagonal.
  EXPECT_NEAR(quality.mean_edge_in_region, (4.0 + std::sqrt(2.0)) / 5.0, 1e-14);
  EXPECT_EQ(quality.nodes_in_region, 4U);
  std::size_t counted = 0;
  for (const std::size_t count : quality.angles) counted += count;
  EXPECT_EQ(counted, 36U);
  ASSERT_EQ(quality.tissues.size(), 2U);
  for (const TissueMesh& own : quality.tissues) {
    EXPECT_EQ(own.elements, 3U);
    EXPECT_EQ(own.nodes, 6U);  // both ends of the diagonal and four of the ring of six
    EXPECT_NEAR(own.volume, 0.5, 1e-14);
  }
  EXPECT_EQ(quality.tissues[0].tissue, tissue::fat);
}

TEST(MeshQuality, elements_inside_out_are_counted) {
  TetrahedralMesh mesh = cube_of_six();
  std::swap(mesh.elements[4][0], mesh.elements[4][1]);
  const MeshQuality quality = measure_quality(mesh);
  EXPECT_EQ(quality.not_positive, 1U);
  EXPECT_NEAR(quality.smallest_volume, -1.0 / 6.0, 1e-14);
  EXPECT_EQ(measure_quality({}).elements, 0U);
}

TEST(MeshQuality, angles_do_not_depend_on_where_and_how_large) {
  Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    std::array<Vec3, 4> p;
    for (Vec3& corner : p) corner = Vec3(random.uniform(), random.uniform(), random.uniform());
    const auto angles = dihedral_angles(p[0], p[1], p[2], p[3]);
    const Mat3 turn = Eigen::AngleAxisd(random.uniform() * 6.0, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (Vec3& corner : p) corner = 12.5 * (turn * corner) + Vec3(40, -30, 7);
    const auto again = dihedral_angles(p[0], p[1], p[2], p[3]);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(angles[i], again[i], 1e-7);
  }
}

}  // namespace
}  // namespace bodkin
