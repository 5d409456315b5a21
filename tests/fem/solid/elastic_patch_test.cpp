// Bodies with known exact solutions, on irregular meshes.
#include "tests/fem/lattice_body.h"
#include <gtest/gtest.h>

#include "core/random.h"
#include "fem/solid/elastic_body.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

constexpr double patch_side = 10.0;  // mm

BodyDescription patch_body(const ElasticMaterial& material, std::uint64_t seed) {
  BodyDescription body;
  body.mesh = kuhn_lattice(6, patch_side, 0.1, seed);
  body.materials.set(tissue::soft, material);
  for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node) {
    const Vec3& x = body.mesh.nodes[node];
    if (x.minCoeff() == 0.0 || x.maxCoeff() == patch_side)
      body.fixed.push_back(node);
    else
      body.corridor.push_back(node);
  }
  return body;
}

// The displacement of all nodes with the fixed ones held according to `field`.
template <typename Field>
Eigen::VectorXd held_at(const BodyDescription& body, const Field& field) {
  const auto size = 3 * static_cast<Eigen::Index>(body.mesh.nodes.size());
  Eigen::VectorXd held = Eigen::VectorXd::Zero(size);
  for (const std::uint32_t node : body.fixed) held.segment<3>(3 * Eigen::Index{node}) = field(body.mesh.nodes[node]);
  const ElasticBody elastic(body, plan_body(body));
  return held + elastic.displacement(-elastic_forces(body.mesh, body.materials, held));
}

TEST(ElasticPatch, pressed_between_walls_pushes_back_with_the_constrained_modulus) {
  struct Known {
    double young, force;  // MPa, N
  };
  for (const Known& known : {Known{0.020, 0.134615}, Known{0.170, 1.14423}}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const BodyDescription body = patch_body({known.young, 0.3}, seed);
      const Eigen::VectorXd moved = held_at(body, [](const Vec3& x) { return Vec3(0.0, 0.0, -0.05 * x.z()); });
      const Eigen::VectorXd forces = elastic_forces(body.mesh, body.materials, moved);
      double top = 0.0;
      for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node)
        if (body.mesh.nodes[node].z() == patch_side) top -= forces(3 * Eigen::Index{node} + 2);
      const double modulus = known.young * 0.7 / (1.3 * 0.4);
      EXPECT_NEAR(top, modulus * patch_side * patch_side * 0.05, 1e-12);
      EXPECT_NEAR(top, known.force, 5e-6);
    }
  }
}

TEST(ElasticPatch, any_linear_field_on_the_border_goes_on_inside) {
  Random random(3);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const BodyDescription body = patch_body({0.05, random.uniform(-0.5, 0.49)}, seed);
    const Mat3 gradient = 0.1 * Mat3::NullaryExpr([&random] { return random.normal(); });
    const Eigen::VectorXd moved = held_at(body, [&gradient](const Vec3& x) { return Vec3(gradient * x); });
    for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node)
      EXPECT_LT((moved.segment<3>(3 * Eigen::Index{node}) - gradient * body.mesh.nodes[node]).norm(), 1e-12);
  }
}

// A pull of 0.001 MPa along the fibres and across them: the strains are those of the moduli, the border has no other
// force.
TEST(ElasticPatch, fibres_stretch_by_their_own_modulus_along_and_across) {
  constexpr double pull = 0.001, young = 0.17, along = 10.0, nu = 0.3;
  for (const Eigen::Index fibre : {Eigen::Index{0}, Eigen::Index{2}}) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      ElasticMaterial material{young, nu, Vec3::Unit(fibre), along, 0.4};
      const BodyDescription body = patch_body(material, 7);
      Vec3 strain;
      for (Eigen::Index i = 0; i < 3; ++i)
        strain[i] = i == axis ? pull / (axis == fibre ? along : young)
                              : -nu * pull / (i == fibre || axis == fibre ? along : young);
      const Eigen::VectorXd moved = held_at(body, [&](const Vec3& x) { return Vec3(strain.cwiseProduct(x)); });
      for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node)
        EXPECT_LT((moved.segment<3>(3 * Eigen::Index{node}) - strain.cwiseProduct(body.mesh.nodes[node])).norm(),
                  1e-12);
      const Eigen::VectorXd forces = elastic_forces(body.mesh, body.materials, moved);
      Vec3 far = Vec3::Zero();  // on the three faces away from the origin, each along its own axis
      for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node)
        for (Eigen::Index i = 0; i < 3; ++i)
          if (body.mesh.nodes[node][i] == patch_side) far[i] += forces(3 * Eigen::Index{node} + i);
      const Vec3 expected = pull * patch_side * patch_side * Vec3::Unit(axis);
      EXPECT_LT((far - expected).norm(), 1e-12) << "fibres " << fibre << ", pull " << axis;
    }
  }
}

