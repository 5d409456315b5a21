// The threads around a moving body. They wait for each other by looking, for at most some seconds.
#include "fem/moving/body_thread.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <thread>
#include <vector>

#include "tests/fem/lattice_body.h"
#include "tests/fem/needle_in_corridors.h"
#include "tests/fem/needle_rig.h"
#include "tests/simulation/real_time_guard.h"
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::fem;
namespace {

BodyDescription small_box() {
  BodyDescription body = lattice_body(5, 40.0, 0.0, 5);
  body.materials.set(tissue::ligamentum_flavum, {0.020, 0.3});
  return body;
}

BodySolverSettings quick_settings() {
  BodySolverSettings settings;
  settings.probe.width = 20.0;
  settings.probe.thickness = 24.0;
  return settings;
}

EmbeddedNeedleSettings coarse_settings() {
  EmbeddedNeedleSettings settings;
  settings.capture_radius = 6.0;
  settings.spacing = 5.0;
  return settings;
}

// A body on its thread, and the corridors that it hands to the haptic thread.
struct Stage {
  checks::NeedleInCorridors corridors{std::make_shared<const CondensedBody>(condense(small_box())),
                                      checks::plain_tissues(0.02), coarse_settings()};
  BodyThread moving{small_box(), quick_settings(),
                    [this](std::shared_ptr<const CondensedBody> made) { corridors.offer(std::move(made)); }};
};

Pose probe_down(double depth) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(180.0 * degree, Vec3::UnitX()).toRotationMatrix();
  pose.translation() = Vec3(8.0, 20.0, 40.0 - depth);
  return pose;
}

