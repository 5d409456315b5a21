#include "fem/pressed_body.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/fem/lattice_body.h"
#include "tests/fem/needle_rig.h"
#include "tests/simulation/real_time_guard.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "fem/corridor_exchange.h"

namespace bodkin {
namespace {

using ::testing::HasSubstr;

// A box of 40 mm held at its bottom with nodes every 5 mm, of which those down the middle are the corridor; a needle
// goes straight down it, beside a probe.
const BodyDescription& box_beside_probe() {
  static const BodyDescription body = [] {
    BodyDescription box = lattice_body(9, 40.0, 0.0, 20);
    box.materials.set(tissue::ligamentum_flavum, {0.020, 0.3});
    return box;
  }();
  return body;
}

PressedBodySettings beside_needle() {
  PressedBodySettings settings;
  settings.motion.dt = 0.0;
  settings.motion.gradients.tolerance = 1e-3;
  settings.probe.width = 14.0;
  settings.probe.thickness = 31.0;
  settings.settled = 1e-4;
  return settings;
}

Pose probe_beside(double depth) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(180.0 * degree, Vec3::UnitX()).toRotationMatrix();
  pose.translation() = Vec3(8.0, 20.0, 40.0 - depth);
  return pose;
}

TEST(PressedBody, says_when_a_new_corridor_is_due_and_makes_it) {
  PressedBody pressed(box_beside_probe(), beside_needle());
  CondensedBody at_rest, corridor;
  EXPECT_FALSE(pressed.corridor_is_due());
  ASSERT_TRUE(pressed.make_corridor(at_rest));
  const CondensedBody linear = condense(box_beside_probe());
  EXPECT_LT((at_rest.compliance - linear.compliance).norm(), 1e-10 * linear.compliance.norm());
  EXPECT_EQ(at_rest.mesh_nodes, linear.mesh_nodes);
  EXPECT_EQ(at_rest.tissues, linear.tissues);
  for (int step = 0; step < 20; ++step) {
    pressed.step(probe_beside(0.1), {});
    EXPECT_FALSE(pressed.corridor_is_due());  // not worth it
  }
  EXPECT_TRUE(pressed.settled());
  pressed.step(probe_beside(8.0), {});
  EXPECT_FALSE(pressed.settled());
  EXPECT_FALSE(pressed.corridor_is_due());  // not there yet
  NodeForces needle;
  needle.count = 1;
  needle.nodes[0] = {3, {0.0F, 0.0F, -0.01F}};
  for (int step = 0; step < 40; ++step) pressed.step(probe_beside(8.0), needle);
  EXPECT_TRUE(pressed.settled());
  EXPECT_FALSE(pressed.corridor_is_due());  // a needle is in it
  for (int step = 0; step < 40; ++step) pressed.step(probe_beside(8.0), {});
  ASSERT_TRUE(pressed.corridor_is_due());
  ASSERT_TRUE(pressed.make_corridor(corridor));
  EXPECT_FALSE(pressed.corridor_is_due());
  EXPECT_EQ(corridor.mesh_nodes, at_rest.mesh_nodes);
  EXPECT_GT((corridor.compliance - at_rest.compliance).norm(), 0.02 * at_rest.compliance.norm());
  for (std::size_t i = 0; i < corridor.nodes.size(); ++i)
    EXPECT_EQ(corridor.nodes[i], pressed.body().position(corridor.mesh_nodes[i]));
}

TEST(PressedBody, forces_of_the_needle_move_it_and_those_on_no_node_do_nothing) {
  PressedBody pressed(box_beside_probe(), beside_needle());
  NodeForces needle;
  needle.count = 2;
  needle.nodes[0] = {2, {0.0F, 0.001F, 0.0F}};
  needle.nodes[1] = {20, {1.0F, 1.0F, 1.0F}};
  for (int step = 0; step < 20; ++step) pressed.step(std::nullopt, needle);
  const CondensedBody linear = condense(box_beside_probe());
  for (std::size_t i = 0; i < linear.nodes.size(); ++i) {
    const Vec3 moved = pressed.body().position(linear.mesh_nodes[i]) - linear.nodes[i];
    const Vec3 expected = 0.001 * linear.compliance.block<3, 1>(3 * static_cast<Eigen::Index>(i), 7);
    EXPECT_LT((moved - expected).norm(), 0.03 * expected.norm() + 1e-5);
  }
}

TEST(PressedBody, a_step_takes_no_memory_and_no_lock) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer watches the heap";
  PressedBody pressed(box_beside_probe(), PressedBodySettings{});
  NodeForces needle;
  const RealTimeGuard guard;
  for (int step = 0; step < 20; ++step) pressed.step(probe_beside(0.3 * step), needle);
  pressed.step(std::nullopt, needle);
  EXPECT_EQ(RealTimeGuard::heap_calls(), 0U);
  EXPECT_EQ(RealTimeGuard::lock_calls(), 0U);
}

TEST(PressedBody, a_corridor_without_memory_is_not_made_and_settings_out_of_range_are_refused) {
  PressedBodySettings settings = beside_needle();
  settings.memory_limit = 1000;
  PressedBody pressed(box_beside_probe(), settings);
  CondensedBody corridor;
  corridor.tissues.assign(3, tissue::air);
  EXPECT_FALSE(pressed.make_corridor(corridor));
  EXPECT_EQ(corridor.tissues.size(), 3U);
  settings = beside_needle();
  settings.worth = 0.0;
  try {
    const PressedBody other(box_beside_probe(), settings);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("worth 0 mm, expected both above 0"));
  }
}

