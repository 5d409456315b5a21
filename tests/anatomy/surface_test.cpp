#include "anatomy/surface.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
namespace {

const std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const std::vector<std::array<int, 3>> tetrahedron = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

TEST(Surface, a_tetrahedron_is_closed_and_knows_its_neighbours_and_normals) {
  const Surface surface(corners, tetrahedron);
  EXPECT_TRUE(surface.closed());
  EXPECT_EQ(surface.neighbours()[3], (std::array<int, 3>{0, 2, 1}));
  EXPECT_NEAR((surface.normal(0) - Vec3(0, 0, -1)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((surface.normal(3) - Vec3(1, 1, 1).normalized()).norm(), 0.0, 1e-15);
}

TEST(Surface, without_one_side_it_is_open) {
  const Surface surface(corners, {tetrahedron.begin(), tetrahedron.begin() + 3});
  EXPECT_FALSE(surface.closed());
  EXPECT_EQ(surface.neighbours()[0], (std::array<int, 3>{2, -1, 1}));
}

TEST(Surface, triangles_without_a_normal_are_left_out) {
  std::vector<std::array<int, 3>> triangles = tetrahedron;
  triangles.push_back({1, 1, 2});
  std::vector<Vec3> vertices = corners;
  vertices.insert(vertices.end(), {{5, 5, 5}, {6, 6, 6}, {7, 7, 7}});
  triangles.push_back({4, 5, 6});
  const Surface surface(vertices, triangles);
  EXPECT_EQ(surface.left_out(), 2u);
  EXPECT_EQ(surface.triangles().size(), 4u);
  EXPECT_TRUE(surface.closed());
}

TEST(Surface, refuses_what_is_no_surface) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Vec3> damaged = corners;
  damaged[2].y() = nan;
  EXPECT_THROW(Surface(damaged, tetrahedron), InputError);
  damaged[2].y() = 2e4;
  EXPECT_THROW(Surface(damaged, tetrahedron), InputError);
  EXPECT_THROW(Surface(corners, {{0, 1, 4}}), InputError);
  EXPECT_THROW(Surface(corners, {{0, 1, -1}}), InputError);
  EXPECT_THROW(Surface(corners, {{0, 2, 1}, {0, 3, 1}}), InputError);             // sides do not agree
  EXPECT_THROW(Surface(corners, {{0, 2, 1}, {0, 1, 3}, {1, 0, 3}}), InputError);  // three to an edge
}

}  // namespace
}  // namespace bodkin