// What docs/fem.md says of a slab of ligament, 10 mm thick, that a needle pushes at right angles to its fibres.
TEST(ElasticPatch, fibres_across_the_needle_change_its_dimple_by_a_few_percent) {
  const auto way_of = [](const ElasticMaterial& ligament) {
    BodyDescription body = lattice_body(17, 48.0, 0.1, 10);
    body.materials.set(tissue::soft, {0.2, 0.3});
    body.materials.set(tissue::ligamentum_flavum, ligament);
    std::uint32_t middle = 0;
    for (std::uint32_t node = 0; node < body.mesh.nodes.size(); ++node)
      if ((body.mesh.nodes[node] - Vec3::Constant(24.0)).norm() <
          (body.mesh.nodes[middle] - Vec3::Constant(24.0)).norm())
        middle = node;
    const ElasticBody elastic(body, plan_body(body));
    Eigen::VectorXd force = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(body.mesh.nodes.size()));
    force(3 * Eigen::Index{middle} + 2) = 1.0;
    return elastic.displacement(force)(3 * Eigen::Index{middle} + 2);
  };
  const double without = way_of({1.7, 0.3}), shear = 1.7 / 2.6;
  EXPECT_NEAR(way_of({1.7, 0.3, Vec3::UnitX(), 15.0, shear}) / without, 0.96, 0.01);
  EXPECT_NEAR(way_of({1.7, 0.3, Vec3::UnitX(), 150.0, shear}) / without, 0.94, 0.01);
}

TEST(ElasticPatch, forces_of_the_assembled_matrix_are_those_of_the_elements) {
  Random random(5);
  const BodyDescription body = lattice_body(5, 40.0, 0.1, 10);
  const ElasticSystem system = assemble(body.mesh, body.materials, body.fixed);
  const auto free = static_cast<Eigen::Index>(system.mesh_nodes.size());
  const Eigen::VectorXd on_free = Eigen::VectorXd::NullaryExpr(3 * free, [&random] { return random.normal(); });
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(body.mesh.nodes.size()));
  Eigen::VectorXd product = Eigen::VectorXd::Zero(3 * free);
  const BlockMatrix& matrix = system.stiffness;
  for (std::uint32_t column = 0; column < matrix.nodes; ++column) {
    moved.segment<3>(3 * Eigen::Index{system.mesh_nodes[column]}) = on_free.segment<3>(3 * Eigen::Index{column});
    for (std::size_t b = matrix.start[column]; b < matrix.start[column + 1]; ++b) {
      const std::uint32_t row = matrix.row[b];
      product.segment<3>(3 * Eigen::Index{row}) += matrix.block[b] * on_free.segment<3>(3 * Eigen::Index{column});
      if (row == column) continue;
      product.segment<3>(3 * Eigen::Index{column}) +=
          matrix.block[b].transpose() * on_free.segment<3>(3 * Eigen::Index{row});
    }
  }
  const Eigen::VectorXd forces = elastic_forces(body.mesh, body.materials, moved);
  for (std::uint32_t i = 0; i < matrix.nodes; ++i)
    EXPECT_LT(
        (forces.segment<3>(3 * Eigen::Index{system.mesh_nodes[i]}) - product.segment<3>(3 * Eigen::Index{i})).norm(),
        1e-13 * forces.cwiseAbs().maxCoeff());
}

TEST(ElasticPatch, nodes_to_fix_are_found_by_tissue_and_by_plane) {
  const BodyDescription body = lattice_body(6, 50.0, 0.0, 1);
  const auto bottom = nodes_beyond(body.mesh, Vec3(0, 0, 10.0), Vec3(0, 0, -2.0));
  EXPECT_EQ(bottom.size(), 72U);  // two layers of 36
  EXPECT_TRUE(std::is_sorted(bottom.begin(), bottom.end()));
  const TissueId bone[] = {tissue::ligamentum_flavum};
  for (const std::uint32_t node : nodes_of_tissues(body.mesh, bone)) {
    EXPECT_GE(body.mesh.nodes[node].z(), 20.0);
    EXPECT_LE(body.mesh.nodes[node].z(), 30.0);
  }
  EXPECT_EQ(nodes_of_tissues(body.mesh, bone).size(), 72U);
  EXPECT_TRUE(nodes_of_tissues(body.mesh, {}).empty());
}

}  // namespace
}  // namespace bodkin
