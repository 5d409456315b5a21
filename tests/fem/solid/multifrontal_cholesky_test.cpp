// The factorisation against independent programs: Eigen's simplicial and CHOLMOD's supernodal Cholesky.
#include "fem/solid/multifrontal_cholesky.h"

#include "tests/fem/lattice_body.h"
#include "tests/sanitized.h"
#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <cholmod.h>
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
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

Eigen::MatrixXd dense_of(const Sparse& lower) {
  return Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
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

constexpr std::uint32_t factor_lattice = sanitized ? 6 : 11;

TEST(MultifrontalCholesky, solves_what_eigen_solves) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const BodyDescription body = lattice_body(factor_lattice, 60.0, 0.1, 40, seed);
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
    const BodyDescription body = lattice_body(factor_lattice, 60.0, 0.1, 20 * seed, seed);
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

// CHOLMOD's supernodal factorisation, which is GPL and therefore only used here.
Eigen::VectorXd solved_by_cholmod(const Sparse& lower, const Eigen::VectorXd& forces) {
  cholmod_common common;
  cholmod_start(&common);
  common.supernodal = CHOLMOD_SUPERNODAL;
  Sparse matrix = lower;
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(matrix.rows());
  view.nzmax = static_cast<std::size_t>(matrix.nonZeros());
  view.p = matrix.outerIndexPtr();
  view.i = matrix.innerIndexPtr();
  view.x = matrix.valuePtr();
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  Eigen::VectorXd right = forces;
  cholmod_dense b{};
  b.nrow = b.d = b.nzmax = view.nrow;
  b.ncol = 1;
  b.x = right.data();
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  cholmod_factor* factor = cholmod_analyze(&view, &common);
  cholmod_factorize(&view, factor, &common);
  cholmod_dense* x = cholmod_solve(CHOLMOD_A, factor, &b, &common);
  const Eigen::VectorXd solution = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(x->x), forces.size());
  cholmod_free_dense(&x, &common);
  cholmod_free_factor(&factor, &common);
  cholmod_finish(&common);
  return solution;
}

TEST(MultifrontalCholesky, solves_what_cholmod_solves) {
  const BodyDescription body = lattice_body(sanitized ? 8 : 16, 60.0, 0.1, 200);
  const BodyPlan plan = plan_body(body);
  const MultifrontalCholesky factor(plan.system.stiffness, plan.symbolic);
  const Sparse lower = lower_of(plan.system.stiffness);
  const Eigen::VectorXd forces = random_matrix(lower.rows(), 1, 1);
  EXPECT_LT(largest_difference(factor.solve(forces), solved_by_cholmod(lower, forces)), 1e-12);
}

TEST(MultifrontalCholesky, forces_on_the_last_nodes_move_everything_as_in_a_full_solve) {
  const BodyDescription body = lattice_body(factor_lattice, 60.0, 0.1, 50);
  const BodyPlan plan = plan_body(body);
  const MultifrontalCholesky factor(plan.system.stiffness, plan.symbolic);
  const Eigen::MatrixXd on_last = random_matrix(150, 4, 9);
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(3 * Eigen::Index{plan.system.stiffness.nodes}, 4);
  for (Eigen::Index i = 0; i < 50; ++i)
    forces.middleRows<3>(
        3 * Eigen::Index{plan.system.free_nodes[plan.corridor.mesh_nodes[static_cast<std::size_t>(i)]]}) =
        on_last.middleRows<3>(3 * i);
  const Eigen::MatrixXd moved = factor.solve(forces);
  EXPECT_LT(largest_difference(factor.respond(on_last), moved), 1e-14);
  EXPECT_LT(largest_difference(factor.respond(on_last.col(2)), moved.col(2)), 1e-13);
}

TEST(MultifrontalCholesky, gives_the_same_bits_again_and_without_the_field) {
  const BodyDescription body = lattice_body(factor_lattice, 60.0, 0.1, 100);
  const BodyPlan plan = plan_body(body), again = plan_body(body);
  EXPECT_EQ(plan.symbolic.order, again.symbolic.order);
  const MultifrontalCholesky first(plan.system.stiffness, plan.symbolic);
  const MultifrontalCholesky second(again.system.stiffness, again.symbolic);
  const MultifrontalCholesky lean(plan.system.stiffness, plan.symbolic, {.keep_field = false});
  const Eigen::MatrixXd compliance = first.last_compliance();
  EXPECT_EQ(compliance, second.last_compliance());
  EXPECT_EQ(compliance, lean.last_compliance());
  EXPECT_LT(plan.symbolic.bytes(false), plan.symbolic.bytes(true));
  EXPECT_THROW(lean.solve(Eigen::VectorXd::Zero(3)), std::logic_error);
  const MultifrontalCholesky two(plan.system.stiffness, plan.symbolic, {.threads = 2});
  EXPECT_LT(largest_difference(two.last_compliance(), compliance), 1e-12);
}

