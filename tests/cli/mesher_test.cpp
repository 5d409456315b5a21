// The meshing worker on bodies whose shape is known.
#include "patient/meshing/mesher.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/cli/mesher_rig.h"
#include <gmock/gmock.h>

#include "anatomy/mesh_parts.h"
#include "anatomy/mesh_quality.h"
#include "core/error.h"
#include "io/tissue_library_file.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::patient;
namespace {

constexpr double outer = 30.0, inner = 15.0;  // mm, radii

// A ball of bone in a ball of muscle, on a lattice turned against the patient and mirrored.
TissueVolume nested_spheres() {
  Grid grid;
  grid.size = {70, 64, 78};
  grid.spacing = Vec3(1.0, 1.1, 0.9);
  grid.direction = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  grid.direction.col(2) *= -1.0;
  grid.origin = -(grid.direction * grid.spacing.cwiseProduct(Vec3(34.5, 31.5, 38.5)));
  TissueVolume tissues(grid, tissue::air);
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const double radius = grid.to_patient(Vec3(i, j, k)).norm();
        if (radius < outer) tissues.at(i, j, k) = radius < inner ? tissue::cortical_bone : tissue::muscle;
      }
    }
  }
  return tissues;
}

MeshedBody mesh_of_spheres() {
  MeshSettings settings;
  settings.nodes = 2000;
  return mesh_tissues(nested_spheres(), std::nullopt, default_tissue_library(), settings);
}

const MeshedBody& spheres() {
  static const MeshedBody made = mesh_of_spheres();
  return made;
}

// Elements on each face, by its nodes.
std::map<std::array<std::uint32_t, 3>, std::vector<std::size_t>> faces_of_mesh(const TetrahedralMesh& mesh) {
  std::map<std::array<std::uint32_t, 3>, std::vector<std::size_t>> faces;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      std::array<std::uint32_t, 3> face{};
      for (std::size_t i = 0; i < 3; ++i) face[i] = mesh.elements[e][(left_out + 1 + i) % 4];
      std::sort(face.begin(), face.end());
      faces[face].push_back(e);
    }
  }
  return faces;
}

TEST(Mesher, nested_spheres_have_their_volumes) {
  BODKIN_NEEDS_MESHER();
  const MeshQuality quality = measure_quality(spheres().mesh);
  EXPECT_EQ(quality.not_positive, 0U);
  EXPECT_GT(quality.smallest_angle, 2.0);
  EXPECT_NEAR(static_cast<double>(quality.nodes), 2000.0, 300.0);
  const auto ball = [](double radius) { return 4.0 / 3.0 * EIGEN_PI * std::pow(radius, 3); };
  ASSERT_EQ(quality.tissues.size(), 2U);
  EXPECT_EQ(quality.tissues[1].tissue, tissue::cortical_bone);
  EXPECT_NEAR(quality.tissues[1].volume / ball(inner), 1.0, 0.02);
  EXPECT_NEAR(quality.volume / ball(outer), 1.0, 0.02);
}

TEST(Mesher, nested_spheres_are_conforming_and_their_interface_is_one_sphere) {
  BODKIN_NEEDS_MESHER();
  const TetrahedralMesh& mesh = spheres().mesh;
  std::size_t outside = 0, between = 0;
  std::map<std::array<std::uint32_t, 2>, int> interface_edges;
  for (const auto& [face, elements] : faces_of_mesh(mesh)) {
    ASSERT_LE(elements.size(), 2U);
    const bool border = elements.size() == 1;
    const bool interface = !border && mesh.tissues[elements[0]] != mesh.tissues[elements[1]];
    if (!border && !interface) continue;
    ++(border ? outside : between);
    for (const std::uint32_t node : face) EXPECT_NEAR(mesh.nodes[node].norm(), border ? outer : inner, 1.0);
    if (!interface) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(face[i], face[(i + 1) % 3]);
      ++interface_edges[{a, b}];
    }
  }
  EXPECT_GT(outside, 200U);
  EXPECT_GT(between, 100U);
  std::set<std::uint32_t> nodes;
  for (const auto& [edge, faces] : interface_edges) {
    EXPECT_EQ(faces, 2);
    nodes.insert(edge.begin(), edge.end());
  }
  // Euler: a closed surface without holes.
  EXPECT_EQ(static_cast<int>(nodes.size()) - static_cast<int>(interface_edges.size()) + static_cast<int>(between), 2);
}

TEST(Mesher, the_same_tissues_give_the_same_mesh) {
  BODKIN_NEEDS_MESHER();
  const MeshedBody again = mesh_of_spheres();
  EXPECT_EQ(again.mesh.nodes, spheres().mesh.nodes);
  EXPECT_EQ(again.mesh.elements, spheres().mesh.elements);
  EXPECT_EQ(again.mesh.tissues, spheres().mesh.tissues);
}

TEST(Mesher, a_missing_worker_is_named_with_its_cure) {
  setenv("BODKIN_MESHER_WORKER", "/no/such/bodkin-mesher", 1);
  EXPECT_FALSE(mesher_present());
  try {
    mesh_of_spheres();
    FAIL();
  } catch (const SystemError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("/no/such/bodkin-mesher cannot be started"));
  }
  unsetenv("BODKIN_MESHER_WORKER");
}

}  // namespace
}  // namespace bodkin
