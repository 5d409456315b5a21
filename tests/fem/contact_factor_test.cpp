#include "fem/contact_factor.h"

#include <vector>

#include "tests/fem/dense_body.h"
#include "tests/sanitized.h"
#include "tests/simulation/real_time_guard.h"
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

const CondensedBody& lattice() {
  static const CondensedBody body = checks::kelvin_body(5, sanitized ? 8 : 20, 2.0);
  return body;
}

// The constraints beside the factor, solved from scratch by Eigen.
struct PlainConstraint {
  std::uint32_t node;
  ConstraintDirections directions;
  double own_compliance;
};

struct FactorBench {
  explicit FactorBench(const Eigen::MatrixXd& body_compliance, std::size_t most)
      : compliance(body_compliance), factor(body_compliance, most) {}

  bool append(std::uint32_t node, const ConstraintDirections& directions, double own_compliance = 0.0) {
    if (!factor.append(node, directions, own_compliance)) return false;
    plain.push_back({node, directions, own_compliance});
    return true;
  }
  void remove(std::size_t index) {
    factor.remove(index);
    plain.erase(plain.begin() + static_cast<std::ptrdiff_t>(index));
  }
  Eigen::MatrixXd matrix() const {
    const auto rows = static_cast<Eigen::Index>(factor.rows());
    Eigen::MatrixXd held(rows, rows);
    Eigen::Index row = 0;
    for (const PlainConstraint& a : plain) {
      Eigen::Index column = 0;
      for (const PlainConstraint& b : plain) {
        held.block(row, column, a.directions.cols(), b.directions.cols()) =
            a.directions.transpose() * compliance.block<3, 3>(3 * a.node, 3 * b.node) * b.directions;
        if (&a == &b) {
          for (Eigen::Index i = 0; i < a.directions.cols(); ++i) held(row + i, row + i) += a.own_compliance;
        }
        column += b.directions.cols();
      }
      row += a.directions.cols();
    }
    return held;
  }
  // |f - f_Eigen| / |f_Eigen| for displacements at random.
  double error(Random& random) {
    std::vector<double> values(factor.rows());
    for (double& value : values) value = random.normal();
    const Eigen::VectorXd displacement =
        Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
    const Eigen::VectorXd expected = matrix().ldlt().solve(displacement);
    factor.solve(values);
    return (Eigen::Map<const Eigen::VectorXd>(values.data(), expected.size()) - expected).norm() / expected.norm();
  }

  const Eigen::MatrixXd& compliance;
  ContactFactor factor;
  std::vector<PlainConstraint> plain;
};

ConstraintDirections some_directions(Random& random) {
  const Mat3 frame = checks::random_frame(random);
  return frame.leftCols(1 + static_cast<int>(random.next() % 3));
}

std::uint32_t some_node(Random& random) {
  return static_cast<std::uint32_t>(random.next() % lattice().nodes.size());
}

TEST(ContactFactor, agrees_with_a_dense_solve_for_one_to_150_nodes) {
  Random random(1);
  const std::size_t most = sanitized ? 60 : 150;
  FactorBench bench(lattice().compliance, 160);
  double worst = 0.0;
  while (bench.factor.constraints() < most) {
    if (!bench.append(some_node(random), Mat3::Identity())) continue;
    worst = std::max(worst, bench.error(random));
  }
  EXPECT_LT(worst, 1e-10);
  RecordProperty("worst", std::to_string(worst));
}

TEST(ContactFactor, agrees_with_a_dense_solve_for_sticking_sliding_and_soft_constraints_in_any_directions) {
  Random random(2);
  FactorBench bench(lattice().compliance, sanitized ? 30 : 100);
  while (bench.append(some_node(random), some_directions(random), random.uniform() < 0.5 ? 0.0 : random.uniform())) {
  }
  EXPECT_GT(bench.factor.constraints(), 25u);
  for (int trial = 0; trial < 20; ++trial) EXPECT_LT(bench.error(random), 1e-10);
}

TEST(ContactFactor, one_node_gives_the_inverse_of_its_own_compliance) {
  ContactFactor factor(lattice().compliance, 2);
  ASSERT_TRUE(factor.append(7, Mat3::Identity()));
  std::vector<double> values = {0.3, -0.2, 0.5};
  const Vec3 expected = lattice().compliance.block<3, 3>(21, 21).inverse() * Vec3(0.3, -0.2, 0.5);
  factor.solve(values);
  EXPECT_LT((Vec3(values[0], values[1], values[2]) - expected).norm(), 1e-14 * expected.norm());
}

TEST(ContactFactor, constraints_leave_in_any_order) {
  Random random(3);
  for (int trial = 0; trial < 10; ++trial) {
    FactorBench bench(lattice().compliance, 40);
    while (bench.factor.constraints() < 40 && bench.factor.rows() + 3 <= bench.factor.most_rows()) {
      bench.append(some_node(random), some_directions(random));
    }
    double worst = 0.0;
    while (bench.factor.constraints() > 0) {
      worst = std::max(worst, bench.error(random));
      bench.remove(random.next() % bench.factor.constraints());
    }
    EXPECT_LT(worst, 1e-10);
    EXPECT_EQ(bench.factor.rows(), 0u);
  }
}

