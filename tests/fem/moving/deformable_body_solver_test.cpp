#include "fem/moving/deformable_body_solver.h"

#include <cmath>

#include "tests/fem/lattice_body.h"
#include "tests/simulation/real_time_guard.h"
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

// A box of 40 mm held at its bottom with nodes every 5 mm.
const BodyDescription& even_box() {
  static const BodyDescription body = [] {
    BodyDescription box = lattice_body(9, 40.0, 0.0, 20);
    box.materials.set(tissue::ligamentum_flavum, {0.020, 0.3});
    return box;
  }();
  return body;
}

Pose probe_at_side(double depth) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(180.0 * degree, Vec3::UnitX()).toRotationMatrix();
  pose.translation() = Vec3(8.0, 20.0, 40.0 - depth);
  return pose;
}

// A press of a hundredth of an edge agrees with linear elasticity for the same moved nodes.
TEST(DeformableBodySolver, a_slight_press_moves_the_body_as_linear_elasticity_says) {
  BodySolverSettings settings;
  settings.motion.dt = 0.0;
  settings.motion.gradients.tolerance = 1e-6;
  settings.probe.width = 14.0;
  settings.probe.thickness = 31.0;
  DeformableBodySolver pressed(even_box(), settings);
  for (int step = 0; step < 40; ++step) pressed.step(probe_at_side(0.05));
  const CorotationalBody& body = pressed.body();
  BodyDescription held = even_box();
  std::vector<std::uint32_t> under;
  for (std::uint32_t node = 0; node < body.nodes(); ++node)
    if (body.held(node)) under.push_back(node);
  ASSERT_GT(under.size(), 4U);
  held.corridor = under;
  // Forces that move the held nodes as the probe does; what they do to a node far below is compared.
  std::uint32_t far = 0;
  for (std::uint32_t node = 0; node < body.nodes(); ++node)
    if ((held.mesh.nodes[node] - Vec3(20.0, 20.0, 20.0)).norm() < 1e-6) far = node;
  held.corridor.push_back(far);
  std::sort(held.corridor.begin(), held.corridor.end());
  const CondensedBody linear = condense(held);
  std::vector<Eigen::Index> rows;
  std::vector<double> by_how_much;
  Eigen::Index row_of_far = 0;
  for (std::size_t i = 0; i < linear.nodes.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(3 * i);
    if (linear.mesh_nodes[i] == far) {
      row_of_far = row;
      continue;
    }
    const Vec3 by = body.position(linear.mesh_nodes[i]) - body.at_rest(linear.mesh_nodes[i]);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      rows.push_back(row + axis);
      by_how_much.push_back(by[axis]);
    }
  }
  // Some nodes under the probe may be fixed: they have no row.
  ASSERT_GT(rows.size(), 12U);
  const auto count = static_cast<Eigen::Index>(by_how_much.size());
  const Eigen::VectorXd moved = Eigen::Map<const Eigen::VectorXd>(by_how_much.data(), count);
  const Eigen::MatrixXd between = linear.compliance(rows, rows);
  const Eigen::VectorXd forces = between.llt().solve(moved);
  const Eigen::MatrixXd there = linear.compliance(Eigen::seqN(row_of_far, 3), rows);
  const Vec3 expected = there * forces, found = body.position(far) - body.at_rest(far);
  EXPECT_GT(expected.norm(), 0.005);
  EXPECT_LT((found - expected).norm(), 0.02 * expected.norm());
}

TEST(DeformableBodySolver, a_step_takes_no_memory_and_no_lock) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer watches the heap";
  DeformableBodySolver pressed(even_box(), BodySolverSettings{});
  const RealTimeGuard guard;
  for (int step = 0; step < 20; ++step) pressed.step(probe_at_side(0.3 * step));
  pressed.step(std::nullopt);
  EXPECT_EQ(RealTimeGuard::heap_calls(), 0U);
  EXPECT_EQ(RealTimeGuard::lock_calls(), 0U);
}

}  // namespace
}  // namespace bodkin
