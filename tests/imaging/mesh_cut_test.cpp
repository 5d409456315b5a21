#include "imaging/mesh_cut.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::imaging;
namespace {

double area_of(const CutElement& cut) {
  Vec3 sum = Vec3::Zero();
  for (int i = 1; i + 1 < cut.corners; ++i) {
    const auto at = static_cast<std::size_t>(i);
    sum += 0.5 * (cut.points[at] - cut.points[0]).cross(cut.points[at + 1] - cut.points[0]);
  }
  return sum.norm();
}

// A unit cube as six tetrahedra around its diagonal.
TetrahedralMesh unit_cube() {
  TetrahedralMesh mesh;
  for (int n = 0; n < 8; ++n) mesh.nodes.emplace_back(n & 1, (n >> 1) & 1, (n >> 2) & 1);
  for (const auto& [a, b] : {std::pair{1U, 3U}, {3U, 2U}, {2U, 6U}, {6U, 4U}, {4U, 5U}, {5U, 1U}}) {
    mesh.elements.push_back({0U, a, b, 7U});
    mesh.tissues.push_back(tissue::fat);
  }
  return mesh;
}

TEST(MeshCut, the_pieces_cover_the_cross_section_once) {
  const TetrahedralMesh mesh = unit_cube();
  Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    // Planes perpendicular to z: the section is the unit square at any height, grid planes of the mesh included.
    const double height = trial == 0 ? 0.5 : random.uniform(0.01, 0.99);
    SlicePlane plane;
    plane.corner = Vec3(0.3, 0.2, height);
    double area = 0.0;
    for (const CutElement& cut : cut_mesh(mesh, plane)) {
      EXPECT_GE(cut.corners, 3);
      EXPECT_LE(cut.corners, 4);
      area += area_of(cut);
      for (int i = 0; i < cut.corners; ++i) {
        EXPECT_NEAR(cut.points[static_cast<std::size_t>(i)].z(), height, 1e-12);
      }
    }
    EXPECT_NEAR(area, 1.0, 1e-12);
  }
}

TEST(MeshCut, a_plane_that_misses_the_mesh_cuts_nothing) {
  SlicePlane plane;
  plane.corner = Vec3(0, 0, 2.0);
  EXPECT_TRUE(cut_mesh(unit_cube(), plane).empty());
}

}  // namespace
}  // namespace bodkin
