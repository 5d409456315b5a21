// A stiff skin whose elements bend.
#include "fem/solid/quadratic_edges.h"

#include <algorithm>
#include <map>
#include <set>

#include "tests/fem/calculix_block.h"
#include "tests/fem/layered_block.h"
#include "tests/sanitized.h"
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "core/random.h"
#include "fem/solid/contact_body.h"
#include "fem/solid/tip_compliance.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

std::vector<bool> fixed_in(const BodyDescription& body) {
  std::vector<bool> fixed(body.mesh.nodes.size(), false);
  for (const std::uint32_t node : body.fixed) fixed[node] = true;
  return fixed;
}

std::vector<bool> stiff_skin_of(const BodyDescription& body) {
  return elements_of_stiff_skin(body.mesh, body.materials, fixed_in(body));
}

std::set<TissueId> tissues_of(const BodyDescription& body, const std::vector<bool>& elements) {
  std::set<TissueId> tissues;
  for (std::size_t element = 0; element < elements.size(); ++element)
    if (elements[element]) tissues.insert(body.mesh.tissues[element]);
  return tissues;
}

// mm/N, of a disk in the middle of the top.
double compliance_of_disk(const ContactBody& body, const Vec3& entry, double radius) {
  const std::vector<ContactSite> skin = {{entry, 0.0, tissue::skin, true, true}};
  return body.contact_points(skin, -Vec3::UnitZ(), radius).compliance(2, 2);
}

TEST(QuadraticEdges, are_those_of_the_chosen_elements_each_once) {
  const TetrahedralMesh mesh = kuhn_lattice(3, 10.0);
  Random random(3);
  std::vector<bool> chosen, fixed;
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) chosen.push_back(random.uniform() < 0.3);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) fixed.push_back(mesh.nodes[i].z() == 0.0);
  const QuadraticEdges edges(mesh, chosen, fixed);
  std::set<std::pair<std::uint32_t, std::uint32_t>> expected;
  for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
    for (const std::uint32_t a : mesh.elements[element])
      for (const std::uint32_t b : mesh.elements[element])
        if (chosen[element] && a < b && !(fixed[a] && fixed[b])) expected.emplace(a, b);
  }
  ASSERT_EQ(edges.size(), expected.size());
  EXPECT_EQ(edges.first_unknown(), 18U) << "nine of 27 nodes are fixed";
  std::set<std::uint32_t> unknowns;
  for (std::uint32_t a = 0; a < mesh.nodes.size(); ++a) {
    for (std::uint32_t b = a + 1; b < mesh.nodes.size(); ++b) {
      EXPECT_EQ(edges.unknown(a, b), edges.unknown(b, a));
      if (expected.contains({a, b})) {
        const std::uint32_t unknown = edges.unknown(a, b);
        ASSERT_GE(unknown, 18U);
        EXPECT_EQ(edges.ends(unknown - 18U), (std::array<std::uint32_t, 2>{a, b}));
        unknowns.insert(unknown);
      } else {
        EXPECT_EQ(edges.unknown(a, b), QuadraticEdges::none);
      }
    }
  }
  EXPECT_EQ(unknowns.size(), expected.size());
  EXPECT_EQ(QuadraticEdges().unknown(0, 1), QuadraticEdges::none);
}

// Between elements with and without quadratic edges, an even strain needs no inner force, neither on a node nor on an
// edge.
TEST(QuadraticEdges, an_even_strain_goes_on_through_elements_of_both_orders) {
  const TetrahedralMesh mesh = kuhn_lattice(5, 20.0, 0.2);
  ElasticMaterials materials;
  materials.set(tissue::soft, {0.02, 0.3});
  Random random(5);
  std::vector<bool> chosen, fixed(mesh.nodes.size(), false);
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) chosen.push_back(random.uniform() < 0.4);
  fixed[0] = true;  // at the origin
  const std::vector<std::uint32_t> held = {0};
  const ElasticSystem system = assemble(mesh, materials, held, QuadraticEdges(mesh, chosen, fixed));
  const Mat3 strain = (Mat3() << 0.01, 0.02, -0.01, 0.0, 0.03, 0.01, 0.02, -0.02, 0.01).finished();
  const auto size = 3 * Eigen::Index{system.stiffness.nodes};
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(size), forces = Eigen::VectorXd::Zero(size);
  for (std::size_t i = 0; i < system.mesh_nodes.size(); ++i)
    moved.segment<3>(3 * static_cast<Eigen::Index>(i)) = strain * mesh.nodes[system.mesh_nodes[i]];
  const BlockMatrix& matrix = system.stiffness;
  for (std::uint32_t column = 0; column < matrix.nodes; ++column) {
    for (std::size_t i = matrix.start[column]; i < matrix.start[column + 1]; ++i) {
      const Eigen::Index row = 3 * Eigen::Index{matrix.row[i]}, at = 3 * Eigen::Index{column};
      forces.segment<3>(row) += matrix.block[i] * moved.segment<3>(at);
      if (row != at) forces.segment<3>(at) += matrix.block[i].transpose() * moved.segment<3>(row);
    }
  }
  const auto inside = [&mesh](std::uint32_t a, std::uint32_t b) {  // no face of the box has both
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      for (const double side : {0.0, 20.0})
        if (mesh.nodes[a][axis] == side && mesh.nodes[b][axis] == side) return false;
    return true;
  };
  std::size_t nodes = 0, edges = 0;
  const double largest = forces.cwiseAbs().maxCoeff();  // on the surface
  for (std::uint32_t unknown = 0; unknown < matrix.nodes; ++unknown) {
    const bool is_edge = unknown >= system.mesh_nodes.size();
    const std::uint32_t a = system.mesh_node_of(unknown);
    if (!inside(a, is_edge ? system.edges.ends(unknown - system.mesh_nodes.size())[1] : a)) continue;
    ++(is_edge ? edges : nodes);
    EXPECT_LT(forces.segment<3>(3 * Eigen::Index{unknown}).cwiseAbs().maxCoeff(), 1e-12 * largest) << unknown;
  }
  EXPECT_EQ(nodes, 27U);
  EXPECT_GT(edges, 100U);
}

