#include "fem/corridor_exchange.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <thread>
#include <vector>

#include "tests/fem/needle_rig.h"
#include "tests/sanitized.h"
#include "tests/simulation/real_time_guard.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {
namespace {

using ::testing::HasSubstr;
using Corridor = std::shared_ptr<const CondensedBody>;

// A column of 3 x 3 nodes down the z axis, 1 mm apart: `along` layers of it.
Corridor column(int along, double modulus = 0.05) {
  return std::make_shared<const CondensedBody>(checks::kelvin_body(3, along, 1.0, modulus));
}

// The same body with its nodes in another order.
Corridor turned_round(const CondensedBody& body) {
  auto turned = std::make_shared<CondensedBody>(body);
  std::reverse(turned->nodes.begin(), turned->nodes.end());
  std::reverse(turned->mesh_nodes.begin(), turned->mesh_nodes.end());
  std::reverse(turned->tissues.begin(), turned->tissues.end());
  const auto count = static_cast<Eigen::Index>(body.nodes.size());
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      turned->compliance.block<3, 3>(3 * i, 3 * j) =
          body.compliance.block<3, 3>(3 * (count - 1 - i), 3 * (count - 1 - j));
    }
  }
  return turned;
}

CorridorExchange exchange_of(Corridor first, const ContactTissues& tissues = checks::plain_tissues(0.02)) {
  return {std::move(first), tissues, checks::narrow_settings(), 1e-3};
}

EmbeddedNeedle needle_in(const CondensedBody& body, const ContactTissues& tissues = checks::plain_tissues(0.02)) {
  return {body, tissues, checks::narrow_settings(), 1e-3};
}

Pose down_to(double depth) {
  return needle_pose(Vec3(0.0, 0.0, depth), Vec3::UnitZ());
}

// To `goal` by 10 um a tick, in as many needles at once; the largest change of the first one's force in a tick, N.
double move_to(double goal, double& depth, const std::vector<EmbeddedNeedle*>& needles,
               const std::function<void()>& after = {}) {
  double largest = 0.0;
  Vec3 before = needles[0]->step(down_to(depth)).on_hand.force;
  for (std::size_t other = 1; other < needles.size(); ++other) needles[other]->step(down_to(depth));
  while (std::abs(goal - depth) > 1e-9) {
    depth += std::clamp(goal - depth, -0.01, 0.01);
    const Vec3 force = needles[0]->step(down_to(depth)).on_hand.force;
    largest = std::max(largest, (force - before).norm());
    before = force;
    for (std::size_t other = 1; other < needles.size(); ++other) {
      EXPECT_EQ(needles[other]->step(down_to(depth)).on_hand.force, force) << depth;
    }
    if (after) after();
  }
  return largest;
}

TEST(CorridorExchange, a_needle_keeps_its_corridor_until_it_touches_nothing_and_its_force_never_jumps) {
  const Corridor first = column(16), second = column(16, 0.1);
  CorridorExchange exchange = exchange_of(first);
  EmbeddedNeedle alone = needle_in(*first), fresh = needle_in(*second);
  double depth = -1.0;
  exchange.begin(Vec3::Zero(), Vec3::UnitZ());
  alone.begin(Vec3::Zero(), Vec3::UnitZ());
  double largest = move_to(4.0, depth, {&exchange.needle(), &alone});
  EXPECT_EQ(exchange.offer(second), 1U);
  EXPECT_TRUE(exchange.newer_waits());
  const auto refused = [&] { EXPECT_FALSE(depth > 0.0 && exchange.take_newest()); };
  largest = std::max(largest, move_to(8.0, depth, {&exchange.needle(), &alone}, refused));
  EXPECT_GT(alone.step(down_to(depth)).resistance, 0.1);
  exchange.needle().step(down_to(depth));
  largest = std::max(largest, move_to(-1.0, depth, {&exchange.needle(), &alone}, refused));
  EXPECT_EQ(exchange.number(), 0U);
  EXPECT_EQ(exchange.needle().step(down_to(depth)).on_hand.force, Vec3::Zero());
  ASSERT_TRUE(exchange.take_newest());
  EXPECT_FALSE(exchange.take_newest());
  EXPECT_EQ(&exchange.body(), second.get());
  EXPECT_EQ(exchange.number(), 1U);
  EXPECT_EQ(exchange.needle().step(down_to(depth)).on_hand.force, Vec3::Zero());
  // From here on it is a needle in the other corridor, to the bit.
  exchange.begin(Vec3::Zero(), Vec3::UnitZ());
  fresh.begin(Vec3::Zero(), Vec3::UnitZ());
  largest = std::max(largest, move_to(8.0, depth, {&exchange.needle(), &fresh}));
  EXPECT_LT(largest, 0.02);  // N in 10 um
}

