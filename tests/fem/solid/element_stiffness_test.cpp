#include "fem/solid/element_stiffness.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

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
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 12, 12>> solver(k, Eigen::EigenvaluesOnly);
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

}  // namespace
}  // namespace bodkin