TEST(QuadraticEdges, a_place_in_an_element_carries_by_its_shape_functions) {
  const TetrahedralMesh mesh = kuhn_lattice(2, 1.0);
  const QuadraticEdges edges(mesh, std::vector<bool>(6, true), std::vector<bool>(8, false));
  std::vector<std::uint32_t> free(8);
  for (std::uint32_t node = 0; node < 8; ++node) free[node] = node;
  const auto& nodes = mesh.elements[2];
  const PointInMesh place{nodes, {0.1, 0.2, 0.3, 0.4}, 2};
  std::map<std::uint32_t, double> found;
  for (const CarriedPoint::Share& share : carried_point({&place, 1}, free, edges).shares)
    found[share.node] = share.weight;
  ASSERT_EQ(found.size(), 10U);
  for (std::size_t a = 0; a < 4; ++a) {
    EXPECT_EQ(found[nodes[a]], place.weights[a]);
    for (std::size_t b = a + 1; b < 4; ++b)
      EXPECT_DOUBLE_EQ(found[edges.unknown(nodes[a], nodes[b])], 4.0 * place.weights[a] * place.weights[b]);
  }
}

TEST(StiffSkin, is_the_skin_that_is_stiffer_than_what_it_covers) {
  std::vector<checks::BlockLayer> layers = checks::back_with_stiff_skin();
  const auto body = checks::layered_block(layers, 4.0, 1);
  const std::vector<bool> chosen = stiff_skin_of(*body);
  EXPECT_EQ(tissues_of(*body, chosen), std::set<TissueId>{tissue::skin}) << "ligament and muscle end at the sides";
  const auto of_skin = std::count(body->mesh.tissues.begin(), body->mesh.tissues.end(), tissue::skin);
  EXPECT_EQ(std::count(chosen.begin(), chosen.end(), true), of_skin);
  layers[0].young = 0.03;
  const auto soft = checks::layered_block(layers, 4.0, 1);
  EXPECT_TRUE(tissues_of(*soft, stiff_skin_of(*soft)).empty()) << "hardly stiffer than fat";
  const auto even = checks::layered_block(checks::back_of_one_tissue(), 5.0, 1);
  EXPECT_TRUE(tissues_of(*even, stiff_skin_of(*even)).empty()) << "there is nothing below";
  BodyDescription held = *body;
  for (std::uint32_t node = 0; node < held.mesh.nodes.size(); ++node)
    if (held.mesh.nodes[node].z() > 39.9) held.fixed.push_back(node);
  EXPECT_FALSE(tissues_of(held, stiff_skin_of(held)).contains(tissue::skin)) << "it cannot bend";
}

// Meshes of patients have their skin only around the needle's path; the rim of such a piece also borders on fat.
TEST(StiffSkin, may_be_a_piece_and_dimples_as_a_whole_one_does) {
  BodyDescription body = *checks::layered_block(checks::back_with_stiff_skin(), 3.3, 4);
  for (std::size_t element = 0; element < body.mesh.elements.size(); ++element) {
    Vec3 middle = Vec3::Zero();
    for (const std::uint32_t node : body.mesh.elements[element]) middle += 0.25 * body.mesh.nodes[node];
    const double aside = std::hypot(middle.x() - 30.0, middle.y() - 30.0);
    if (body.mesh.tissues[element] == tissue::skin && aside > 15.0) body.mesh.tissues[element] = tissue::fat;
  }
  EXPECT_EQ(tissues_of(body, stiff_skin_of(body)), std::set<TissueId>{tissue::skin});
  const ContactBody piece(std::make_shared<const BodyDescription>(std::move(body)));
  EXPECT_NEAR(compliance_of_disk(piece, Vec3(30.0, 30.0, 40.0), 2.0), 3.305, 0.05 * 3.305) << "CalculiX, whole skin";
}

