#include "fem/moving/conjugate_gradients.h"

#include <cmath>
#include <limits>
#include <vector>

#include "tests/fem/lattice_body.h"
#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::fem;
namespace {

// The matrix of a box at rest, some of its nodes held, and results of the sweeps and the solver.
struct System {
  System() : body(lattice_body(5, 40.0, 0.2, 10)), matrix(body.mesh), count(matrix.nodes()) {
    CorotationalElements elements(body.mesh, body.materials);
    NodeVectors places = NodeVectors::Zero(4, size()), forces = places;
    for (Eigen::Index node = 0; node < size(); ++node)
      places.col(node).head<3>() = body.mesh.nodes[static_cast<std::size_t>(node)];
    elements.evaluate(places, forces);
    matrix.assemble(elements.turned(), 1.5, std::vector<double>(count, 0.01));
    held.assign(count, 0);
    for (std::size_t node = 0; node < count; node += 7) held[node] = 1;
    matrix.invert_diagonal(held);
  }
  Eigen::Index size() const { return static_cast<Eigen::Index>(count); }
  NodeVectors times(const NodeVectors& vector) const {
    NodeVectors product = NodeVectors::Zero(4, size());
    matrix.multiply(vector, product);
    return product;
  }
  NodeVectors random_vector(Random& random) const {
    NodeVectors vector = NodeVectors::Zero(4, size());
    for (double& value : vector.topRows<3>().reshaped()) value = random.normal();
    return vector;
  }
  // Of x = K^-1 right among the free nodes.
  NodeVectors solved(const NodeVectors& right) const {
    Eigen::MatrixXd dense(3 * size(), 3 * size());
    for (Eigen::Index column = 0; column < 3 * size(); ++column) {
      NodeVectors unit = NodeVectors::Zero(4, size());
      unit(column % 3, column / 3) = 1.0;
      dense.col(column) = times(unit).topRows<3>().reshaped();
    }
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < 3 * size(); ++i)
      if (held[static_cast<std::size_t>(i / 3)] == 0) free.push_back(i);
    const Eigen::VectorXd flat = right.topRows<3>().reshaped();
    const Eigen::VectorXd found = dense(free, free).ldlt().solve(flat(free));
    NodeVectors x = NodeVectors::Zero(4, size());
    for (std::size_t i = 0; i < free.size(); ++i) x(free[i] % 3, free[i] / 3) = found(static_cast<Eigen::Index>(i));
    return x;
  }

  BodyDescription body;
  NodeMatrix matrix;
  std::size_t count;
  std::vector<std::uint8_t> held;
};

