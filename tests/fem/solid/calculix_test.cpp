// The same body solved by CalculiX; tests/cli/deformable_case_test.cpp does it with patients.
#include "tests/fem/calculix.h"

#include "tests/fem/lattice_body.h"
#include "tests/sanitized.h"

#include "fem/solid/packed_factor.h"
#include "fem/solid/tip_compliance.h"

namespace bodkin {
namespace {

TEST(CalculiX, moves_and_resists_the_same) {
  if (!checks::calculix_is_there()) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  checks::expect_what_calculix_says(lattice_body(sanitized ? 6 : 11, 100.0, 0.1, 80), 40);
}

TEST(CalculiX, moves_and_resists_the_same_where_a_tissue_has_fibres) {
  if (!checks::calculix_is_there()) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  for (const Vec3& fibre : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitZ())}) {
    BodyDescription body = lattice_body(sanitized ? 6 : 9, 100.0, 0.1, 80);
    body.materials.set(tissue::ligamentum_flavum, {0.17, 0.3, fibre, 10.0, 0.4});
    checks::expect_what_calculix_says(body, 30);
  }
}

std::vector<bool> fixed_nodes_of(const BodyDescription& body) {
  std::vector<bool> fixed(body.mesh.nodes.size(), false);
  for (const std::uint32_t node : body.fixed) fixed[node] = true;
  return fixed;
}

MultifrontalCholesky factor_of(const ElasticSystem& system) {
  return {system.stiffness, analyse(graph_of(system.stiffness), {}), {.threads = 1}};
}

TEST(CalculiX, elements_of_second_order_move_the_same) {
  if (!checks::calculix_is_there()) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  const BodyDescription body = lattice_body(5, 40.0, 0.2, 0);
  const QuadraticEdges edges(body.mesh, std::vector<bool>(body.mesh.elements.size(), true), fixed_nodes_of(body));
  const ElasticSystem system = assemble(body.mesh, body.materials, body.fixed, edges);
  const std::size_t nodes = body.mesh.nodes.size(), free = system.mesh_nodes.size();
  Random random(6);
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(3 * Eigen::Index{system.stiffness.nodes});
  std::string input = checks::calculix_mesh(body, edges) + "*CLOAD\n";
  for (std::size_t i = 0; i < free; i += 3) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double force = forces(3 * static_cast<Eigen::Index>(i) + axis) = random.uniform(-0.1, 0.1);
      input += fmt::format("{}, {}, {:.12g}\n", system.mesh_nodes[i] + 1, axis + 1, force);
    }
  }
  const Eigen::VectorXd solved = factor_of(system).solve(forces);
  const auto at = [&](std::uint32_t unknown) { return Vec3(solved.segment<3>(3 * Eigen::Index{unknown})); };
  const auto of_node = [&](std::uint32_t node) {
    const std::uint32_t number = system.free_nodes[node];
    return number == ElasticSystem::fixed ? Vec3(Vec3::Zero()) : at(number);
  };
  const ScratchFolder folder;
  ASSERT_TRUE(checks::calculix_ran(folder, input + "*NODE PRINT, NSET=ALL\nU\n*END STEP\n"));
  const Eigen::VectorXd theirs =
      checks::calculix_table(folder.path() / "body.dat", "displacements", nodes + edges.size());
  double off = 0.0, largest = 0.0;
  const auto compare = [&](std::size_t node, const Vec3& ours) {
    const Vec3 here = theirs.segment<3>(3 * static_cast<Eigen::Index>(node));
    off = std::max(off, (here - ours).cwiseAbs().maxCoeff());
    largest = std::max(largest, here.cwiseAbs().maxCoeff());
  };
  for (std::uint32_t node = 0; node < nodes; ++node) compare(node, of_node(node));
  for (std::uint32_t edge = 0; edge < edges.size(); ++edge) {
    const auto& [a, b] = edges.ends(edge);
    compare(nodes + edge, 0.5 * (of_node(a) + of_node(b)) + at(edges.first_unknown() + edge));
  }
  std::cout << "  " << edges.size() << " edges: displacements differ by " << off / largest << " of the largest\n";
  EXPECT_LT(off, 1e-6 * largest);
}

TEST(CalculiX, a_disk_under_an_even_load_sinks_the_same_on_the_same_mesh) {
  if (!checks::calculix_is_there()) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  const BodyDescription body = lattice_body(9, 60.0, 0.2, 0);
  const TipDisk disk{.centre = Vec3(31.0, 28.0, 60.0), .normal = Vec3(0.2, 0.1, -1.0).normalized(), .radius = 3.0};
  const ElasticSystem system = assemble(body.mesh, body.materials, body.fixed);
  const CarriedPoint point = carried_point(places_of(disk, PointFinder(body.mesh)), system.free_nodes, {});
  const std::vector<PointResponse> response = PackedFactor(factor_of(system)).respond({&point, 1});
  const Mat3 ours = compliance_between(response[0], response[0]);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::string input = checks::calculix_mesh(body) + "*CLOAD\n";
    for (const CarriedPoint::Share& share : point.shares)
      input += fmt::format("{}, {}, {:.14g}\n", system.mesh_nodes[share.node] + 1, axis + 1, share.weight);
    const ScratchFolder folder;
    ASSERT_TRUE(checks::calculix_ran(folder, input + "*NODE PRINT, NSET=ALL\nU\n*END STEP\n"));
    const Eigen::VectorXd theirs =
        checks::calculix_table(folder.path() / "body.dat", "displacements", body.mesh.nodes.size());
    Vec3 sunk = Vec3::Zero();
    for (const CarriedPoint::Share& share : point.shares)
      sunk += share.weight * theirs.segment<3>(3 * Eigen::Index{system.mesh_nodes[share.node]});
    const double off = (sunk - ours.col(axis)).cwiseAbs().maxCoeff();
    std::cout << "  along "
              << "xyz"[axis] << ": " << off / ours.col(axis).norm() << " off\n";
    EXPECT_LT(off, 1e-6 * ours.col(axis).norm());
  }
}

}  // namespace
}  // namespace bodkin
