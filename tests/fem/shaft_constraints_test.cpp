#include "fem/shaft_constraints.h"

#include <vector>

#include "tests/fem/dense_body.h"
#include "tests/sanitized.h"
#include "tests/simulation/real_time_guard.h"
#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

const CondensedBody& flesh_of_shafts() {
  static const CondensedBody body = checks::kelvin_body(3, sanitized ? 12 : 60, 1.0);
  return body;
}

// Constraints against a dense solve of all equations at once.
struct ShaftAndDense {
  explicit ShaftAndDense(std::size_t room, std::uint64_t seed)
      : random(seed), frame(checks::random_frame(random)), shaft(flesh_of_shafts().compliance, room) {
    for (std::uint32_t i = 0; i < flesh_of_shafts().nodes.size(); ++i) free.push_back(i);
    shaft.begin(frame);
  }

  std::uint32_t any_node() {
    const std::size_t at = random.next() % free.size();
    const std::uint32_t node = free[at];
    free.erase(free.begin() + static_cast<std::ptrdiff_t>(at));
    return node;
  }
  // The next node becomes one of the needle's, and another is before the tip.
  bool advance() {
    if (nodes.empty()) {
      nodes.push_back(any_node());
      if (!shaft.add_before_tip(nodes.back())) return false;
    }
    if (!shaft.push(nodes.back(), 0.0)) return false;
    nodes.push_back(any_node());
    own_compliance = random.uniform() < 0.3 ? -1.0 : random.uniform() < 0.5 ? 0.0 : random.uniform(0.0, 30.0);
    if (own_compliance >= 0.0 && !shaft.constrain_last_across(own_compliance)) return false;
    return shaft.add_before_tip(nodes.back());
  }
  void draw_back() {
    shaft.pop();
    free.push_back(nodes.back());
    nodes.pop_back();
    own_compliance = shaft.size() > 0 ? 0.0 : -1.0;
  }

  // The largest relative difference of forces and of the sliding displacements.
  double worst_difference() {
    const std::size_t known = shaft.known();
    std::vector<double> displacements(3 * known), forces(3 * known, 0.0);
    for (double& displacement : displacements) displacement = random.normal();
    Eigen::VectorXd load = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(known));
    std::vector<Eigen::Index> held;
    for (std::size_t i = 0; i < known; ++i) {
      const auto at = 3 * static_cast<Eigen::Index>(i);
      if (shaft.constrained_along(i)) {
        held.push_back(at);
      } else {
        load(at) = forces[3 * i] = random.uniform() < 0.3 ? 0.0 : 0.1 * random.normal();
      }
      if (i + 1 < shaft.size() || (i + 1 == shaft.size() && own_compliance >= 0.0)) {
        held.push_back(at + 1);
        held.push_back(at + 2);
      }
    }
    Eigen::MatrixXd compliance(load.size(), load.size());
    for (std::size_t i = 0; i < known; ++i) {
      for (std::size_t j = 0; j < known; ++j) {
        compliance.block<3, 3>(3 * static_cast<Eigen::Index>(i), 3 * static_cast<Eigen::Index>(j)) =
            frame.transpose() * flesh_of_shafts().compliance.block<3, 3>(3 * nodes[i], 3 * nodes[j]) * frame;
      }
    }
    Eigen::MatrixXd matrix = compliance(held, held);
    for (std::size_t row = 0; row < held.size(); ++row) {
      const auto node = static_cast<std::size_t>(held[row] / 3);
      const auto place = static_cast<Eigen::Index>(row);
      if (node + 1 == shaft.size() && held[row] % 3 != 0) matrix(place, place) += own_compliance;
    }
    const Eigen::VectorXd wanted = Eigen::Map<const Eigen::VectorXd>(displacements.data(), load.size());
    const Eigen::VectorXd by_load = compliance * load;
    Eigen::VectorXd expected = load;
    if (!held.empty()) {
      const Eigen::VectorXd right = wanted(held) - by_load(held);
      const Eigen::VectorXd solved = matrix.ldlt().solve(right);
      expected(held) = solved;
    }
    const Eigen::VectorXd moved = compliance * expected;
    shaft.place(displacements);
    shaft.solve_along(forces);
    double worst = 0.0;
    for (std::size_t i = 0; i < known; ++i) {
      if (shaft.constrained_along(i)) continue;
      const double difference = shaft.moved(i) - moved(3 * static_cast<Eigen::Index>(i));
      worst = std::max(worst, std::abs(difference) / std::max(moved.norm(), 1e-3));
    }
    shaft.solve_across(forces);
    const Eigen::Map<const Eigen::VectorXd> found(forces.data(), load.size());
    return std::max(worst, (found - expected).norm() / std::max(expected.norm(), 1e-3));
  }

  Random random;
  Mat3 frame;
  ShaftConstraints shaft;
  std::vector<std::uint32_t> free, nodes;  // the last of `nodes` is before the tip
  double own_compliance = -1.0;
};

TEST(ShaftConstraints, any_of_1_to_150_nodes_agree_with_a_dense_solve) {
  const std::size_t most = sanitized ? 30 : 150;
  ShaftAndDense both(most, 1);
  double worst = 0.0;
  while (both.shaft.size() < most) {
    ASSERT_TRUE(both.advance());
    for (std::size_t i = 0; i < both.shaft.known(); ++i) {
      if (both.random.uniform() < 0.2) both.shaft.constrain_along(i);
      if (both.random.uniform() < 0.1) both.shaft.release_along(i);
    }
    if (both.random.uniform() < 0.1) both.shaft.constrain_all_along();
    worst = std::max(worst, both.worst_difference());
  }
  EXPECT_FALSE(both.shaft.push(both.nodes.back(), 0.0));  // no room
  while (both.shaft.size() > 1) {
    both.draw_back();
    if (both.random.uniform() < 0.2) both.shaft.constrain_before_tip();
    worst = std::max(worst, both.worst_difference());
  }
  EXPECT_LT(worst, 1e-10);
}

