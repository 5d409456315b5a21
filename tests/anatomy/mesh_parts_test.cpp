#include "anatomy/mesh_parts.h"

#include <utility>

#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
namespace {

// Two tetrahedra that share a face, one that touches them in an edge, and a node that nothing uses.
TetrahedralMesh two_and_one() {
  TetrahedralMesh mesh;
  mesh.nodes = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, -1, 0.2}, {1, -1, 0}};
  mesh.elements = {{1, 2, 3, 4}, {1, 3, 2, 5}, {1, 2, 6, 7}};
  mesh.tissues = {tissue::fat, tissue::muscle, tissue::skin};
  return mesh;
}

TEST(MeshParts, volume_has_the_sign_of_the_order) {
  TetrahedralMesh mesh = two_and_one();
  EXPECT_DOUBLE_EQ(element_volume(mesh, 0), 1.0 / 6.0);
  std::swap(mesh.elements[0][0], mesh.elements[0][1]);
  EXPECT_DOUBLE_EQ(element_volume(mesh, 0), -1.0 / 6.0);
}

TEST(MeshParts, elements_inside_out_are_turned_and_the_others_left) {
  TetrahedralMesh mesh = two_and_one();
  const auto third = mesh.elements[2];
  const bool third_was_positive = element_volume(mesh, 2) > 0.0;
  std::swap(mesh.elements[1][0], mesh.elements[1][1]);
  EXPECT_EQ(orient_elements(mesh), third_was_positive ? 1U : 2U);
  for (std::size_t e = 0; e < 3; ++e) EXPECT_GT(element_volume(mesh, e), 0.0);
  if (third_was_positive) {
    EXPECT_EQ(mesh.elements[2], third);
  }
  EXPECT_EQ(orient_elements(mesh), 0U);
}

TEST(MeshParts, what_hangs_on_an_edge_only_is_another_part) {
  TetrahedralMesh mesh = two_and_one();
  EXPECT_EQ(keep_largest_part(mesh), 1U);
  ASSERT_EQ(mesh.elements.size(), 2U);
  EXPECT_EQ(mesh.nodes.size(), 5U);
  EXPECT_EQ(mesh.tissues, (std::vector<TissueId>{tissue::fat, tissue::muscle}));
  EXPECT_DOUBLE_EQ(element_volume(mesh, 0), 1.0 / 6.0);
  EXPECT_DOUBLE_EQ(element_volume(mesh, 1), 1.0 / 6.0);
  EXPECT_EQ(keep_largest_part(mesh), 0U);
}

}  // namespace
}  // namespace bodkin