TEST(MultifrontalCholesky, works_without_a_corridor_with_nothing_else_and_for_one_node) {
  BodyDescription body = lattice_body(4, 30.0, 0.1, 1000);
  const BodyPlan all = plan_body(body);
  EXPECT_EQ(all.corridor.nodes.size(), 48U);  // whatever is free
  const Sparse lower = lower_of(all.system.stiffness);
  const Eigen::MatrixXd inverse = dense_of(lower).inverse();
  const MultifrontalCholesky only_last(all.system.stiffness, all.symbolic);
  Eigen::MatrixXd expected(144, 144);
  for (Eigen::Index i = 0; i < 48; ++i)
    for (Eigen::Index j = 0; j < 48; ++j)
      expected.block<3, 3>(3 * i, 3 * j) = inverse.block<3, 3>(
          3 * Eigen::Index{all.system.free_nodes[all.corridor.mesh_nodes[static_cast<std::size_t>(i)]]},
          3 * Eigen::Index{all.system.free_nodes[all.corridor.mesh_nodes[static_cast<std::size_t>(j)]]});
  EXPECT_LT(largest_difference(only_last.last_compliance(), expected), 1e-12);

  const MultifrontalCholesky none(all.system.stiffness, analyse(graph_of(all.system.stiffness), {}));
  EXPECT_EQ(none.last_compliance().size(), 0);
  const Eigen::VectorXd forces = random_matrix(144, 1, 3);
  EXPECT_LT(largest_difference(none.solve(forces), inverse * forces), 1e-12);

  BlockMatrix one;
  one.nodes = 1;
  one.start = {0, 1};
  one.row = {0};
  one.block = {Mat3(Vec3(1.0, 4.0, 16.0).asDiagonal())};
  const std::uint32_t only[] = {0};
  for (const std::span<const std::uint32_t> last :
       {std::span<const std::uint32_t>(only), std::span<const std::uint32_t>()}) {
    const MultifrontalCholesky factor(one, analyse(graph_of(one), last));
    EXPECT_EQ(factor.solve(Vec3(1.0, 1.0, 1.0)), Vec3(1.0, 0.25, 0.0625));
  }
}

// Random graphs have other trees than meshes: stars, chains, several pieces.
TEST(MultifrontalCholesky, solves_on_any_graph) {
  for (std::uint64_t seed = 1; seed <= (sanitized ? 20U : 100U); ++seed) {
    Random random(seed);
    const auto nodes = static_cast<std::uint32_t>(1 + random.uniform() * 60);
    std::vector<std::vector<std::uint32_t>> columns(nodes);
    const double density = random.uniform() * 4.0 / nodes;
    const bool star = seed % 5 == 0;
    for (std::uint32_t j = 0; j < nodes; ++j)
      for (std::uint32_t i = j + 1; i < nodes; ++i)
        if (random.uniform() < density || (star && j == 0)) columns[j].push_back(i);
    BlockMatrix matrix;
    matrix.nodes = nodes;
    matrix.start = {0};
    for (std::uint32_t j = 0; j < nodes; ++j) {
      matrix.row.push_back(j);
      matrix.block.push_back(Mat3(Vec3::Constant(4.0 * nodes).asDiagonal()));
      for (const std::uint32_t i : columns[j]) {
        matrix.row.push_back(i);
        matrix.block.push_back(Mat3::NullaryExpr([&random] { return random.uniform(-1.0, 1.0); }));
      }
      matrix.start.push_back(matrix.row.size());
    }
    std::vector<std::uint32_t> last;
    for (std::uint32_t j = 0; j < nodes; ++j)
      if (random.uniform() < 0.3) last.push_back(nodes - 1 - j);
    const MultifrontalCholesky factor(matrix, analyse(graph_of(matrix), last));
    const Sparse lower = lower_of(matrix);
    const Eigen::MatrixXd forces = random_matrix(lower.rows(), 2, seed);
    const Eigen::MatrixXd dense = dense_of(lower);
    EXPECT_LT(largest_difference(factor.solve(forces), dense.llt().solve(forces)), 1e-13) << seed;
  }
}

TEST(MultifrontalCholesky, a_matrix_that_is_not_positive_definite_is_refused_by_its_node) {
  BodyDescription body = lattice_body(5, 40.0, 0.1, 10);
  ElasticSystem system = assemble(body.mesh, body.materials, body.fixed);
  BlockMatrix& matrix = system.stiffness;
  matrix.block[matrix.start[33]](1, 1) *= -1.0;
  try {
    const MultifrontalCholesky factor(matrix, analyse(graph_of(matrix), {}));
    FAIL() << "was not refused";
  } catch (const NotPositiveDefinite& failure) {
    EXPECT_LT(failure.node, matrix.nodes);
  }
}

TEST(NestedDissection, refuses_a_corridor_that_is_none) {
  const BodyDescription body = lattice_body(4, 30.0, 0.1, 1);
  const NodeGraph graph = graph_of(assemble(body.mesh, body.materials, body.fixed).stiffness);
  const std::uint32_t twice[] = {3, 5, 3}, outside[] = {graph.nodes()};
  EXPECT_THROW(nested_dissection(graph, twice), InputError);
  EXPECT_THROW(nested_dissection(graph, outside), InputError);
}

}  // namespace
}  // namespace bodkin
