#include "fem/solid/patient_body.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/fem/lattice_body.h"
#include "tests/io/scratch_folder.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const NeedlePath block_path{Vec3(20.0, 20.0, 0.0), Vec3(20.0, 20.0, 20.0)};

// A block of 40 mm in a volume of 60: skin from z = 0 to 2, muscle to 40; air before it, more muscle behind it, and
// air beside it but for x > 40.
Case block_patient() {
  std::vector<TissueProperties> tissues(4);
  tissues[0].name = "air";
  tissues[1] = {.id = tissue::skin, .name = "skin", .title = "skin"};
  tissues[1].deformable = {.young = 0.02, .poisson = 0.3, .friction = 0.02, .puncture_force = 1.5, .stiffness = 0.3};
  tissues[2] = {.id = tissue::muscle, .name = "muscle", .title = "muscle"};
  tissues[2].deformable = {.young = 0.03, .poisson = 0.4, .friction = 0.02, .puncture_force = 0.9, .stiffness = 0.3};
  tissues[3] = {.id = tissue::cortical_bone, .name = "cortical_bone", .title = "cortical bone"};
  tissues[3].layered.kind = LayeredKind::rigid;
  tissues[3].deformable = {.young = 12000, .poisson = 0.3, .friction = 0.2, .puncture_force = 100, .stiffness = 1};
  Case patient;
  patient.library = TissueLibrary(tissues);
  Grid grid;
  grid.size = {60, 60, 60};
  grid.origin = Vec3(-10.0, -10.0, -10.0);
  patient.tissues = TissueVolume(grid, tissue::air);
  for (int k = 10; k < 60; ++k) {
    for (int j = 10; j <= 50; ++j) {
      for (int i = 10; i < 60; ++i) patient.tissues.at(i, j, k) = k < 12 ? tissue::skin : tissue::muscle;
    }
  }
  patient.description.procedure.path = block_path;
  return patient;
}

TetrahedralMesh block_of_muscle() {
  TetrahedralMesh mesh = kuhn_lattice(9, 40.0);
  std::fill(mesh.tissues.begin(), mesh.tissues.end(), tissue::muscle);
  return mesh;
}

bool is_fixed(const BodyDescription& body, const Vec3& at) {
  return std::any_of(body.fixed.begin(), body.fixed.end(),
                     [&](std::uint32_t node) { return (body.mesh.nodes[node] - at).norm() < 1e-9; });
}

TEST(DescribeBody, faces_behind_which_the_patient_goes_on_are_held) {
  const BodyDescription body = describe_body(block_of_muscle(), block_patient(), {}, block_path);
  EXPECT_TRUE(is_fixed(body, {20, 20, 40}));   // the far side
  EXPECT_TRUE(is_fixed(body, {40, 20, 20}));   // the side on which there is more muscle
  EXPECT_FALSE(is_fixed(body, {0, 20, 20}));   // air
  EXPECT_FALSE(is_fixed(body, {20, 20, 0}));   // the skin
  EXPECT_FALSE(is_fixed(body, {20, 20, 20}));  // inside
  DeformableBodySettings settings;
  settings.fix_cut = false;
  settings.fix_beyond = 34.0;
  const BodyDescription other = describe_body(block_of_muscle(), block_patient(), settings, block_path);
  EXPECT_FALSE(is_fixed(other, {40, 20, 20}));
  EXPECT_TRUE(is_fixed(other, {0, 0, 35}));
  EXPECT_FALSE(is_fixed(other, {0, 0, 30}));
}

TEST(DescribeBody, bone_is_held_unless_the_case_says_otherwise) {
  TetrahedralMesh mesh = block_of_muscle();
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto& corners = mesh.elements[e];
    const bool low =
        std::all_of(corners.begin(), corners.end(), [&](std::uint32_t node) { return mesh.nodes[node].x() < 5.1; });
    if (low) mesh.tissues[e] = tissue::cortical_bone;
  }
  EXPECT_TRUE(is_fixed(describe_body(mesh, block_patient(), {}, block_path), {5, 20, 20}));
  DeformableBodySettings settings;
  settings.fix_bone = false;
  EXPECT_FALSE(is_fixed(describe_body(mesh, block_patient(), settings, block_path), {5, 20, 20}));
}