TEST(CorridorExchange, a_corridor_that_has_grown_reaches_further) {
  const Corridor shallow = column(6), deep = column(16);
  CorridorExchange exchange = exchange_of(shallow);
  EmbeddedNeedle fresh = needle_in(*deep);
  double depth = -1.0;
  exchange.begin(Vec3::Zero(), Vec3::UnitZ());
  move_to(10.2, depth, {&exchange.needle()});
  EXPECT_TRUE(exchange.needle().step(down_to(depth)).beyond);
  exchange.offer(deep);
  EXPECT_FALSE(exchange.take_newest());
  move_to(-0.5, depth, {&exchange.needle()});
  EXPECT_TRUE(exchange.take_newest());
  exchange.begin(Vec3::Zero(), Vec3::UnitZ());
  fresh.begin(Vec3::Zero(), Vec3::UnitZ());
  move_to(10.2, depth, {&exchange.needle(), &fresh});
  EXPECT_FALSE(exchange.needle().step(down_to(depth)).beyond);
  EXPECT_EQ(exchange.needle().step(down_to(depth)).nodes, 11U);
}

// In tissue, but beside all nodes of its corridor: more of it would seize the shaft all at once.
TEST(CorridorExchange, a_needle_that_holds_no_node_but_is_in_takes_none) {
  CorridorExchange exchange = exchange_of(column(6));
  exchange.begin(Vec3(30.0, 0.0, 0.0), Vec3::UnitZ());
  const auto at = [&](double depth) {
    return exchange.needle().step(needle_pose(Vec3(30.0, 0.0, depth), Vec3::UnitZ())).nodes;
  };
  EXPECT_EQ(at(5.0), 0U);
  exchange.offer(column(7));
  EXPECT_FALSE(exchange.take_newest());
  EXPECT_EQ(at(0.0), 0U);
  EXPECT_TRUE(exchange.take_newest());
}

TEST(CorridorExchange, a_new_insertion_is_in_the_newest_of_several) {
  std::vector<Corridor> corridors;
  for (int along = 3; along <= 8; ++along) corridors.push_back(column(along));
  CorridorExchange exchange = exchange_of(corridors[0]);
  exchange.begin(Vec3::Zero(), Vec3::UnitZ());
  EXPECT_EQ(exchange.needle().step(down_to(1.5)).nodes, 2U);
  for (std::size_t i = 1; i < corridors.size(); ++i) EXPECT_EQ(exchange.offer(corridors[i]), i);
  EXPECT_EQ(corridors[2].use_count(), 1);  // never taken: dropped
  exchange.begin(Vec3::Zero(), Vec3::UnitZ());
  EXPECT_EQ(&exchange.body(), corridors.back().get());
  EXPECT_EQ(corridors[0].use_count(), 2);  // left, and not freed by the haptic thread
  exchange.free_left();
  EXPECT_EQ(corridors[0].use_count(), 1);
  EXPECT_EQ(exchange.needle().step(down_to(-1.0)).nodes, 0U);
}