TEST(StiffSkin, what_refinement_adds_is_positive_at_any_place) {
  const auto body = checks::layered_block(checks::back_with_stiff_skin(), 5.0, 7);
  const PointFinder finder(body->mesh);
  const std::vector<bool> fixed = fixed_in(*body), skin = stiff_skin_of(*body);
  Random random(8);
  for (int i = 0; i < 6; ++i) {
    const TipDisk disk{.centre = Vec3(random.uniform(20.0, 40.0), random.uniform(20.0, 40.0), 40.0 - 0.5 * i),
                       .normal = Vec3(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), -1.0).normalized(),
                       .radius = 2.0};
    const Mat3 gain = refinement_gain({body->mesh, fixed, skin}, finder, body->materials, disk);
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Mat3>(gain).eigenvalues().minCoeff(), 0.0) << i;
  }
}

TEST(StiffSkin, dimpling_is_that_of_calculix_in_a_fine_mesh_of_second_order) {
  if (!checks::calculix_is_there()) GTEST_SKIP() << "ccx is not installed (Debian: calculix-ccx)";
  struct Disk {
    bool stiff_skin;
    double radius, tolerance;
  };
  // The widest is larger than most elements about it, and still smaller than what it is spread over.
  for (const auto& [stiff_skin, radius, tolerance] :
       {Disk{true, 2.0, 0.03}, {false, 0.5, 0.02}, {false, 1.0, 0.015}, {false, 4.0, 0.015}}) {
    const auto layers = stiff_skin ? checks::back_with_stiff_skin() : checks::back_of_one_tissue();
    const checks::CalculixBlock reference(layers, radius);
    const double theirs = reference.compliance();
    ASSERT_GT(theirs, 0.0);
    for (const double h : sanitized ? std::vector{5.0} : std::vector{5.0, 3.3, 2.6}) {
      const double ours =
          compliance_of_disk(ContactBody(checks::layered_block(layers, h, 4)), Vec3(30.0, 30.0, 40.0), radius);
      std::printf("  %s skin, a disk of %.1f mm, %.1f mm between nodes: %.3f mm/N, CalculiX with %zu nodes %.3f\n",
                  stiff_skin ? "stiff" : "no", radius, h, ours, reference.nodes(), theirs);
      EXPECT_NEAR(ours, theirs, tolerance * theirs) << "asked for are 5 %";
    }
  }
}

// With linear elements 2.69 to 2.72 mm/N were found for meshes of 1,700 to 20,000 nodes, and 3.31 are right.
TEST(StiffSkin, dimpling_hardly_depends_on_the_mesh_or_on_the_place_in_it) {
  double first = 0.0;
  for (const double h : {4.0, 3.3}) {
    const ContactBody body(checks::layered_block(checks::back_with_stiff_skin(), h, 4));
    double mean = 0.0, square = 0.0;
    constexpr int shifts = sanitized ? 3 : 8;
    for (int shift = 0; shift < shifts; ++shift) {
      const Vec3 entry(30.0 + h * std::fmod(0.618 * shift, 1.0), 30.0 + h * std::fmod(0.382 * shift * shift, 1.0),
                       40.0);
      const double here = compliance_of_disk(body, entry, 2.0);
      mean += here / shifts;
      square += here * here / shifts;
    }
    EXPECT_LT(std::sqrt(std::max(0.0, square - mean * mean)), 0.03 * mean);
    if (first > 0.0) {
      EXPECT_NEAR(mean, first, 0.05 * first);
    }
    first = mean;
  }
}

TEST(StiffSkin, has_the_same_bits_for_any_number_of_threads) {
  const auto description = checks::layered_block(checks::back_with_stiff_skin(), 6.0, 2);
  const ContactBody one(description, {.threads = 1}), three(description, {.threads = 3});
  const auto numbers = one.factor().numbers(), others = three.factor().numbers();
  EXPECT_GT(one.factor().nodes(), description->mesh.nodes.size());
  EXPECT_TRUE(std::ranges::equal(numbers, others));
  EXPECT_EQ(compliance_of_disk(one, Vec3(29.0, 31.0, 40.0), 1.5),
            compliance_of_disk(three, Vec3(29.0, 31.0, 40.0), 1.5));
}

}  // namespace
}  // namespace bodkin
