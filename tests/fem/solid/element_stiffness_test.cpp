#include "fem/solid/element_stiffness.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::fem;
namespace {

using Corners = std::array<Vec3, 4>;

const Corners unit_corners = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};

Corners random_corners(Random& random) {
  Corners corners = unit_corners;
  for (Vec3& corner : corners)
    corner = 10.0 * corner + Vec3(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2));
  return corners;
}

// Numbers of the unit tetrahedron, worked out by hand from the formula.
TEST(ElementStiffness, of_the_unit_tetrahedron_is_that_of_the_paper) {
  const auto k = element_stiffness(unit_corners, {0.02, 0.3});
  EXPECT_NEAR(tetrahedron_gradients(unit_corners).volume, 1.0 / 6.0, 1e-16);
  const double first[] = {0.007051282, 0.003205128, 0.003205128, -0.004487179, -0.001282051, -0.001282051};
  for (Eigen::Index j = 0; j < 6; ++j) EXPECT_NEAR(k(0, j), first[j], 5e-10) << j;
  EXPECT_NEAR(k(3, 3), 0.004487179, 5e-10);
  EXPECT_NEAR(k(4, 4), 0.001282051, 5e-10);
  EXPECT_NEAR(k(3, 7), 0.001923077, 5e-10);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Eigen::Matrix<double, 12, 1> translation = Eigen::Matrix<double, 12, 1>::Zero();
    for (Eigen::Index corner = 0; corner < 4; ++corner) translation(3 * corner + axis) = 1.0;
    EXPECT_LT((k * translation).cwiseAbs().maxCoeff(), 1e-15);
  }
}

