#include "fem/solid/mesh_soundness.h"

#include <algorithm>
#include <array>
#include <limits>

#include "tests/fem/lattice_body.h"
#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fem/solid/elastic_body.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TetrahedralMesh one_tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}, {tissue::soft}};
}

std::string mesh_refusal(const TetrahedralMesh& mesh) {
  return refusal([&mesh] { check_mesh(mesh); });
}

TEST(MeshSoundness, good_meshes_pass_without_a_word) {
  EXPECT_TRUE(check_mesh(one_tetrahedron()).empty());
  EXPECT_TRUE(check_mesh(lattice_body(6, 50.0, 0.1, 1).mesh).empty());
}

TEST(MeshSoundness, a_poor_mesh_is_used_with_a_warning) {
  TetrahedralMesh mesh = one_tetrahedron();
  mesh.nodes[3] = {0.3, 0.3, 0.01};
  const std::vector<std::string> warnings = check_mesh(mesh);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], AllOf(HasSubstr("1 of 1 elements"), HasSubstr("below 5 degrees"),
                                 HasSubstr("element 0 at (0.3, 0.3, 0.0) mm")));
}

TEST(MeshSoundness, refuses_a_mesh_that_is_no_mesh) {
  EXPECT_THAT(mesh_refusal({}), HasSubstr("no elements"));
  TetrahedralMesh mesh = one_tetrahedron();
  mesh.tissues.clear();
  EXPECT_THAT(mesh_refusal(mesh), HasSubstr("1 elements but 0 tissues"));
  mesh = one_tetrahedron();
  mesh.elements[0][2] = 4;
  EXPECT_THAT(mesh_refusal(mesh), HasSubstr("element 0 has the corner 4, but the nodes of the mesh are 0 to 3"));
  mesh = one_tetrahedron();
  mesh.nodes[2].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(mesh_refusal(mesh), HasSubstr("node 2 of the mesh lies at (0, nan, 0)"));
  mesh = one_tetrahedron();
  mesh.nodes.push_back({5, 6, 7});
  EXPECT_THAT(mesh_refusal(mesh),
              AllOf(HasSubstr("node 4 at (5.0, 6.0, 7.0) mm belongs to no element"), HasSubstr("1 such")));
}

TEST(MeshSoundness, refuses_elements_that_are_inverted_or_flat) {
  TetrahedralMesh mesh = one_tetrahedron();
  std::swap(mesh.elements[0][0], mesh.elements[0][1]);
  EXPECT_THAT(mesh_refusal(mesh), AllOf(HasSubstr("element 0 at (0.2, 0.2, 0.2) mm is inverted"),
                                        HasSubstr("-0.167 mm^3"), HasSubstr("exchange two of its corners")));
  for (const double height : {1e-7, 0.0, -1e-7}) {
    mesh = one_tetrahedron();
    mesh.nodes[3] = {0.3, 0.3, height};
    EXPECT_THAT(mesh_refusal(mesh), AllOf(HasSubstr("element 0 at"), HasSubstr("is flat"), HasSubstr("slivers")))
        << height;
  }
  mesh = one_tetrahedron();
  mesh.nodes[3] = {0.3, 0.3, 2e-5};
  EXPECT_NO_THROW(check_mesh(mesh));
  mesh.elements[0][3] = 2;  // a corner twice
  mesh.nodes.pop_back();
  EXPECT_THAT(mesh_refusal(mesh), HasSubstr("is flat"));
}

TEST(MeshSoundness, refuses_an_element_that_is_there_twice) {
  TetrahedralMesh mesh = lattice_body(4, 30.0, 0.0, 1).mesh;
  std::array<std::uint32_t, 4> again = mesh.elements[7];
  std::rotate(again.begin(), again.begin() + 1, again.begin() + 3);  // the same tetrahedron from another corner
  mesh.elements.push_back(again);
  mesh.tissues.push_back(tissue::fat);
  EXPECT_THAT(mesh_refusal(mesh), AllOf(HasSubstr("elements 7 and 162 at ("), HasSubstr("the same four corners"),
                                        HasSubstr("remove one of them")));
}