TEST(CorridorExchange, what_is_punctured_stays_so_by_the_names_of_its_nodes) {
  ContactTissues tissues = checks::plain_tissues(0.0);
  tissues[tissue::soft].puncture_force = 0.2;
  const Corridor body = column(6), other_order = turned_round(*body);
  auto other_nodes = std::make_shared<CondensedBody>(*body);
  for (std::uint32_t& name : other_nodes->mesh_nodes) name += 1000;
  CorridorExchange exchange = exchange_of(body, tissues);
  const auto skin_resists = [&] {
    double depth = -0.5;
    exchange.begin(Vec3::Zero(), Vec3::UnitZ());
    move_to(0.05, depth, {&exchange.needle()});
    const double before = exchange.needle().step(down_to(depth)).resistance;
    move_to(6.0, depth, {&exchange.needle()});
    move_to(-0.5, depth, {&exchange.needle()});
    return before;
  };
  const double at_first = skin_resists();
  EXPECT_GT(at_first, 0.005);
  EXPECT_LT(skin_resists(), 1e-9);
  exchange.offer(other_order);
  EXPECT_LT(skin_resists(), 1e-9);
  EXPECT_EQ(&exchange.body(), other_order.get());
  exchange.offer(other_nodes);
  EXPECT_NEAR(skin_resists(), at_first, 1e-12);
  exchange.needle().reset();
  EXPECT_NEAR(skin_resists(), at_first, 1e-12);
}

TEST(CorridorExchange, the_haptic_end_takes_no_memory_and_no_lock) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer watches the heap";
  CorridorExchange exchange = exchange_of(column(6));
  for (int round = 0; round < 5; ++round) {
    exchange.offer(column(7 + round));
    const RealTimeGuard guard;
    EXPECT_TRUE(exchange.newer_waits());
    if (round % 2 == 0) {
      EXPECT_TRUE(exchange.take_newest());
    }
    exchange.begin(Vec3::Zero(), Vec3::UnitZ());
    exchange.needle().step(down_to(1.0));
    exchange.needle().step(down_to(-1.0));
    EXPECT_FALSE(exchange.take_newest());
    EXPECT_EQ(RealTimeGuard::heap_calls(), 0U);
    EXPECT_EQ(RealTimeGuard::lock_calls(), 0U);
  }
}

TEST(CorridorExchange, a_needle_beside_a_thread_that_makes_corridors_is_never_waiting_and_never_jumps) {
  CorridorExchange exchange = exchange_of(column(6));
  std::atomic<bool> done{false};
  std::atomic<std::uint32_t> offered{0};
  std::thread maker([&] {
    for (int number = 0; !done; ++number) {
      offered = exchange.offer(column(6 + number % 5));
      if (number % 4 == 3) exchange.free_left();
      std::this_thread::yield();
    }
  });
  std::uint32_t last = 0;
  int taken = 0;
  Vec3 before = Vec3::Zero();
  double largest = 0.0;
  for (int tick = 0; tick < (sanitized ? 4000 : 20000) || taken < 3; ++tick) {
    if (exchange.take_newest()) {
      EXPECT_EQ(before, Vec3::Zero());
      EXPECT_GT(exchange.number(), last);
      exchange.begin(Vec3::Zero(), Vec3::UnitZ());
      ++taken;
    }
    last = exchange.number();
    const double depth = 2.0 - 3.0 * std::cos(2.0 * std::numbers::pi * tick / 2000.0);
    const Vec3 force = exchange.needle().step(down_to(depth)).on_hand.force;
    EXPECT_EQ(exchange.number(), last);
    largest = std::max(largest, (force - before).norm());
    before = force;
    if (tick > 10000000) break;
  }
  done = true;
  maker.join();
  EXPECT_GE(taken, 3);
  EXPECT_GE(offered.load(), static_cast<std::uint32_t>(taken));
  EXPECT_LT(largest, 0.02);
}

TEST(CorridorExchange, refuses_corridors_that_are_none_and_keeps_what_it_has) {
  auto nameless = std::make_shared<CondensedBody>(*column(4)), broken = std::make_shared<CondensedBody>(*column(4));
  nameless->mesh_nodes.pop_back();
  broken->tissues.pop_back();
  try {
    exchange_of(nameless);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("36 nodes and 35 names of them in the mesh"));
  }
  CorridorExchange exchange = exchange_of(column(4));
  EXPECT_THROW(exchange.offer(nameless), InputError);
  EXPECT_THROW(exchange.offer(broken), InputError);
  EXPECT_FALSE(exchange.newer_waits());
  EXPECT_EQ(exchange.offer(column(5)), 1U);
}

}  // namespace
}  // namespace bodkin
