#include "fem/solid/elastic_body.h"

#include "tests/fem/lattice_body.h"
#include "tests/io/scratch_folder.h"
#include "tests/sanitized.h"
#include <Eigen/Cholesky>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "fem/solid/available_memory.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// Some nodes of the corridor are held somewhere; by the compliance, and by a body in which
// they are among the fixed nodes.
TEST(ElasticBody, a_condensed_contact_is_that_of_a_full_constrained_solve) {
  const BodyDescription body = lattice_body(sanitized ? 6 : 10, 60.0, 0.1, 60);
  const CondensedBody condensed = condense(body);
  const Eigen::MatrixXd& compliance = condensed.compliance;
  Random random(1);
  for (int round = 0; round < (sanitized ? 3 : 10); ++round) {
    std::vector<Eigen::Index> held;
    for (Eigen::Index i = 0; i < 60; ++i)
      if (random.uniform() < 0.05 * (round + 1)) held.push_back(i);
    if (held.empty()) continue;
    const auto count = static_cast<Eigen::Index>(held.size());
    const Eigen::VectorXd way = Eigen::VectorXd::NullaryExpr(3 * count, [&random] { return random.normal(); });
    Eigen::MatrixXd between(3 * count, 3 * count);
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index j = 0; j < count; ++j)
        between.block<3, 3>(3 * i, 3 * j) =
            compliance.block<3, 3>(3 * held[static_cast<std::size_t>(i)], 3 * held[static_cast<std::size_t>(j)]);
    const Eigen::VectorXd force = between.llt().solve(way);

    BodyDescription stuck = body;
    Eigen::VectorXd moved = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(body.mesh.nodes.size()));
    for (Eigen::Index i = 0; i < count; ++i) {
      const std::uint32_t node = condensed.mesh_nodes[static_cast<std::size_t>(held[static_cast<std::size_t>(i)])];
      stuck.fixed.push_back(node);
      moved.segment<3>(3 * Eigen::Index{node}) = way.segment<3>(3 * i);
    }
    stuck.corridor.clear();
    moved += ElasticBody(stuck, plan_body(stuck)).displacement(-elastic_forces(body.mesh, body.materials, moved));
    const Eigen::VectorXd reaction = elastic_forces(body.mesh, body.materials, moved);
    for (Eigen::Index i = 0; i < count; ++i) {
      const std::uint32_t node = condensed.mesh_nodes[static_cast<std::size_t>(held[static_cast<std::size_t>(i)])];
      EXPECT_LT((reaction.segment<3>(3 * Eigen::Index{node}) - force.segment<3>(3 * i)).norm(), 1e-10 * force.norm());
    }
    Eigen::VectorXd on_corridor = Eigen::VectorXd::Zero(180);
    for (Eigen::Index i = 0; i < count; ++i)
      on_corridor.segment<3>(3 * held[static_cast<std::size_t>(i)]) = force.segment<3>(3 * i);
    const Eigen::VectorXd field = ElasticBody(body, plan_body(body)).displacement_by_corridor(on_corridor);
    EXPECT_LT((field - moved).cwiseAbs().maxCoeff(), 1e-10 * moved.cwiseAbs().maxCoeff());
  }
}

TEST(ElasticBody, no_force_on_the_corridor_gives_energy_back) {
  const Eigen::MatrixXd compliance = condense(lattice_body(7, 60.0, 0.1, 30)).compliance;
  EXPECT_EQ(Eigen::LLT<Eigen::MatrixXd>(compliance).info(), Eigen::Success);
}

TEST(ElasticBody, stiffness_scales_with_youngs_modulus_and_size) {
  const BodyDescription body = lattice_body(6, 60.0, 0.1, 20);
  BodyDescription stiff = body, small = body;
  stiff.materials.set(tissue::soft, {0.2, 0.3});
  stiff.materials.set(tissue::ligamentum_flavum, {1.7, 0.3});
  for (Vec3& node : small.mesh.nodes) node *= 0.1;
  const Eigen::MatrixXd compliance = condense(body).compliance;
  EXPECT_LT((10.0 * condense(stiff).compliance - compliance).cwiseAbs().maxCoeff(), 1e-12 * compliance.maxCoeff());
  EXPECT_LT((0.1 * condense(small).compliance - compliance).cwiseAbs().maxCoeff(), 1e-12 * compliance.maxCoeff());
}

