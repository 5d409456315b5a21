#include "fem/moving/deformable_body_solver.h"

#include <algorithm>
#include <cmath>

#include "tests/fem/lattice_body.h"
#include "tests/simulation/real_time_guard.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
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

BodySolverSettings beside_needle() {
  BodySolverSettings settings;
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

TEST(DeformableBodySolver, says_when_a_new_corridor_is_due_and_makes_it) {
  DeformableBodySolver pressed(box_beside_probe(), beside_needle());
  EXPECT_FALSE(pressed.corridor_is_due());
  const auto at_rest = pressed.make_corridor();
  ASSERT_NE(at_rest, nullptr);
  const CondensedBody linear = condense(box_beside_probe());
  EXPECT_LT((at_rest->compliance - linear.compliance).norm(), 1e-10 * linear.compliance.norm());
  EXPECT_EQ(at_rest->mesh_nodes, linear.mesh_nodes);
  EXPECT_EQ(at_rest->tissues, linear.tissues);
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
  needle.nodes[0] = {at_rest->mesh_nodes[3], {0.0F, 0.0F, -0.01F}};
  for (int step = 0; step < 40; ++step) pressed.step(probe_beside(8.0), needle);
  EXPECT_TRUE(pressed.settled());
  EXPECT_TRUE(pressed.corridor_is_due()) << "though a needle is in it";
  for (int step = 0; step < 40; ++step) pressed.step(probe_beside(8.0), {});
  ASSERT_TRUE(pressed.corridor_is_due());
  const auto corridor = pressed.make_corridor();
  ASSERT_NE(corridor, nullptr);
  EXPECT_FALSE(pressed.corridor_is_due());
  EXPECT_EQ(corridor->mesh_nodes, at_rest->mesh_nodes);
  EXPECT_GT((corridor->compliance - at_rest->compliance).norm(), 0.02 * at_rest->compliance.norm());
  for (std::size_t i = 0; i < corridor->nodes.size(); ++i)
    EXPECT_EQ(corridor->nodes[i], pressed.body().position(corridor->mesh_nodes[i]));
}

TEST(DeformableBodySolver, forces_of_the_needle_move_it_and_those_on_no_node_do_nothing) {
  DeformableBodySolver pressed(box_beside_probe(), beside_needle());
  NodeForces needle;
  needle.count = 2;
  const CondensedBody linear = condense(box_beside_probe());
  needle.nodes[0] = {linear.mesh_nodes[2], {0.0F, 0.001F, 0.0F}};
  needle.nodes[1] = {static_cast<std::uint32_t>(box_beside_probe().mesh.nodes.size()), {1.0F, 1.0F, 1.0F}};
  for (int step = 0; step < 20; ++step) pressed.step(std::nullopt, needle);
  for (std::size_t i = 0; i < linear.nodes.size(); ++i) {
    const Vec3 moved = pressed.body().position(linear.mesh_nodes[i]) - linear.nodes[i];
    const Vec3 expected = 0.001 * linear.compliance.block<3, 1>(3 * static_cast<Eigen::Index>(i), 7);
    EXPECT_LT((moved - expected).norm(), 0.03 * expected.norm() + 1e-5);
  }
}

// What the needle does to it is no part of the corridor, however it strains the tissue.
TEST(DeformableBodySolver, a_corridor_made_while_a_needle_is_in_is_that_of_the_body_without_it) {
  DeformableBodySolver alone(box_beside_probe(), beside_needle()), with_needle(box_beside_probe(), beside_needle());
  NodeForces needle;
  needle.count = 2;
  needle.nodes[0] = {alone.corridor_at_rest().mesh_nodes[3], {0.02F, 0.0F, -0.05F}};
  needle.nodes[1] = {alone.corridor_at_rest().mesh_nodes[5], {0.03F, 0.0F, -0.05F}};
  for (int step = 0; step < 60; ++step) {
    alone.step(probe_beside(8.0), {});
    with_needle.step(probe_beside(8.0), needle);
  }
  ASSERT_TRUE(with_needle.corridor_is_due());
  const std::uint32_t node = needle.nodes[1].node;
  EXPECT_GT((with_needle.body().position(node) - alone.body().position(node)).norm(), 0.2);
  const auto expected = alone.make_corridor(), found = with_needle.make_corridor();
  ASSERT_NE(found, nullptr);
  // The tolerance of `settled`; and nothing of the needle's own motion is worth another corridor.
  EXPECT_LT((found->compliance - expected->compliance).norm(), 1e-4 * expected->compliance.norm());
  for (std::size_t i = 0; i < found->nodes.size(); ++i)
    EXPECT_LT((found->nodes[i] - expected->nodes[i]).norm(), 1e-3);
  needle.nodes[1].force[0] = 0.06F;
  for (int step = 0; step < 60; ++step) with_needle.step(probe_beside(8.0), needle);
  EXPECT_TRUE(with_needle.settled());
  EXPECT_FALSE(with_needle.corridor_is_due());
  for (int step = 0; step < 60; ++step) with_needle.step(std::nullopt, needle);
  EXPECT_TRUE(with_needle.corridor_is_due()) << "the probe has gone";
}

TEST(DeformableBodySolver, a_corridor_that_is_led_elsewhere_is_that_of_a_body_that_had_it_from_the_beginning) {
  BodyDescription other = box_beside_probe();
  other.corridor.clear();
  for (std::uint32_t node = 0; node < other.mesh.nodes.size(); ++node) {
    if ((other.mesh.nodes[node] - Vec3(30.0, 10.0, 30.0)).norm() < 11.0) other.corridor.push_back(node);
  }
  DeformableBodySolver led(box_beside_probe(), beside_needle()), there(other, beside_needle());
  for (int step = 0; step < 60; ++step) {
    led.step(probe_beside(6.0), {});
    there.step(probe_beside(6.0), {});
  }
  BodyState state;
  led.take_state(state);
  const auto found = led.make_corridor(state, {}, other.corridor), expected = there.make_corridor();
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->mesh_nodes, expected->mesh_nodes);
  EXPECT_EQ(found->tissues, expected->tissues);
  EXPECT_LT((found->compliance - expected->compliance).norm(), 1e-9 * expected->compliance.norm());
  EXPECT_EQ(led.make_corridor(state)->mesh_nodes, expected->mesh_nodes) << "it stays there";
  EXPECT_EQ(led.make_corridor(state, {}, {3000000}), nullptr);
  EXPECT_EQ(led.make_corridor(state)->mesh_nodes, expected->mesh_nodes) << "for it cannot be led where nothing is";
}

TEST(DeformableBodySolver, a_step_takes_no_memory_and_no_lock) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer watches the heap";
  DeformableBodySolver pressed(box_beside_probe(), BodySolverSettings{});
  NodeForces needle;
  const RealTimeGuard guard;
  for (int step = 0; step < 20; ++step) pressed.step(probe_beside(0.3 * step), needle);
  pressed.step(std::nullopt, needle);
  EXPECT_EQ(RealTimeGuard::heap_calls(), 0U);
  EXPECT_EQ(RealTimeGuard::lock_calls(), 0U);
}

TEST(DeformableBodySolver, a_corridor_without_memory_is_not_made_and_settings_out_of_range_are_refused) {
  BodySolverSettings settings = beside_needle();
  settings.memory_limit = 1000;
  DeformableBodySolver pressed(box_beside_probe(), settings);
  EXPECT_EQ(pressed.make_corridor(), nullptr);
  settings = beside_needle();
  settings.worth = 0.0;
  try {
    const DeformableBodySolver other(box_beside_probe(), settings);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("worth 0 mm, expected both above 0"));
  }
}

}  // namespace
}  // namespace bodkin
