#include "fem/growing_field.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <new>
#include <numeric>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::fem;
namespace {

constexpr std::size_t all_nodes = 12;

// mm/N between as many nodes, each a point.
Eigen::MatrixXf compliance() {
  Random random(3);
  Eigen::MatrixXd root(3 * all_nodes, 3 * all_nodes);
  for (double& value : root.reshaped()) value = random.normal();
  return (0.1 * root * root.transpose() + Eigen::MatrixXd::Identity(root.rows(), root.rows())).cast<float>();
}

DisplayField field_of(const Eigen::MatrixXf& between, const std::vector<std::uint32_t>& known, std::size_t spare) {
  DisplayField field(all_nodes, known, all_nodes, spare);
  for (std::size_t i = 0; i < known.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::VectorXf column = between.col(static_cast<Eigen::Index>(3 * known[i] + c));
      field.set_column(3 * i + c, {column.data(), 3 * all_nodes});
    }
  return field;
}

GrowingField::Columns columns_of(const Eigen::MatrixXf& between) {
  return [between](std::span<const std::uint32_t> nodes) {
    Eigen::MatrixXf found(between.rows(), static_cast<Eigen::Index>(3 * nodes.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i)
      found.middleCols<3>(static_cast<Eigen::Index>(3 * i)) =
          between.middleCols<3>(3 * static_cast<Eigen::Index>(nodes[i]));
    return found;
  };
}

NodeForces forces_on(const std::vector<std::uint32_t>& nodes) {
  NodeForces forces;
  for (const std::uint32_t node : nodes)
    forces.nodes[forces.count++] = {node, {1.0F + static_cast<float>(node), -0.5F, 2.0F}};
  return forces;
}

Eigen::VectorXd moved_by(const Eigen::MatrixXf& between, const NodeForces& forces) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(between.cols());
  for (std::size_t i = 0; i < forces.count; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      load(static_cast<Eigen::Index>(3 * forces.nodes[i].node + c)) += static_cast<double>(forces.nodes[i].force[c]);
  return between.cast<double>() * load;
}

// Waits until `holds`, a minute at most.
bool comes_true(const std::function<bool()>& holds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

double difference(const std::vector<float>& found, const Eigen::VectorXd& expected) {
  return (Eigen::Map<const Eigen::VectorXf>(found.data(), expected.size()).cast<double>() - expected).norm() /
         expected.norm();
}

TEST(GrowingField, shows_what_forces_on_any_nodes_do_once_it_has_their_columns) {
  const Eigen::MatrixXf between = compliance();
  GrowingField field(field_of(between, {0, 1}, 3), columns_of(between));
  std::vector<float> moved(3 * all_nodes);
  // The last needs an occupied place.
  for (const std::vector<std::uint32_t>& nodes :
       std::vector<std::vector<std::uint32_t>>{{0, 5, 6}, {1, 7}, {8, 9, 10}, {5}}) {
    const NodeForces forces = forces_on(nodes);
    EXPECT_GT(field.left_out(forces), 0.0) << nodes[0];
    ASSERT_TRUE(comes_true([&] {
      field.evaluate(forces, moved);
      return field.left_out(forces) == 0.0;
    })) << nodes[0];
    EXPECT_LT(difference(moved, moved_by(between, forces)), 1e-6) << nodes[0];
  }
  EXPECT_EQ(field.left_out(forces_on({0, 1})), 0.0) << "its first nodes stay";
}

TEST(GrowingField, has_no_more_nodes_than_places_and_gives_up_none_that_is_needed) {
  const Eigen::MatrixXf between = compliance();
  std::atomic<int> asked{0};
  GrowingField field(field_of(between, {0}, 2), [&](std::span<const std::uint32_t> nodes) {
    ++asked;
    return columns_of(between)(nodes);
  });
  std::vector<float> moved(3 * all_nodes);
  const NodeForces forces = forces_on({3, 4, 5});
  const double one = field.left_out(forces_on({5}));
  ASSERT_TRUE(comes_true([&] {
    field.evaluate(forces, moved);
    return field.left_out(forces) <= one + 1e-6;
  }));
  for (int round = 0; round < 20; ++round) field.evaluate(forces, moved);
  EXPECT_EQ(asked, 1) << "it asks for what it has no place for";
}

TEST(GrowingField, nodes_that_are_held_stay_where_they_are) {
  const Eigen::MatrixXf between = compliance();
  std::vector<std::uint32_t> all(all_nodes);
  std::iota(all.begin(), all.end(), 0U);
  GrowingField field(field_of(between, {0, 1}, 6), columns_of(between), all);
  field.hold(std::vector<std::uint32_t>{2, 3, 7, 99});
  const NodeForces forces = forces_on({1, 5});
  std::vector<float> moved(3 * all_nodes);
  ASSERT_TRUE(comes_true([&] {
    field.evaluate(forces, moved);
    return std::abs(moved[6]) < 1e-4F && std::abs(moved[9]) < 1e-4F;
  }));
  const Eigen::VectorXd alone = moved_by(between, forces);
  const std::vector<Eigen::Index> rows = {6, 7, 8, 9, 10, 11, 21, 22, 23};
  const Eigen::MatrixXd held = between.cast<double>()(rows, rows), of_held = between.cast<double>()(Eigen::all, rows);
  const Eigen::VectorXd expected = alone - of_held * held.llt().solve(Eigen::VectorXd(alone(rows)));
  EXPECT_LT(difference(moved, expected), 1e-4);
  EXPECT_GT((alone - expected).norm(), 0.1 * alone.norm()) << "it is to be seen";
  field.hold({});
  field.evaluate(forces, moved);
  EXPECT_LT(difference(moved, alone), 1e-6);
}

TEST(GrowingField, goes_on_with_what_it_has_where_there_is_no_memory_for_more) {
  const Eigen::MatrixXf between = compliance();
  std::atomic<int> asked{0};
  GrowingField field(field_of(between, {0}, 2), [&](std::span<const std::uint32_t>) -> Eigen::MatrixXf {
    ++asked;
    throw std::bad_alloc();
  });
  std::vector<float> moved(3 * all_nodes);
  ASSERT_TRUE(comes_true([&] {
    field.evaluate(forces_on({0, 4}), moved);
    return asked > 0;
  }));
  field.evaluate(forces_on({0, 4}), moved);
  EXPECT_LT(difference(moved, moved_by(between, forces_on({0}))), 1e-6);
}

}  // namespace
}  // namespace bodkin
