#include "fem/moving/corotational_tangent.h"

#include "tests/fem/lattice_body.h"
#include "tests/fem/moving/rest.h"
#include "tests/sanitized.h"
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "fem/moving/corotational_body.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

Eigen::MatrixXd dense_of(const BlockMatrix& matrix) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * matrix.nodes, 3 * matrix.nodes);
  for (std::uint32_t column = 0; column < matrix.nodes; ++column) {
    for (std::size_t at = matrix.start[column]; at < matrix.start[column + 1]; ++at) {
      dense.block<3, 3>(3 * matrix.row[at], 3 * column) = matrix.block[at];
      dense.block<3, 3>(3 * column, 3 * matrix.row[at]) = matrix.block[at].transpose();
    }
  }
  return dense;
}

TEST(CorotationalTangent, at_rest_it_is_the_stiffness_of_the_linear_body) {
  const BodyDescription body = lattice_body(4, 40.0, 0.1, 10);
  BodyPlan plan = plan_body(body);
  const Eigen::MatrixXd linear = dense_of(plan.system.stiffness);
  CorotationalBody moving(body, checks::to_rest());
  assemble_tangent(body, moving.places(), {}, StressStiffness::exact, plan.system);
  EXPECT_LT((dense_of(plan.system.stiffness) - linear).cwiseAbs().maxCoeff(), 1e-13 * linear.maxCoeff());
}

TEST(CorotationalTangent, is_the_derivative_of_the_forces_in_any_state_without_inverted_elements) {
  const BodyDescription body = lattice_body(4, 30.0, 0.1, 10);
  BodyPlan plan = plan_body(body);
  CorotationalElements elements(body.mesh, body.materials);
  Random random(1);
  const auto count = static_cast<Eigen::Index>(body.mesh.nodes.size());
  const Mat3 turn = Eigen::AngleAxisd(2.0, Vec3(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  NodeVectors places = NodeVectors::Zero(4, count), forces = places, back = places;
  for (Eigen::Index node = 0; node < count; ++node)
    places.col(node).head<3>() =
        turn * (body.mesh.nodes[static_cast<std::size_t>(node)] + Vec3(random.normal(), random.normal(), 0.0));
  assemble_tangent(body, places, {}, StressStiffness::exact, plan.system);
  const Eigen::MatrixXd exact = dense_of(plan.system.stiffness);
  const auto free = static_cast<Eigen::Index>(plan.system.mesh_nodes.size());
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::VectorXd way = Eigen::VectorXd::NullaryExpr(3 * free, [&random] { return random.normal(); });
    NodeVectors moved = NodeVectors::Zero(4, count);
    for (Eigen::Index i = 0; i < free; ++i)
      moved.col(plan.system.mesh_nodes[static_cast<std::size_t>(i)]).head<3>() = way.segment<3>(3 * i);
    constexpr double h = 1e-5;
    elements.evaluate(places + h * moved, forces);
    elements.evaluate(places - h * moved, back);
    Eigen::VectorXd resists(3 * free);
    for (Eigen::Index i = 0; i < free; ++i) {
      const auto node = plan.system.mesh_nodes[static_cast<std::size_t>(i)];
      resists.segment<3>(3 * i) = (back - forces).col(node).head<3>() / (2.0 * h);
    }
    EXPECT_LT((exact * way - resists).norm(), 1e-7 * resists.norm());
  }
  assemble_tangent(body, places, {}, StressStiffness::positive, plan.system);
  const Eigen::MatrixXd positive = dense_of(plan.system.stiffness);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(positive).eigenvalues()(0), 0.0);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(positive - exact).eigenvalues()(0), -1e-12);
}

// Of a body that is pressed far in, small forces move the corridor as the condensed tangent says.
TEST(CorotationalTangent, its_compliance_is_that_of_the_body_at_rest_under_a_press) {
  const BodyDescription body = lattice_body(sanitized ? 5 : 6, 40.0, 0.1, 12);
  CorotationalSettings settings = checks::to_rest();
  settings.gradients.tolerance = 1e-4;
  CorotationalBody moving(body, settings);
  for (std::uint32_t node = 0; node < moving.nodes(); ++node) {
    const Vec3& x = body.mesh.nodes[node];
    if (x.z() > 39.0 && x.x() < 17.0) moving.hold(node, x - Vec3(1.0, 0.0, 9.0));
  }
  ASSERT_LE(checks::settle(moving, 1e-12, 150), 150);
  BodyPlan plan = plan_body(body);
  assemble_tangent(body, moving.places(), moving.all_held(), StressStiffness::exact, plan.system);
  const MultifrontalCholesky factor(plan.system.stiffness, plan.symbolic, {.threads = 1, .keep_field = false});
  const Eigen::MatrixXd compliance = factor.last_compliance();
  const double stiffer = (compliance - condense(body).compliance).norm() / compliance.norm();
  EXPECT_GT(stiffer, 0.1);  // the press matters
  const auto& corridor = plan.corridor.mesh_nodes;
  int pressed = 0;
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(corridor.size()); ++i) {
    const std::uint32_t node = corridor[static_cast<std::size_t>(i)];
    if (moving.held(node)) {
      ++pressed;
      EXPECT_LT(compliance.col(3 * i).norm(), 1e-2 * compliance.norm());
      continue;
    }
    if (i % 4 != 0) continue;
    const Vec3 way = Vec3(0.6, 0.0, -0.8);
    constexpr double force = 1e-4;
    const NodeVectors start = moving.places();
    moving.load(node, force * way);
    ASSERT_LE(checks::settle(moving, 1e-12, 150), 150);
    const NodeVectors there = moving.places();
    moving.load(node, -2.0 * force * way);
    ASSERT_LE(checks::settle(moving, 1e-12, 150), 150);
    const NodeVectors back = moving.places();
    moving.clear_loads();
    ASSERT_LE(checks::settle(moving, 1e-12, 150), 150);
    const Eigen::VectorXd expected = compliance.middleCols<3>(3 * i) * way;
    double error = 0.0;
    for (Eigen::Index j = 0; j < static_cast<Eigen::Index>(corridor.size()); ++j) {
      const Vec3 moved = (there - back).col(corridor[static_cast<std::size_t>(j)]).head<3>() / (2.0 * force);
      if (moving.held(corridor[static_cast<std::size_t>(j)])) continue;
      error = std::max(error, (moved - expected.segment<3>(3 * j)).norm());
    }
    EXPECT_LT(error, 1e-5 * expected.norm());
  }
  EXPECT_GT(pressed, 0);
}

}  // namespace
}  // namespace bodkin
