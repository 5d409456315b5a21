// The factorisation against programs that are not ours: Eigen's simplicial and CHOLMOD's supernodal Cholesky.
#include "fem/multifrontal_cholesky.h"

#include "tests/fem/lattice_body.h"
#include "tests/sanitized.h"
#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <cholmod.h>
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

Sparse lower_of(const BlockMatrix& matrix) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::uint32_t column = 0; column < matrix.nodes; ++column)
    for (std::size_t b = matrix.start[column]; b < matrix.start[column + 1]; ++b)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
          if (matrix.row[b] > column || i >= j)
            entries.emplace_back(static_cast<int>(3 * matrix.row[b]) + i, static_cast<int>(3 * column) + j,
                                 matrix.block[b](i, j));
  const auto size = static_cast<Eigen::Index>(3 * matrix.nodes);
  Sparse sparse(size, size);
  sparse.setFromTriplets(entries.begin(), entries.end());
  return sparse;
}

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, std::uint64_t seed) {
  Random random(seed);
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&random] { return random.normal(); });
}

double largest_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

// The columns of the inverse at the free nodes `nodes`, as Eigen solves them.
Eigen::MatrixXd compliance_by_eigen(const Sparse& lower, const std::vector<std::uint32_t>& nodes) {
  const Eigen::SimplicialLLT<Sparse> factor(lower);
  const auto count = static_cast<Eigen::Index>(nodes.size());
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(lower.rows(), 3 * count);
  for (Eigen::Index i = 0; i < 3 * count; ++i)
    unit(3 * Eigen::Index{nodes[static_cast<std::size_t>(i / 3)]} + i % 3, i) = 1.0;
  const Eigen::MatrixXd columns = factor.solve(unit);
  Eigen::MatrixXd compliance(3 * count, 3 * count);
  for (Eigen::Index i = 0; i < count; ++i)
    compliance.middleRows<3>(3 * i) = columns.middleRows<3>(3 * Eigen::Index{nodes[static_cast<std::size_t>(i)]});
  return compliance;
}

constexpr std::uint32_t lattice = sanitized ? 6 : 11;

TEST(MultifrontalCholesky, solves_what_eigen_solves) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const BodyDescription body = lattice_body(lattice, 60.0, 0.1, 40, seed);
    const BodyPlan plan = plan_body(body);
    const MultifrontalCholesky factor(plan.system.stiffness, plan.symbolic);
    const Sparse lower = lower_of(plan.system.stiffness);
    const Eigen::MatrixXd forces = random_matrix(lower.rows(), 3, seed);
    const Eigen::MatrixXd expected = Eigen::SimplicialLLT<Sparse>(lower).solve(forces);
    EXPECT_LT(largest_difference(factor.solve(forces), expected), 1e-12);
    EXPECT_LT(largest_difference(factor.solve(forces.col(1)), expected.col(1)), 1e-12);
  }
}

TEST(MultifrontalCholesky, condenses_to_what_full_solves_give) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const BodyDescription body = lattice_body(lattice, 60.0, 0.1, 20 * seed, seed);
    const CondensedBody condensed = condense(body);
    const ElasticSystem system = assemble(body.mesh, body.materials, body.fixed);
    std::vector<std::uint32_t> nodes;
    for (const std::uint32_t node : condensed.mesh_nodes) nodes.push_back(system.free_nodes[node]);
    EXPECT_EQ(condensed.mesh_nodes, body.corridor);
    EXPECT_LT(largest_difference(condensed.compliance, compliance_by_eigen(lower_of(system.stiffness), nodes)),
              1e-12);
    EXPECT_EQ(condensed.compliance, condensed.compliance.transpose());
  }
}

}  // namespace
}  // namespace bodkin