TEST(ShaftConstraints, no_drift_after_100000_changes) {
  ShaftAndDense both(40, 2);
  int changes = 0;
  const int wanted = sanitized ? 3000 : 100000;
  while (changes < wanted) {
    const double what = both.random.uniform();
    if (what < 0.2 && both.shaft.size() < 40) {
      ASSERT_TRUE(both.advance());
    } else if (what < 0.4 && both.shaft.size() > 10) {
      both.draw_back();
    } else if (what < 0.41) {
      both.shaft.constrain_all_along();
    } else if (both.shaft.known() > 0) {
      const std::size_t index = both.random.next() % both.shaft.known();
      if (what < 0.7)
        both.shaft.constrain_along(index);
      else
        both.shaft.release_along(index);
    }
    ++changes;
  }
  EXPECT_GT(both.shaft.size(), 5u);
  EXPECT_LT(both.worst_difference(), 1e-10);
}

// As with a hand at 500 mm/s: the factor follows the changes of many sticking nodes, and is seldom refactorised.
TEST(ShaftConstraints, no_drift_while_all_nodes_stick_and_come_and_go) {
  const std::size_t most = sanitized ? 40 : 90;
  ShaftAndDense both(most, 4);
  while (both.shaft.size() < most / 2) ASSERT_TRUE(both.advance());
  both.shaft.constrain_all_along();
  double worst = both.worst_difference();
  bool inwards = true;
  for (int change = 0; change < (sanitized ? 300 : 3000); ++change) {
    if (both.random.uniform() < 0.1) inwards = !inwards;
    if (inwards && both.shaft.size() < most) {
      ASSERT_TRUE(both.advance());
      both.shaft.constrain_along(both.shaft.size() - 1);
    } else if (!inwards && both.shaft.size() > 30) {
      both.draw_back();
    }
    if (both.random.uniform() < 0.3) {
      const std::size_t index = both.random.next() % both.shaft.known();
      both.shaft.release_along(index);
      both.shaft.constrain_along(index);
    }
    if (change % 100 == 0) worst = std::max(worst, both.worst_difference());
  }
  EXPECT_LT(std::max(worst, both.worst_difference()), 1e-10);
}

TEST(ShaftConstraints, drawing_back_leaves_what_was_there_before_to_the_bit) {
  ShaftAndDense both(30, 3);
  for (int i = 0; i < 15; ++i) ASSERT_TRUE(both.advance());
  both.shaft.constrain_last_across(0.0);
  both.shaft.constrain_all_along();
  const auto solution = [&both](std::size_t known) {
    std::vector<double> displacements(3 * known, 0.1), forces(3 * known, 0.0);
    both.shaft.solve(displacements, forces);
    return forces;
  };
  const std::vector<double> before = solution(both.shaft.known());
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(both.advance());
  for (int i = 0; i < 10; ++i) both.draw_back();
  both.shaft.constrain_all_along();
  EXPECT_EQ(solution(both.shaft.known()), before);
}

TEST(ShaftConstraints, what_cannot_be_is_refused) {
  ShaftConstraints shaft(flesh_of_shafts().compliance, 3);
  EXPECT_FALSE(shaft.constrain_along(0));
  EXPECT_FALSE(shaft.constrain_last_across(0.0));
  EXPECT_FALSE(shaft.add_before_tip(1000000));
  EXPECT_TRUE(shaft.add_before_tip(4));
  EXPECT_FALSE(shaft.add_before_tip(5));  // one is before the tip
  EXPECT_FALSE(shaft.push(5, 0.0));       // and it is another
  EXPECT_TRUE(shaft.push(4, 0.0));
  EXPECT_TRUE(shaft.constrain_along(0));
  EXPECT_FALSE(shaft.constrain_along(0));
  EXPECT_FALSE(shaft.constrain_last_across(-1.0));
  // The same node twice adds no information.
  EXPECT_TRUE(shaft.add_before_tip(4));
  EXPECT_FALSE(shaft.constrain_before_tip());
}

TEST(ShaftConstraints, takes_no_memory_and_no_lock) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer watches the heap";
  ShaftConstraints shaft(flesh_of_shafts().compliance, 20);
  std::vector<double> displacements(3 * 21, 0.1), forces(3 * 21, 0.0);
  const RealTimeGuard guard;
  for (int round = 0; round < 3; ++round) {
    for (std::uint32_t i = 0; i < 20; ++i) {
      shaft.push(i, 0.5 * i);
      shaft.constrain_last_across(0.5);
      shaft.constrain_along(i);
      shaft.solve(displacements, forces);
    }
    shaft.constrain_all_along();
    shaft.release_along(7);
    shaft.solve(displacements, forces);
    for (int i = 0; i < 20; ++i) shaft.pop();
  }
  EXPECT_EQ(RealTimeGuard::heap_calls(), 0u);
  EXPECT_EQ(RealTimeGuard::lock_calls(), 0u);
}

}  // namespace
}  // namespace bodkin