TEST(NodeMatrix, is_symmetric_and_a_translation_meets_its_diagonal_alone) {
  const System system;
  Random random(1);
  for (int trial = 0; trial < 5; ++trial) {
    const NodeVectors a = system.random_vector(random), b = system.random_vector(random);
    const double one = a.cwiseProduct(system.times(b)).sum(), other = b.cwiseProduct(system.times(a)).sum();
    EXPECT_NEAR(one, other, 1e-12 * a.norm() * system.times(b).norm());
  }
  NodeVectors shift = NodeVectors::Zero(4, system.size());
  shift.topRows<3>().colwise() = Vec3(1.0, -2.0, 3.0);
  const NodeVectors met = system.times(shift);
  EXPECT_LT((met - 0.01 * shift).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(NodeMatrix, its_two_sweeps_are_the_transposes_of_each_other_and_tell_the_diagonal_times_what_they_find) {
  const System system;
  Random random(2);
  const SingleVectors right = system.random_vector(random).cast<float>();
  SingleVectors x = SingleVectors::Zero(4, system.size()), y = x, scaled = x, above = x;
  system.matrix.solve_lower(right, x, scaled);
  system.matrix.solve_upper(right, y, above);
  double by_lower = 0.0, by_upper = 0.0;
  for (std::size_t i = 0; i < system.count; ++i) {
    const auto node = static_cast<Eigen::Index>(i);
    if (system.held[i] != 0) {
      EXPECT_EQ(x.col(node).norm() + y.col(node).norm(), 0.0F);
      continue;
    }
    by_lower += right.col(node).dot(x.col(node));
    by_upper += right.col(node).dot(y.col(node));
    NodeVectors alone = NodeVectors::Zero(4, system.size());
    alone.col(node) = x.col(node).cast<double>();
    EXPECT_LT((system.times(alone).col(node) - scaled.col(node).cast<double>()).norm(), 1e-4);
    alone.col(node) = y.col(node).cast<double>();
    EXPECT_LT((system.times(alone).col(node) - (right - above).col(node).cast<double>()).norm(), 1e-4);
  }
  EXPECT_NEAR(by_lower, by_upper, 1e-4 * std::abs(by_lower));
}

TEST(ConjugateGradients, finds_what_a_dense_factorisation_finds_whatever_it_begins_with) {
  const System system;
  Random random(3);
  ConjugateGradients gradients(system.count);
  const NodeVectors right = system.random_vector(random), expected = system.solved(right);
  for (const double scale : {1.0, 1e-12, 1e12}) {
    NodeVectors x = NodeVectors::Zero(4, system.size());
    const int loosely = gradients.solve(system.matrix, scale * right, {1e-2, 1000}, x);
    EXPECT_LT((x - scale * expected).norm(), 0.05 * scale * expected.norm());
    EXPECT_LT(loosely, 20);
    x.setZero();
    EXPECT_LT(gradients.solve(system.matrix, scale * right, {1e-6, 1000}, x), 60);
    EXPECT_LT((x - scale * expected).norm(), 1e-5 * scale * expected.norm());
    // Again from there: the residual of single precision.
    gradients.solve(system.matrix, scale * right, {1e-5, 1000}, x);
    EXPECT_LT((x - scale * expected).norm(), 1e-8 * scale * expected.norm());
    EXPECT_LE(gradients.solve(system.matrix, scale * right, {0.5, 1000}, x), 1);
  }
}

TEST(ConjugateGradients, leaves_what_is_held_where_it_is_and_takes_it_into_account) {
  const System system;
  Random random(4);
  ConjugateGradients gradients(system.count);
  NodeVectors x = NodeVectors::Zero(4, system.size());
  for (std::size_t i = 0; i < system.count; ++i)
    if (system.held[i] != 0) x.col(static_cast<Eigen::Index>(i)).head<3>() = Vec3(random.normal(), 1.0, -1.0);
  const NodeVectors begin = x, right = system.random_vector(random);
  gradients.solve(system.matrix, right, {1e-6, 1000}, x);
  gradients.solve(system.matrix, right, {1e-6, 1000}, x);
  const NodeVectors expected = begin + system.solved(right - system.times(begin));
  EXPECT_LT((x - expected).norm(), 1e-8 * expected.norm());
  for (std::size_t i = 0; i < system.count; ++i) {
    const auto node = static_cast<Eigen::Index>(i);
    if (system.held[i] != 0) {
      EXPECT_EQ(x.col(node), begin.col(node));
    }
  }
}

TEST(ConjugateGradients, nothing_to_do_is_done_at_once_and_senseless_numbers_are_told) {
  const System system;
  ConjugateGradients gradients(system.count);
  NodeVectors x = NodeVectors::Zero(4, system.size()), right = x;
  EXPECT_EQ(gradients.solve(system.matrix, right, {1e-6, 1000}, x), 0);
  EXPECT_EQ(x.norm(), 0.0);
  for (const double senseless : {std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    x.setZero();
    right.setZero();
    right(0, 1) = right(2, 50) = senseless;
    gradients.solve(system.matrix, right, {1e-6, 1000}, x);
    EXPECT_FALSE(x.allFinite()) << senseless;
  }
  x.setZero();  // and it is not ill of it
  right.setZero();
  right(0, 1) = 1.0;
  gradients.solve(system.matrix, right, {1e-6, 1000}, x);
  EXPECT_LT((x - system.solved(right)).norm(), 1e-5 * x.norm());
}

}  // namespace
}  // namespace bodkin
