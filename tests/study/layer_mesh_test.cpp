#include "study/layer_mesh.h"

#include <algorithm>
#include <map>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::study;
namespace {

TEST(LayerMesh, fills_each_layer_with_tetrahedra_of_positive_volume_that_share_their_faces) {
  const std::vector<MeshLayer> layers = {{tissue::skin, 2.0}, {tissue::fat, 9.0}, {tissue::muscle, 4.0}};
  const TetrahedralMesh mesh = mesh_of_layers(layers, 20.0, 3.0);
  std::map<TissueId, double> volume;
  std::map<std::array<std::uint32_t, 3>, int> faces;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto& nodes = mesh.elements[e];
    const Vec3 a = mesh.nodes[nodes[0]];
    const double six = (mesh.nodes[nodes[1]] - a).cross(mesh.nodes[nodes[2]] - a).dot(mesh.nodes[nodes[3]] - a);
    ASSERT_GT(six, 0.0);
    volume[mesh.tissues[e]] += six / 6.0;
    for (std::size_t out = 0; out < 4; ++out) {
      std::array<std::uint32_t, 3> face{};
      for (std::size_t i = 0; i < 3; ++i) face[i] = nodes[(out + 1 + i) % 4];
      std::sort(face.begin(), face.end());
      ++faces[face];
    }
  }
  EXPECT_NEAR(volume[tissue::skin], 800.0, 1e-9);
  EXPECT_NEAR(volume[tissue::fat], 3600.0, 1e-9);
  EXPECT_NEAR(volume[tissue::muscle], 1600.0, 1e-9);
  double skin_of_the_block = 0.0;  // mm^2, of the faces of only one element
  for (const auto& [face, count] : faces) {
    ASSERT_LE(count, 2);
    const Vec3 a = mesh.nodes[face[0]], b = mesh.nodes[face[1]], c = mesh.nodes[face[2]];
    if (count == 1) skin_of_the_block += 0.5 * (b - a).cross(c - a).norm();
  }
  EXPECT_NEAR(skin_of_the_block, 2.0 * 400.0 + 4.0 * 20.0 * 15.0, 1e-9) << "no face inside is without a neighbour";
  for (const double depth : {0.0, 2.0, 11.0, 15.0}) {
    EXPECT_TRUE(std::any_of(mesh.nodes.begin(), mesh.nodes.end(),
                            [depth](const Vec3& node) { return (node - Vec3(0.0, 0.0, depth)).norm() < 1e-12; }))
        << "no node on the middle line at " << depth << " mm";
  }
}

TEST(LayerMesh, refuses_more_nodes_than_a_machine_takes) {
  const std::vector<MeshLayer> layers = {{tissue::fat, 100.0}};
  EXPECT_THROW(mesh_of_layers(layers, 200.0, 1.0), InputError);
}

}  // namespace
}  // namespace bodkin