TEST(ElementStiffness, is_symmetric_and_resists_everything_but_the_six_rigid_motions) {
  Random random(7);
  for (int round = 0; round < 50; ++round) {
    const Corners corners = random_corners(random);
    const auto k = element_stiffness(corners, {random.uniform(0.001, 1.0), random.uniform(-0.9, 0.49)});
    EXPECT_EQ(k, k.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(k, Eigen::EigenvaluesOnly);
    const auto& values = solver.eigenvalues();
    for (Eigen::Index i = 0; i < 6; ++i) EXPECT_LT(std::abs(values(i)), 1e-13 * values(11));
    for (Eigen::Index i = 6; i < 12; ++i) EXPECT_GT(values(i), 1e-6 * values(11));
    const Vec3 spin(random.normal(), random.normal(), random.normal());
    Eigen::Matrix<double, 12, 1> rotation;
    for (std::size_t corner = 0; corner < 4; ++corner)
      rotation.segment<3>(3 * static_cast<Eigen::Index>(corner)) = spin.cross(corners[corner]);
    EXPECT_LT((k * rotation).cwiseAbs().maxCoeff(), 1e-12 * values(11) * rotation.norm());
  }
}

// An energy, computed from the strain instead: V (lambda/2 tr^2 + mu e:e).
TEST(ElementStiffness, is_the_second_derivative_of_the_elastic_energy) {
  Random random(11);
  for (int round = 0; round < 50; ++round) {
    const Corners corners = random_corners(random);
    const ElasticMaterial material{random.uniform(0.001, 1.0), random.uniform(-0.5, 0.49)};
    const Mat3 gradient = Mat3::NullaryExpr([&random] { return random.normal(); });
    Eigen::Matrix<double, 12, 1> displacement;
    for (std::size_t corner = 0; corner < 4; ++corner)
      displacement.segment<3>(3 * static_cast<Eigen::Index>(corner)) = gradient * corners[corner];
    const Mat3 strain = 0.5 * (gradient + gradient.transpose());
    const LameConstants constants = lame_constants(material);
    const double volume =
        std::abs((corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(corners[3] - corners[0])) / 6.0;
    const double energy =
        volume * (0.5 * constants.lambda * strain.trace() * strain.trace() + constants.mu * strain.squaredNorm());
    const auto k = element_stiffness(corners, material);
    EXPECT_NEAR(0.5 * displacement.dot(k * displacement), energy, 1e-11 * energy);
  }
}

ElasticMaterial any_fibres(Random& random) {
  const Vec3 fibre = Vec3(random.normal(), random.normal(), random.normal()).normalized();
  const double young = random.uniform(0.01, 1.0);
  return {young, random.uniform(0.0, 0.45), fibre, young * random.uniform(0.8, 100.0),
          young * random.uniform(0.1, 20.0)};
}

// Six strains of unit stresses, as engineers write them: 11 22 33 23 13 12, the fibres along 3.
Eigen::Matrix<double, 6, 6> compliance_of(const ElasticMaterial& material) {
  const double nu = material.poisson, along = material.young_along;
  Eigen::Matrix<double, 6, 6> c = Eigen::Matrix<double, 6, 6>::Zero();
  c(0, 0) = c(1, 1) = 1.0 / material.young;
  c(0, 1) = c(1, 0) = -nu / material.young;
  c(2, 2) = 1.0 / along;
  c(0, 2) = c(2, 0) = c(1, 2) = c(2, 1) = -nu / along;
  c(3, 3) = c(4, 4) = 1.0 / material.shear_along;
  c(5, 5) = 2.0 * (1.0 + nu) / material.young;
  return c;
}

// The stiffness of engineers is the inverse of their compliances, in axes that are turned into the fibres.
TEST(FibreStiffness, has_the_energy_of_its_engineering_constants) {
  Random random(13);
  for (int round = 0; round < 50; ++round) {
    const Corners corners = random_corners(random);
    const ElasticMaterial material = any_fibres(random);
    const Mat3 gradient = Mat3::NullaryExpr([&random] { return random.normal(); });
    Eigen::Matrix<double, 12, 1> displacement;
    for (std::size_t corner = 0; corner < 4; ++corner)
      displacement.segment<3>(3 * static_cast<Eigen::Index>(corner)) = gradient * corners[corner];
    Mat3 axes;
    axes.col(2) = material.fibre;
    axes.col(0) = material.fibre.unitOrthogonal();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    const Mat3 strain = axes.transpose() * (0.5 * (gradient + gradient.transpose())) * axes;
    Eigen::Matrix<double, 6, 1> six;
    six << strain(0, 0), strain(1, 1), strain(2, 2), 2.0 * strain(1, 2), 2.0 * strain(0, 2), 2.0 * strain(0, 1);
    const Eigen::Matrix<double, 6, 1> stresses = compliance_of(material).inverse() * six;
    const double energy = 0.5 * tetrahedron_gradients(corners).volume * six.dot(stresses);
    const auto k = element_stiffness(corners, material);
    EXPECT_NEAR(0.5 * displacement.dot(k * displacement), energy, 1e-10 * energy);
    const Mat3 stress =
        axes.transpose() * stress_of(elastic_constants(material), 0.5 * (gradient + gradient.transpose())) * axes;
    EXPECT_NEAR(stress(2, 2), stresses(2), 1e-10 * stresses.norm());
    EXPECT_NEAR(stress(0, 2), stresses(4), 1e-10 * stresses.norm());
    EXPECT_NEAR(stress(0, 1), stresses(5), 1e-10 * stresses.norm());
  }
}

TEST(FibreStiffness, is_symmetric_and_resists_everything_but_the_six_rigid_motions) {
  Random random(17);
  for (int round = 0; round < 50; ++round) {
    const auto k = element_stiffness(random_corners(random), any_fibres(random));
    EXPECT_EQ(k, k.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(k, Eigen::EigenvaluesOnly);
    for (Eigen::Index i = 0; i < 6; ++i)
      EXPECT_LT(std::abs(solver.eigenvalues()(i)), 1e-12 * solver.eigenvalues()(11));
    for (Eigen::Index i = 6; i < 12; ++i) EXPECT_GT(solver.eigenvalues()(i), 1e-7 * solver.eigenvalues()(11));
  }
}

TEST(FibreStiffness, of_fibres_as_soft_as_the_rest_is_that_without) {
  Random random(19);
  for (int round = 0; round < 20; ++round) {
    const Corners corners = random_corners(random);
    ElasticMaterial material = any_fibres(random);
    material.young_along = material.young;
    material.shear_along = material.young / (2.0 * (1.0 + material.poisson));
    const auto with = element_stiffness(corners, material),
               without = element_stiffness(corners, {material.young, material.poisson});
    EXPECT_LT((with - without).cwiseAbs().maxCoeff(), 1e-13 * without.cwiseAbs().maxCoeff());
  }
}

TEST(FibreStiffness, refuses_what_no_material_is) {
  ElasticMaterials materials;
  const auto refused = [&](const ElasticMaterial& material) { EXPECT_THROW(materials.set(1, material), InputError); };
  refused({0.2, 0.3, Vec3::UnitZ(), 0.0, 0.1});
  refused({0.2, 0.3, Vec3::UnitZ(), 10.0, -1.0});
  refused({0.2, 0.45, Vec3::UnitZ(), 0.1, 0.1});
  refused({0.2, 0.3, Vec3(0.0, 0.0, 2.0), 10.0, 0.1});
  EXPECT_NO_THROW(materials.set(1, {0.2, 0.3, Vec3::UnitZ(), 10.0, 0.1}));
}

}  // namespace
}  // namespace bodkin