TEST(ContactFactor, the_last_constraint_is_cut_off_and_softened_without_touching_the_rest) {
  Random random(4);
  FactorBench bench(lattice().compliance, 30);
  while (bench.factor.constraints() < 20) bench.append(some_node(random), some_directions(random));
  bench.factor.remove_last();
  bench.plain.pop_back();
  EXPECT_LT(bench.error(random), 1e-12);
  for (const double own_compliance : {1e6, 3.0, 1e-3, 0.0, 40.0}) {
    ASSERT_TRUE(bench.factor.set_last_compliance(own_compliance));
    bench.plain.back().own_compliance = own_compliance;
    EXPECT_LT(bench.error(random), 1e-10) << own_compliance;
  }
  EXPECT_FALSE(bench.factor.set_last_compliance(-1.0));
}

TEST(ContactFactor, no_drift_after_100000_contact_changes) {
  Random random(5);
  FactorBench bench(lattice().compliance, 40);
  const int changes = sanitized ? 3000 : 100000;
  for (int change = 0; change < changes; ++change) {
    const std::size_t held = bench.factor.constraints();
    const bool grow = held == 0 || (held < 30 && random.uniform() < 0.5);
    if (grow) {
      bench.append(some_node(random), some_directions(random), random.uniform() < 0.8 ? 0.0 : random.uniform());
    } else {
      bench.remove(random.next() % held);
    }
  }
  while (bench.factor.constraints() < 20) bench.append(some_node(random), some_directions(random));
  EXPECT_LT(bench.error(random), 1e-10);
}

TEST(ContactFactor, what_is_held_already_is_refused_and_changes_nothing) {
  Random random(6);
  FactorBench bench(lattice().compliance, 10);
  ASSERT_TRUE(bench.append(3, Mat3::Identity()));
  ASSERT_TRUE(bench.append(9, Mat3::Identity().leftCols(2)));
  EXPECT_FALSE(bench.append(3, Mat3::Identity()));
  EXPECT_FALSE(bench.append(3, checks::random_frame(random).leftCols(1)));
  EXPECT_FALSE(bench.append(9, checks::random_frame(random)));
  EXPECT_EQ(bench.factor.rows(), 5u);
  EXPECT_LT(bench.error(random), 1e-12);
  EXPECT_TRUE(bench.append(9, Mat3::Identity().rightCols(1)));  // the direction that was free
  EXPECT_TRUE(bench.append(3, Mat3::Identity(), 0.1));          // twice, but the second gives way
  EXPECT_LT(bench.error(random), 1e-10);
}

TEST(ContactFactor, refuses_what_does_not_fit_and_nodes_that_are_not_there) {
  ContactFactor factor(lattice().compliance, 1);
  EXPECT_FALSE(factor.append(static_cast<std::uint32_t>(lattice().nodes.size()), Mat3::Identity()));
  EXPECT_FALSE(factor.append(0xffffffffu, Mat3::Identity()));
  EXPECT_FALSE(factor.append(0, ConstraintDirections(3, 0)));
  EXPECT_TRUE(factor.append(0, Mat3::Identity().leftCols(2)));
  EXPECT_FALSE(factor.append(1, Mat3::Identity().leftCols(2)));
  EXPECT_TRUE(factor.append(1, Mat3::Identity().leftCols(1)));
  factor.remove(5);
  EXPECT_EQ(factor.rows(), 3u);
}

TEST(ContactFactor, numbers_that_are_none_do_not_stay_behind) {
  Eigen::MatrixXd compliance = lattice().compliance.topLeftCorner(12, 12);
  compliance.block<3, 3>(0, 9).setConstant(std::nan(""));
  ContactFactor factor(compliance, 8);
  ASSERT_TRUE(factor.append(0, Mat3::Identity()));
  EXPECT_FALSE(factor.append(3, Mat3::Identity()));
  std::vector<double> values = {1.0, 1.0, 1.0};
  factor.solve(values);
  EXPECT_TRUE(std::isfinite(values[0] + values[1] + values[2]));
}

TEST(ContactFactor, a_copy_is_as_good_as_the_original) {
  Random random(7);
  FactorBench bench(lattice().compliance, 20);
  while (bench.factor.constraints() < 15) bench.append(some_node(random), some_directions(random));
  ContactFactor other(lattice().compliance, 20);
  ASSERT_TRUE(other.append(1, Mat3::Identity()));
  other.copy(bench.factor);
  std::vector<double> values(bench.factor.rows(), 0.7), same = values;
  bench.factor.solve(values);
  other.solve(same);
  EXPECT_EQ(values, same);
}

TEST(ContactFactor, refuses_a_compliance_that_is_none) {
  EXPECT_THROW(ContactFactor(Eigen::MatrixXd(3, 6), 1), InputError);
  EXPECT_THROW(ContactFactor(Eigen::MatrixXd(4, 4), 1), InputError);
  EXPECT_THROW(ContactFactor(Eigen::MatrixXd(0, 0), 1), InputError);
  EXPECT_THROW(ContactFactor(Eigen::MatrixXd::Identity(3, 3), 0), InputError);
}

TEST(ContactFactor, takes_no_memory_and_no_lock) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer watches the heap";
  Random random(8);
  ContactFactor factor(lattice().compliance, 50), other(lattice().compliance, 50);
  std::vector<double> values(150, 1.0);
  const RealTimeGuard guard;
  for (int i = 0; i < 40; ++i) factor.append(some_node(random), Mat3::Identity());
  factor.solve(values);
  factor.remove(3);
  factor.set_last_compliance(0.5);
  factor.remove_last();
  other.copy(factor);
  other.solve(values);
  EXPECT_EQ(RealTimeGuard::heap_calls(), 0u);
  EXPECT_EQ(RealTimeGuard::lock_calls(), 0u);
}

}  // namespace
}  // namespace bodkin