// Time goes on until `done` says so.
template <typename Done>
bool runs_until(BodyThread& moving, double& time, const Done& done) {
  for (int look = 0; look < 20000; ++look) {
    if (done(moving.snapshot())) return true;
    time += 0.002;
    moving.set_time(time);
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  return false;
}

TEST(BodyThread, stands_still_until_time_goes_on_and_ends_with_its_object) {
  Stage stage;
  BodyThread& moving = stage.moving;
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(moving.snapshot().steps, 0U);
  EXPECT_EQ(moving.snapshot().displacements.size(), 3U * 125U);
  double time = 0.0;
  EXPECT_TRUE(runs_until(moving, time, [](const BodySnapshot& picture) { return picture.steps >= 3; }));
  EXPECT_EQ(moving.snapshot().faults, 0U);
}

TEST(BodyThread, follows_the_probe_and_hands_a_corridor_to_the_haptic_thread) {
  Stage stage;
  BodyThread& moving = stage.moving;
  const CondensedBody first = stage.corridors.body();
  double time = 0.0;
  moving.move_probe(probe_down(6.0));
  ASSERT_TRUE(runs_until(moving, time, [](const BodySnapshot& picture) { return picture.corridors > 0; }));
  const BodySnapshot& picture = moving.snapshot();
  EXPECT_GT(picture.probe_nodes, 3U);
  EXPECT_GT(picture.on_probe.force.z(), 0.05);
  EXPECT_LT(*std::min_element(picture.displacements.begin(), picture.displacements.end()), -5.9F);
  EXPECT_TRUE(stage.corridors.take_newest());
  EXPECT_GT((stage.corridors.body().compliance - first.compliance).norm(), 0.01 * first.compliance.norm());
  // Away again: back to where it was.
  moving.move_probe(std::nullopt);
  const std::uint32_t before = moving.snapshot().corridors;
  ASSERT_TRUE(runs_until(moving, time, [before](const BodySnapshot& now) { return now.corridors > before; }));
  ASSERT_TRUE(runs_until(moving, time, [](const BodySnapshot& now) { return now.steps > 150 && now.settled; }));
  stage.corridors.take_newest();
  EXPECT_LT((stage.corridors.body().compliance - first.compliance).norm(), 0.1 * first.compliance.norm());
  EXPECT_EQ(moving.snapshot().probe_nodes, 0U);
  EXPECT_EQ(moving.snapshot().faults, 0U);
}

TEST(BodyThread, a_force_that_cannot_be_is_a_fault_that_is_told_and_leaves_the_last_good_state) {
  Stage stage;
  BodyThread& moving = stage.moving;
  double time = 0.0;
  NodeForces senseless;
  senseless.count = 1;
  senseless.nodes[0] = {stage.corridors.body().mesh_nodes[0], {3e38F, 3e38F, 0.0F}};
  moving.set_needle_forces(senseless);
  ASSERT_TRUE(runs_until(moving, time, [](const BodySnapshot& picture) { return picture.faults > 0; }));
  for (const float moved : moving.snapshot().displacements) ASSERT_LT(std::abs(moved), 1e-6F);
  moving.set_needle_forces({});
  const std::uint64_t steps = moving.snapshot().steps;
  ASSERT_TRUE(runs_until(moving, time, [steps](const BodySnapshot& picture) { return picture.steps > steps + 3; }));
  const std::uint32_t faults = moving.snapshot().faults;
  const std::uint64_t later = moving.snapshot().steps;
  ASSERT_TRUE(runs_until(moving, time, [later](const BodySnapshot& picture) { return picture.steps > later + 3; }));
  EXPECT_EQ(moving.snapshot().faults, faults);
}

TEST(BodyThread, leads_its_corridor_elsewhere_though_nothing_presses_it) {
  Stage stage;
  BodyThread& moving = stage.moving;
  const BodyDescription box = small_box();
  std::vector<std::uint32_t> aside;
  for (std::uint32_t node = 0; node < box.mesh.nodes.size(); ++node) {
    if ((box.mesh.nodes[node] - Vec3(30.0, 10.0, 30.0)).norm() < 11.0) aside.push_back(node);
  }
  double time = 0.0;
  moving.move_corridor(aside);
  ASSERT_TRUE(runs_until(moving, time, [](const BodySnapshot& picture) { return picture.corridors > 0; }));
  EXPECT_FALSE(moving.move_failed());
  ASSERT_TRUE(stage.corridors.take_newest());
  EXPECT_EQ(stage.corridors.body().mesh_nodes, aside);
  moving.move_corridor({1000000});
  ASSERT_TRUE(runs_until(moving, time, [](const BodySnapshot& picture) { return picture.corridor_failed; }));
  EXPECT_TRUE(moving.move_failed());
}

// The haptic thread inserts and withdraws a needle while the probe comes and goes on another thread.
TEST(BodyThread, needle_probe_and_picture_on_threads_of_their_own_never_wait_and_the_force_never_jumps) {
  Stage stage;
  BodyThread& moving = stage.moving;
  std::atomic<bool> done{false};
  std::atomic<int> taken{0}, taken_inside{0};
  std::atomic<double> largest{0.0};
  std::thread haptic([&] {
    Vec3 before = Vec3::Zero();
    const Vec3 entry(20.0, 20.0, 40.0);
    stage.corridors.begin(entry, -Vec3::UnitZ());
    std::size_t heap = 0, locks = 0;
    for (int tick = 0; tick < 200000 && !(done && tick > 3000); ++tick) {
      moving.set_time(1e-3 * tick);
      {
        const RealTimeGuard guard;
        if (tick % 1000 > 900 && stage.corridors.take_newest()) {
          stage.corridors.begin(entry, -Vec3::UnitZ());
          ++taken;
        }
        const double depth = -5.0 + 10.0 * (1.0 - std::cos(2.0 * std::numbers::pi * tick / 1000.0));
        EmbeddedNeedle& needle = stage.corridors.needle();
        const Vec3 force = needle.step(needle_pose(entry - Vec3(0.0, 0.0, depth), -Vec3::UnitZ())).on_hand.force;
        moving.set_needle_forces(of_mesh(needle.node_forces(), stage.corridors.body()));
        largest = std::max(largest.load(), (force - before).norm());
        before = force;
        if (stage.corridors.go_on_in_newest()) ++taken_inside;
        heap += RealTimeGuard::heap_calls();
        locks += RealTimeGuard::lock_calls();
      }
      if (tick % 5 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (RealTimeGuard::available()) {
      EXPECT_EQ(heap, 0U);
      EXPECT_EQ(locks, 0U);
    }
    done = true;
  });
  bool down = false;
  int turns = 0;
  for (int look = 0; look < 5000 && !done; ++look) {
    const BodySnapshot& picture = moving.snapshot();
    const float most = *std::max_element(picture.displacements.begin(), picture.displacements.end());
    EXPECT_TRUE(std::isfinite(most));
    if (look % 400 == 0) {
      down = !down;
      ++turns;
      moving.move_probe(down ? std::optional<Pose>(probe_down(6.0)) : std::nullopt);
    }
    if (turns > 2 && taken + taken_inside > 1) done = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  done = true;
  haptic.join();
  EXPECT_GT(taken + taken_inside, 0);
  EXPECT_LT(largest.load(), 0.1);
  EXPECT_EQ(moving.snapshot().faults, 0U);
}

TEST(BodyThread, a_corridor_that_cannot_be_made_or_taken_is_told_and_the_body_goes_on) {
  const auto press = [](BodyThread& moving) {
    double time = 0.0;
    moving.move_probe(probe_down(6.0));
    ASSERT_TRUE(runs_until(moving, time, [](const BodySnapshot& picture) { return picture.corridor_failed; }));
    const std::uint64_t steps = moving.snapshot().steps;
    EXPECT_TRUE(runs_until(moving, time, [steps](const BodySnapshot& now) { return now.steps > steps + 3; }));
    EXPECT_EQ(moving.snapshot().corridors, 0U);
    EXPECT_EQ(moving.snapshot().faults, 0U);
  };
  BodySolverSettings settings = quick_settings();
  settings.memory_limit = 1000;
  BodyThread without_memory(small_box(), settings, [](const auto&) { ADD_FAILURE(); });
  press(without_memory);
  BodyThread without_taker(small_box(), quick_settings(), [](const auto&) { throw InputError("no"); });
  press(without_taker);
}

TEST(BodyThread, refuses_what_its_parts_refuse) {
  BodySolverSettings settings = quick_settings();
  settings.motion.density = -1.0;
  EXPECT_THROW(BodyThread(small_box(), settings, [](const auto&) {}), InputError);
}

}  // namespace
}  // namespace bodkin
