#include "fem/display_field.h"

#include <atomic>
#include <thread>
#include <vector>

#include "tests/sanitized.h"
#include "tests/simulation/real_time_guard.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/latest_value.h"
#include "core/random.h"

namespace bodkin {

using namespace bodkin::fem;
namespace {

Eigen::MatrixXf random_columns(Eigen::Index points, Eigen::Index nodes, std::uint64_t seed) {
  Random random(seed);
  Eigen::MatrixXf columns(3 * points, 3 * nodes);
  for (float& value : columns.reshaped()) value = static_cast<float>(random.normal());
  return columns;
}

NodeForces random_forces(Random& random, std::size_t count, std::size_t nodes) {
  NodeForces forces;
  forces.count = count;
  for (std::size_t i = 0; i < count; ++i) {
    forces.nodes[i].node = static_cast<std::uint32_t>(random.next() % nodes);
    for (float& component : forces.nodes[i].force) component = static_cast<float>(random.normal());
  }
  return forces;
}

TEST(DisplayField, is_the_product_of_columns_and_forces) {
  const Eigen::MatrixXf columns = random_columns(1777, 60, 1);
  const DisplayField field(columns);
  Random random(2);
  std::vector<float> moved(3 * 1777, 7.0F);
  for (const std::size_t count : {0u, 1u, 2u, 3u, 17u, 50u}) {
    const NodeForces forces = random_forces(random, count, 60);
    field.evaluate(forces, moved);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(180);
    for (std::size_t i = 0; i < count; ++i) {
      for (int c = 0; c < 3; ++c)
        load(3 * forces.nodes[i].node + c) += static_cast<double>(forces.nodes[i].force[static_cast<std::size_t>(c)]);
    }
    const Eigen::VectorXd expected = columns.cast<double>() * load;
    const Eigen::Map<const Eigen::VectorXf> got(moved.data(), expected.size());
    EXPECT_LE((got.cast<double>() - expected).norm(), 1e-6 * expected.norm()) << count;
  }
}

TEST(DisplayField, nodes_that_are_not_there_move_nothing) {
  const DisplayField field(random_columns(10, 4, 3));
  NodeForces forces;
  forces.count = 1;
  forces.nodes[0] = {4, {1.0F, 1.0F, 1.0F}};
  std::vector<float> moved(30, 7.0F);
  field.evaluate(forces, moved);
  EXPECT_EQ(moved, std::vector<float>(30, 0.0F));
}

TEST(DisplayField, refuses_columns_that_are_not_in_threes) {
  EXPECT_THROW(DisplayField(Eigen::MatrixXf(4, 3)), InputError);
  EXPECT_THROW(DisplayField(Eigen::MatrixXf(3, 4)), InputError);
  EXPECT_THROW(DisplayField(Eigen::MatrixXf{}), InputError);
}

TEST(DisplayField, takes_no_memory_and_no_lock) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer watches the heap";
  const DisplayField field(random_columns(100, 10, 4));
  Random random(5);
  const NodeForces forces = random_forces(random, 10, 10);
  std::vector<float> moved(300);
  const RealTimeGuard guard;
  field.evaluate(forces, moved);
  EXPECT_EQ(RealTimeGuard::heap_calls(), 0u);
  EXPECT_EQ(RealTimeGuard::lock_calls(), 0u);
}

// The tick writes, the display reads; neither waits, and no image mixes two ticks.
TEST(DisplayField, a_picture_beside_the_tick_is_always_of_one_tick) {
  const Eigen::MatrixXf columns = Eigen::MatrixXf::Ones(300, 30);
  const DisplayField field(columns);
  LatestValue<NodeForces> exchange;
  std::atomic<bool> done{false};
  const int ticks = sanitized ? 2000 : 50000;
  std::thread tick([&] {
    NodeForces forces;
    forces.count = 10;
    for (int number = 1; number <= ticks; ++number) {
      for (std::size_t i = 0; i < 10; ++i) {
        forces.nodes[i] = {static_cast<std::uint32_t>(i), {static_cast<float>(number), 0.0F, 0.0F}};
      }
      exchange.write(forces);
    }
    done = true;
  });
  std::vector<float> moved(300);
  float last = 0.0F;
  int mixed = 0, backwards = 0;
  bool finished = false;
  while (!finished) {
    finished = done;
    field.evaluate(exchange.read(), moved);
    const float number = moved[0] / 10.0F;
    if (number != static_cast<float>(static_cast<int>(number)) || moved[299] != moved[0]) ++mixed;
    if (number < last) ++backwards;
    last = number;
  }
  tick.join();
  EXPECT_EQ(mixed, 0);
  EXPECT_EQ(backwards, 0);
  EXPECT_EQ(last, static_cast<float>(ticks));
}

}  // namespace
}  // namespace bodkin