// The corridor before and under the press.
std::array<CondensedBody, 2> two_corridors() {
  PressedBody pressed(box_beside_probe(), beside_needle());
  std::array<CondensedBody, 2> made;
  EXPECT_TRUE(pressed.make_corridor(made[0]));
  for (int step = 0; step < 50; ++step) pressed.step(probe_beside(8.0), {});
  EXPECT_TRUE(pressed.make_corridor(made[1]));
  return made;
}

EmbeddedNeedleSettings wide_settings() {
  EmbeddedNeedleSettings settings;
  settings.capture_radius = 3.0;
  settings.spacing = 2.0;
  return settings;
}

// A needle goes straight down from above the highest node of the corridor, in its middle.
struct Insertion {
  Vec3 entry;
  Pose at(double depth) const { return needle_pose(entry - Vec3(0.0, 0.0, depth), -Vec3::UnitZ()); }
};

Insertion insertion_into(const CondensedBody& corridor) {
  Insertion insertion;
  insertion.entry = Vec3(20.0, 20.0, 0.0);
  for (const Vec3& node : corridor.nodes) insertion.entry.z() = std::max(insertion.entry.z(), node.z());
  return insertion;
}

TEST(CorridorExchange, a_needle_keeps_its_corridor_until_it_touches_nothing_and_its_force_never_jumps) {
  const std::array<CondensedBody, 2> made = two_corridors();
  const ContactTissues tissues = checks::plain_tissues(0.02);
  CorridorExchange exchange(made[0]);
  EmbeddedNeedle needle(exchange.body(), tissues, wide_settings(), 1e-3);
  EmbeddedNeedle alone(made[0], tissues, wide_settings(), 1e-3);
  Insertion insertion = insertion_into(made[0]);
  for (EmbeddedNeedle* each : {&needle, &alone}) each->begin(insertion.entry, -Vec3::UnitZ());
  EmbeddedNeedleForce force;
  double depth = -1.0, largest = 0.0;
  const auto go = [&](double goal, bool both) {
    while (std::abs(goal - depth) > 1e-9) {
      depth += std::clamp(goal - depth, -0.01, 0.01);
      const Vec3 before = force.on_hand.force;
      force = needle.step(insertion.at(depth));
      largest = std::max(largest, (force.on_hand.force - before).norm());
      if (both) {
        EXPECT_EQ(force.on_hand.force, alone.step(insertion.at(depth)).on_hand.force);
        // The press changes while the needle is in: it is not told.
        EXPECT_FALSE(force.nodes > 0 && exchange.take_newest(force));
      }
    }
  };
  go(12.0, true);
  EXPECT_GT(force.nodes, 1U);
  EXPECT_GT(force.resistance, 0.1);
  exchange.to_fill() = made[1];
  exchange.publish();
  EXPECT_TRUE(exchange.newer_waits());
  EXPECT_FALSE(exchange.take_newest(force));
  go(20.0, true);
  go(-1.0, false);
  EXPECT_EQ(force.on_hand.force, Vec3::Zero());
  const CondensedBody* const address = &exchange.body();
  EXPECT_TRUE(exchange.take_newest(force));
  EXPECT_EQ(&exchange.body(), address);
  EXPECT_EQ(exchange.body().compliance, made[1].compliance);
  EXPECT_FALSE(exchange.take_newest(force));
  // From here on it is a needle in the other corridor, to the bit.
  EmbeddedNeedle fresh(made[1], tissues, wide_settings(), 1e-3);
  insertion = insertion_into(made[1]);
  needle.begin(insertion.entry, -Vec3::UnitZ());
  fresh.begin(insertion.entry, -Vec3::UnitZ());
  for (depth = -1.0; depth < 20.0; depth += 0.01) {
    const Vec3 before = force.on_hand.force;
    force = needle.step(insertion.at(depth));
    EXPECT_EQ(force.on_hand.force, fresh.step(insertion.at(depth)).on_hand.force);
    largest = std::max(largest, (force.on_hand.force - before).norm());
  }
  EXPECT_GT(force.resistance, 0.1);
  EXPECT_LT(largest, 0.02);  // N in 10 um
}

TEST(CorridorExchange, the_haptic_end_takes_no_memory_and_no_lock) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer watches the heap";
  CondensedBody first = checks::kelvin_body(3, 10, 1.0), second = first;
  second.compliance *= 2.0;
  CorridorExchange exchange(first);
  for (int round = 0; round < 5; ++round) {
    exchange.to_fill() = round % 2 == 0 ? second : first;
    exchange.publish();
    {
      const RealTimeGuard guard;
      EXPECT_TRUE(exchange.newer_waits());
      EXPECT_TRUE(exchange.take_newest({}));
      EXPECT_FALSE(exchange.take_newest({}));
      EXPECT_EQ(RealTimeGuard::heap_calls(), 0U);
      EXPECT_EQ(RealTimeGuard::lock_calls(), 0U);
    }
    EXPECT_EQ(exchange.body().compliance, (round % 2 == 0 ? second : first).compliance);
    EXPECT_EQ(exchange.body().nodes.size(), first.nodes.size());
  }
}

TEST(CorridorExchange, of_several_the_newest_is_taken_and_a_needle_that_presses_takes_none) {
  CondensedBody first = checks::kelvin_body(1, 4, 1.0);
  CorridorExchange exchange(first);
  for (int number = 1; number <= 7; ++number) {
    exchange.to_fill() = first;
    exchange.to_fill().compliance *= number;
    exchange.publish();
  }
  EmbeddedNeedleForce force;
  force.tip_force = 0.2;
  EXPECT_FALSE(exchange.take_newest(force));
  force = {};
  force.nodes = 1;
  EXPECT_FALSE(exchange.take_newest(force));
  EXPECT_TRUE(exchange.take_newest({}));
  EXPECT_EQ(exchange.body().compliance, (7.0 * first.compliance).eval());
}

}  // namespace
}  // namespace bodkin