TEST(MeshSoundness, refuses_supports_that_are_nearly_on_a_line) {
  TetrahedralMesh mesh = one_tetrahedron();
  mesh.nodes[2] = {0.5, 1e-4, 0.0};
  mesh.nodes[3] = {0.3, 0.3, 1.0};
  const std::vector<std::uint32_t> fixed = {0, 1, 2};
  EXPECT_THAT(refusal([&] { check_supports(mesh, fixed); }), HasSubstr("on one line or nearly so"));
  mesh.nodes[2].y() = 1e-2;
  EXPECT_NO_THROW(check_supports(mesh, fixed));
}

TEST(MeshSoundness, refuses_a_body_that_nothing_holds) {
  const TetrahedralMesh mesh = one_tetrahedron();
  const auto supports = [&mesh](const std::vector<std::uint32_t>& fixed) {
    return refusal([&] { check_supports(mesh, fixed); });
  };
  EXPECT_THAT(supports({}),
              AllOf(HasSubstr("no node of the body is fixed"), HasSubstr("fix its bone or its far side")));
  EXPECT_THAT(supports({0, 1, 9}), HasSubstr("node 9 is to be fixed, but the nodes of the mesh are 0 to 3"));
  EXPECT_THAT(supports({0, 1}), AllOf(HasSubstr("4 nodes"), HasSubstr("on one line")));
  EXPECT_THAT(supports({0, 0, 1, 1}), HasSubstr("on one line"));
  EXPECT_NO_THROW(check_supports(mesh, std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(MeshSoundness, refuses_an_island_that_nothing_holds) {
  TetrahedralMesh mesh = one_tetrahedron();
  for (const Vec3& node : one_tetrahedron().nodes) mesh.nodes.emplace_back(node + Vec3(20, 30, 40));
  mesh.elements.push_back({4, 5, 6, 7});
  mesh.tissues.push_back(tissue::soft);
  const std::vector<std::uint32_t> fixed = {0, 1, 2}, both = {0, 1, 2, 5, 6, 7};
  EXPECT_THAT(refusal([&] { check_supports(mesh, fixed); }),
              AllOf(HasSubstr("a piece of the body with 4 nodes, node 4 at (20.0, 30.0, 40.0) mm among them"),
                    HasSubstr("none of its nodes is fixed"), HasSubstr("mesh the body without it")));
  EXPECT_NO_THROW(check_supports(mesh, both));
}

TEST(ElasticMaterials, refuses_values_that_no_tissue_can_have) {
  ElasticMaterials materials;
  for (const double young :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_THAT(refusal([&] {
                  materials.set(4, {young, 0.3});
                }),
                AllOf(HasSubstr("Young's modulus of tissue 4"), HasSubstr("expected more than 0")));
  for (const double poisson : {0.4901, 0.5, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THAT(refusal([&] {
                  materials.set(4, {0.02, poisson});
                }),
                AllOf(HasSubstr("Poisson's ratio of tissue 4"), HasSubstr("at most 0.49")));
  EXPECT_EQ(materials.find(4), nullptr);
  materials.set(4, {0.02, 0.49});
  EXPECT_EQ(materials.find(4)->poisson, 0.49);
}

TEST(ElasticMaterials, warns_of_tissues_of_very_different_stiffness) {
  const TetrahedralMesh mesh = kuhn_lattice(4, 30.0);
  TetrahedralMesh layered = mesh;
  layered.tissues[3] = tissue::ligamentum_flavum;
  ElasticMaterials materials = soft_and_ligament();
  materials.set(tissue::ligamentum_flavum, {0.020 * 0.99e6, 0.3});
  EXPECT_TRUE(check_materials(layered, materials).empty());
  materials.set(tissue::ligamentum_flavum, {0.020 * 1.01e6, 0.3});
  EXPECT_TRUE(check_materials(mesh, materials).empty());
  const std::vector<std::string> warnings = check_materials(layered, materials);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0],
              AllOf(HasSubstr("a Young's modulus of 0.02 MPa"), HasSubstr("20200 MPa"), HasSubstr("fix_bone")));
}

TEST(ElasticMaterials, refuses_a_tissue_without_a_material) {
  BodyDescription body = lattice_body(4, 30.0, 0.0, 4);
  body.mesh.tissues[100] = 77;
  EXPECT_THAT(refusal([&] { condense(body); }),
              AllOf(HasSubstr("tissue 77 of element 100 at ("), HasSubstr(") mm has no material"),
                    HasSubstr("give the tissue a Young's modulus")));
}

}  // namespace
}  // namespace bodkin