TEST(ElasticBody, leaves_fixed_nodes_out_of_the_corridor_and_names_the_stiffest_tissue) {
  BodyDescription body = lattice_body(6, 50.0, 0.0, 20);
  body.corridor.insert(body.corridor.begin() + 3, body.fixed.begin(), body.fixed.end());
  const CondensedBody condensed = condense(body);
  ASSERT_EQ(condensed.nodes.size(), 20U);
  EXPECT_EQ(condensed.compliance.rows(), 60);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(condensed.nodes[i], body.mesh.nodes[condensed.mesh_nodes[i]]);
    const bool in_slab = condensed.nodes[i].z() > 19.0 && condensed.nodes[i].z() < 31.0;
    EXPECT_EQ(condensed.tissues[i], in_slab ? tissue::ligamentum_flavum : tissue::soft);
  }
}

TEST(ElasticBody, says_what_memory_it_needs_and_refuses_what_does_not_fit) {
  const BodyDescription body = lattice_body(8, 60.0, 0.1, 100);
  const std::size_t needed = plan_body(body).symbolic.bytes(false);
  EXPECT_GT(needed, 300U * 300U * 8U);
  FactorOptions options;
  options.memory_limit = needed;
  EXPECT_NO_THROW(condense(body, options));
  options.memory_limit = needed - 1;
  EXPECT_THAT(
      refusal([&] { condense(body, options); }),
      AllOf(HasSubstr("448 free nodes with 100 in the corridor"), HasSubstr(std::to_string(needed) + " bytes"),
            HasSubstr(std::to_string(needed - 1)), HasSubstr("choose a smaller corridor")));
  EXPECT_GT(available_memory(), 1U << 20U);
}

TEST(ElasticBody, tells_how_far_it_is) {
  std::vector<std::pair<std::string, double>> told;
  condense(lattice_body(8, 60.0, 0.1, 50), {},
           [&told](std::string_view stage, double fraction) { told.emplace_back(stage, fraction); });
  ASSERT_GT(told.size(), 4U);
  EXPECT_EQ(told.front().first, "assembling the body");
  EXPECT_EQ(told[1].first, "ordering the body");
  for (std::size_t i = 3; i < told.size(); ++i) {
    EXPECT_EQ(told[i].first, "factorising the body");
    EXPECT_GE(told[i].second, told[i - 1].second);
  }
  EXPECT_NEAR(told.back().second, 1.0, 0.02);
}

TEST(ElasticBody, refuses_a_corridor_that_no_needle_could_use) {
  BodyDescription body = lattice_body(5, 40.0, 0.1, 5);
  const auto condensed = [&body] { condense(body); };
  body.corridor.push_back(body.corridor[2]);
  EXPECT_THAT(refusal(condensed), AllOf(HasSubstr("of the corridor, at ("), HasSubstr("is named twice")));
  body.corridor.back() = 125;
  EXPECT_THAT(refusal(condensed), HasSubstr("node 125 of the corridor is not in the mesh, whose nodes are 0 to 124"));
  body.corridor = body.fixed;
  EXPECT_THAT(refusal(condensed), HasSubstr("none of the 25 nodes of the corridor can move"));
  body.corridor.clear();
  EXPECT_THAT(refusal(condensed), HasSubstr("none of the 0 nodes"));
  for (std::uint32_t node = 0; node < 125; ++node) body.fixed.push_back(node);
  EXPECT_THROW(assemble(body.mesh, body.materials, body.fixed), InputError);
}

TEST(ElasticBody, refuses_a_part_that_hangs_by_an_edge) {
  BodyDescription body = lattice_body(4, 30.0, 0.0, 3);
  // One more tetrahedron on the edge between the two middle nodes of the top.
  const std::uint32_t a = 53, b = 54;
  const auto first = static_cast<std::uint32_t>(body.mesh.nodes.size());
  body.mesh.nodes.push_back(body.mesh.nodes[a] + Vec3(0, 0, 8));
  body.mesh.nodes.push_back(body.mesh.nodes[a] + Vec3(2, -8, 8));
  body.mesh.elements.push_back({a, b, first, first + 1});
  body.mesh.tissues.push_back(tissue::soft);
  EXPECT_THAT(refusal([&] { condense(body); }), AllOf(HasSubstr("can move without resistance"),
                                                      HasSubstr("hangs by a node or an edge"), HasSubstr(") mm")));
}

TEST(ElasticBody, bone_in_fat_is_not_mistaken_for_a_loose_part) {
  BodyDescription body = lattice_body(7, 60.0, 0.1, 30);
  body.materials.set(tissue::soft, {0.001, 0.45});
  body.materials.set(tissue::ligamentum_flavum, {17000.0, 0.3});
  const CondensedBody condensed = condense(body);
  EXPECT_TRUE(condensed.compliance.allFinite());
  EXPECT_GT(condensed.compliance.diagonal().minCoeff(), 0.0);
}

}  // namespace
}  // namespace bodkin