// Pressed at the skin: held nodes do not move, those between do, and bone and the far side bear the whole push.
TEST(DescribeBody, bone_and_the_far_side_do_not_move_and_bear_what_presses_the_skin) {
  TetrahedralMesh mesh = block_of_muscle();
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto& corners = mesh.elements[e];
    const auto is_in_bone = [&](std::uint32_t node) {
      return mesh.nodes[node].x() < 10.1 && mesh.nodes[node].z() > 19.9 && mesh.nodes[node].z() < 30.1;
    };
    if (std::all_of(corners.begin(), corners.end(), is_in_bone)) mesh.tissues[e] = tissue::cortical_bone;
  }
  const BodyDescription body = describe_body(mesh, block_patient(), {}, block_path);
  const auto node_at = [&](const Vec3& at) {
    const auto found = std::find_if(body.mesh.nodes.begin(), body.mesh.nodes.end(),
                                    [&](const Vec3& node) { return (node - at).norm() < 1e-9; });
    return static_cast<Eigen::Index>(found - body.mesh.nodes.begin());
  };
  const ElasticBody solid(body, plan_body(body), {.keep_field = true});
  const Vec3 push(0.0, 0.0, 0.5);  // N, inwards
  const auto rows = 3 * static_cast<Eigen::Index>(body.mesh.nodes.size());
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(rows, 1);
  forces.block<3, 1>(3 * node_at({20, 20, 0}), 0) = push;
  const Eigen::VectorXd moved = solid.displacement(forces);
  const auto at = [&](const Vec3& place) { return Vec3(moved.segment<3>(3 * node_at(place))); };
  for (const Vec3& bone : {Vec3(0, 20, 20), Vec3(10, 20, 25), Vec3(5, 35, 30)}) EXPECT_EQ(at(bone), Vec3::Zero());
  for (const double beside : {0.0, 20.0, 40.0}) EXPECT_EQ(at({beside, 20, 40}), Vec3::Zero()) << "the far side";
  EXPECT_GT(at({20, 20, 0}).z(), 0.1) << "mm, under the finger";
  EXPECT_GT(at({20, 20, 20}).z(), 0.02) << "mm, between it and the far side";
  EXPECT_GT(at({5, 20, 15}).norm(), 0.002) << "mm, muscle before the bone";
  const Eigen::VectorXd held = elastic_forces(body.mesh, body.materials, moved);
  Vec3 borne = Vec3::Zero();
  for (const std::uint32_t node : body.fixed) borne += held.segment<3>(3 * static_cast<Eigen::Index>(node));
  EXPECT_LT((borne + push).norm(), 1e-6) << borne.transpose();
}

TEST(DescribeBody, the_corridor_is_what_lies_nearest_to_the_path) {
  const BodyDescription body = describe_body(block_of_muscle(), block_patient(), {}, block_path);
  EXPECT_TRUE(body.corridor.empty());
  std::vector<std::string> notes;
  const std::vector<std::uint32_t> all = corridor_about(body, block_path, {.radius = 7.5}, notes);
  EXPECT_TRUE(notes.empty());
  for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node) {
    const Vec3& at = body.mesh.nodes[node];
    const double beside = (at - Vec3(20.0, 20.0, std::clamp(at.z(), -5.0, 35.0))).norm();
    const bool in = std::find(all.begin(), all.end(), node) != all.end();
    EXPECT_EQ(in, beside <= 7.5 && !is_fixed(body, at)) << at.transpose();
  }
  EXPECT_EQ(corridor_about(body, block_path, {.radius = 7.5, .nodes = 10.0}, notes).size(), 10U);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0], AllOf(HasSubstr("at most 10 nodes"), HasSubstr("corridor_nodes")));
}

TEST(DescribeBody, moduli_are_those_of_the_library_times_the_scale) {
  DeformableBodySettings settings;
  settings.stiffness_scale = 2.0;
  const BodyDescription body = describe_body(block_of_muscle(), block_patient(), settings, block_path);
  ASSERT_NE(body.materials.find(tissue::muscle), nullptr);
  EXPECT_DOUBLE_EQ(body.materials.find(tissue::muscle)->young, 0.06);
  EXPECT_DOUBLE_EQ(body.materials.find(tissue::muscle)->poisson, 0.4);
  EXPECT_EQ(body.materials.find(tissue::skin), nullptr);  // the mesh has none
}

TEST(DescribeBody, thin_layers_that_the_mesh_has_merged_are_felt) {
  const Case patient = block_patient();
  BodyDescription described = describe_body(block_of_muscle(), patient, {}, block_path);
  std::vector<std::string> notes;
  described.corridor = corridor_about(described, block_path, {}, notes);
  CondensedBody body = condense(described);
  EXPECT_EQ(std::count(body.tissues.begin(), body.tissues.end(), tissue::skin), 0);
  body.nodes.front() = Vec3(20.0, 20.0, -1.4);  // a little outside, as the surface of a mesh is here and there
  take_tissues_of_voxels(body, patient);
  EXPECT_EQ(body.tissues.front(), tissue::skin);
  for (std::size_t node = 1; node < body.nodes.size(); ++node)
    EXPECT_EQ(body.tissues[node], body.nodes[node].z() < 1.5 ? tissue::skin : tissue::muscle);
}

TEST(DescribeBody, what_cannot_be_a_body_is_refused) {
  Case patient = block_patient();
  EXPECT_THAT(refusal([&] {
                describe_body(block_of_muscle(), patient, {}, {block_path.entry, block_path.entry});
              }),
              HasSubstr("ends where it begins"));
  TetrahedralMesh mesh = block_of_muscle();
  mesh.tissues[7] = tissue::fat;
  EXPECT_THAT(refusal([&] { describe_body(mesh, patient, {}, block_path); }),
              AllOf(HasSubstr("element 7"), HasSubstr("tissue 2"), HasSubstr("<deformable>")));
  const NeedlePath elsewhere{Vec3(500.0, 0.0, 0.0), Vec3(500.0, 0.0, 20.0)};
  const BodyDescription body = describe_body(block_of_muscle(), patient, {}, elsewhere);
  std::vector<std::string> notes;
  EXPECT_THAT(refusal([&] { corridor_about(body, elsewhere, {}, notes); }), HasSubstr("within 25 mm"));
}

}  // namespace
}  // namespace bodkin
