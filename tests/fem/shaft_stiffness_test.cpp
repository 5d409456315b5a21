#include "fem/shaft_stiffness.h"

#include "tests/fem/dense_body.h"
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

TEST(ShaftStiffness, of_one_node_is_that_of_the_node) {
  const CondensedBody body = checks::kelvin_body(1, 1, 2.0, 0.02);
  const Mat3 stiffness = body.compliance.inverse();
  const double largest = Eigen::SelfAdjointEigenSolver<Mat3>(stiffness).eigenvalues().maxCoeff();
  EXPECT_NEAR(shaft_stiffness(body, Vec3::Zero(), Vec3::UnitZ(), 1.0, 10), largest, 1e-12 * largest);
}

TEST(ShaftStiffness, is_what_pulling_all_points_of_the_line_takes) {
  const CondensedBody body = checks::kelvin_body(1, 8, 2.0, 0.02);
  std::vector<Eigen::Index> rows;
  for (std::size_t node = 0; node < body.nodes.size(); ++node) {
    const Vec3& at = body.nodes[node];
    if (at.head<2>().norm() > 0.1 || at.z() > 10.5) continue;
    for (Eigen::Index axis = 0; axis < 3; ++axis) rows.push_back(3 * static_cast<Eigen::Index>(node) + axis);
  }
  ASSERT_EQ(rows.size(), 18U);
  const Eigen::MatrixXd inverse = Eigen::MatrixXd(body.compliance(rows, rows)).inverse();
  double stiffest = 0.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {  // the lattice is symmetric: the axes are the eigenvectors
    Eigen::VectorXd along = Eigen::VectorXd::Zero(18);
    for (Eigen::Index node = 0; node < 6; ++node) along(3 * node + axis) = 1.0;
    stiffest = std::max(stiffest, along.dot(inverse * along));
  }
  const double found = shaft_stiffness(body, Vec3::Zero(), Vec3::UnitZ(), 10.5, 100);
  EXPECT_NEAR(found, stiffest, 1e-10 * stiffest);
  EXPECT_LT(shaft_stiffness(body, Vec3::Zero(), Vec3::UnitZ(), 10.5, 2), found);
}

TEST(ShaftStiffness, without_points_there_is_none) {
  const CondensedBody body = checks::kelvin_body(1, 1, 2.0, 0.02);
  EXPECT_EQ(shaft_stiffness(body, Vec3(50.0, 0.0, 0.0), Vec3::UnitZ(), 10.0, 10), 0.0);
}

}  // namespace
}  // namespace bodkin
