// The threads around a moving body. They wait for each other by looking, for at most some seconds.
#include "fem/moving_body.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "tests/fem/lattice_body.h"
#include "tests/fem/needle_rig.h"
#include "tests/simulation/real_time_guard.h"
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {
namespace {

BodyDescription small_box() {
  BodyDescription body = lattice_body(5, 40.0, 0.0, 5);
  body.materials.set(tissue::ligamentum_flavum, {0.020, 0.3});
  return body;
}

PressedBodySettings quick_settings() {
  PressedBodySettings settings;
  settings.probe.width = 20.0;
  settings.probe.thickness = 24.0;
  return settings;
}

Pose probe_down(double depth) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(180.0 * degree, Vec3::UnitX()).toRotationMatrix();
  pose.translation() = Vec3(8.0, 20.0, 40.0 - depth);
  return pose;
}

// Time goes on until `done` says so.
template <typename Done>
bool runs_until(MovingBody& moving, double& time, const Done& done) {
  for (int look = 0; look < 20000; ++look) {
    if (done(moving.picture())) return true;
    time += 0.002;
    moving.tell_time(time);
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  return false;
}

TEST(MovingBody, stands_still_until_time_goes_on_and_ends_with_its_object) {
  MovingBody moving(small_box(), quick_settings());
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(moving.picture().steps, 0U);
  EXPECT_EQ(moving.picture().displacements.size(), 3U * 125U);
  double time = 0.0;
  EXPECT_TRUE(runs_until(moving, time, [](const BodyPicture& picture) { return picture.steps >= 3; }));
  EXPECT_EQ(moving.picture().faults, 0U);
}

TEST(MovingBody, follows_the_probe_and_hands_a_corridor_to_the_haptic_thread) {
  MovingBody moving(small_box(), quick_settings());
  const CondensedBody first = moving.corridors().body();
  double time = 0.0;
  moving.move_probe(probe_down(6.0));
  ASSERT_TRUE(runs_until(moving, time, [](const BodyPicture& picture) { return picture.corridors > 0; }));
  const BodyPicture& picture = moving.picture();
  EXPECT_GT(picture.probe_nodes, 3U);
  EXPECT_GT(picture.on_probe.force.z(), 0.05);
  EXPECT_LT(*std::min_element(picture.displacements.begin(), picture.displacements.end()), -5.9F);
  EXPECT_TRUE(moving.corridors().take_newest({}));
  EXPECT_GT((moving.corridors().body().compliance - first.compliance).norm(), 0.01 * first.compliance.norm());
  // Away again: back to where it was.
  moving.move_probe(std::nullopt);
  const std::uint32_t before = moving.picture().corridors;
  ASSERT_TRUE(runs_until(moving, time, [before](const BodyPicture& now) { return now.corridors > before; }));
  ASSERT_TRUE(runs_until(moving, time, [](const BodyPicture& now) { return now.steps > 150 && now.settled; }));
  moving.corridors().take_newest({});
  EXPECT_LT((moving.corridors().body().compliance - first.compliance).norm(), 0.1 * first.compliance.norm());
  EXPECT_EQ(moving.picture().probe_nodes, 0U);
  EXPECT_EQ(moving.picture().faults, 0U);
}

TEST(MovingBody, a_force_that_cannot_be_is_a_fault_that_is_told_and_leaves_the_last_good_state) {
  MovingBody moving(small_box(), quick_settings());
  double time = 0.0;
  NodeForces senseless;
  senseless.count = 1;
  senseless.nodes[0] = {0, {3e38F, 3e38F, 0.0F}};
  moving.press_needle(senseless);
  ASSERT_TRUE(runs_until(moving, time, [](const BodyPicture& picture) { return picture.faults > 0; }));
  for (const float moved : moving.picture().displacements) ASSERT_LT(std::abs(moved), 1e-6F);
  moving.press_needle({});
  const std::uint64_t steps = moving.picture().steps;
  ASSERT_TRUE(runs_until(moving, time, [steps](const BodyPicture& picture) { return picture.steps > steps + 3; }));
  const std::uint32_t faults = moving.picture().faults;
  const std::uint64_t later = moving.picture().steps;
  ASSERT_TRUE(runs_until(moving, time, [later](const BodyPicture& picture) { return picture.steps > later + 3; }));
  EXPECT_EQ(moving.picture().faults, faults);
}

// The haptic thread inserts and withdraws a needle while the probe comes and goes on another thread.
TEST(MovingBody, needle_probe_and_picture_on_threads_of_their_own_never_wait_and_the_force_never_jumps) {
  MovingBody moving(small_box(), quick_settings());
  std::atomic<bool> done{false};
  std::atomic<int> taken{0};
  std::atomic<double> largest{0.0};
  std::thread haptic([&] {
    EmbeddedNeedleSettings settings;
    settings.capture_radius = 6.0;
    settings.spacing = 5.0;
    EmbeddedNeedle needle(moving.corridors().body(), checks::plain_tissues(0.02), settings, 1e-3);
    EmbeddedNeedleForce force;
    const Vec3 entry(20.0, 20.0, 40.0);
    needle.begin(entry, -Vec3::UnitZ());
    std::size_t heap = 0, locks = 0;
    for (int tick = 0; tick < 200000 && !(done && tick > 3000); ++tick) {
      moving.tell_time(1e-3 * tick);
      {
        const RealTimeGuard guard;
        if (moving.corridors().take_newest(force)) {
          needle.begin(entry, -Vec3::UnitZ());
          ++taken;
        }
        const double depth = -5.0 + 10.0 * (1.0 - std::cos(2.0 * 3.14159265358979323846 * tick / 1000.0));
        const Vec3 before = force.on_hand.force;
        force = needle.step(needle_pose(entry - Vec3(0.0, 0.0, depth), -Vec3::UnitZ()));
        moving.press_needle(needle.node_forces());
        largest = std::max(largest.load(), (force.on_hand.force - before).norm());
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
    const BodyPicture& picture = moving.picture();
    const float most = *std::max_element(picture.displacements.begin(), picture.displacements.end());
    EXPECT_TRUE(std::isfinite(most));
    if (look % 400 == 0) {
      down = !down;
      ++turns;
      moving.move_probe(down ? std::optional<Pose>(probe_down(6.0)) : std::nullopt);
    }
    if (turns > 2 && taken > 0) done = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  done = true;
  haptic.join();
  EXPECT_GT(taken.load(), 0);
  EXPECT_LT(largest.load(), 0.1);
  EXPECT_EQ(moving.picture().faults, 0U);
}

TEST(MovingBody, refuses_what_its_parts_refuse_and_a_corridor_without_memory) {
  PressedBodySettings settings = quick_settings();
  settings.memory_limit = 1000;
  EXPECT_THROW(MovingBody(small_box(), settings), InputError);
  settings = quick_settings();
  settings.motion.density = -1.0;
  EXPECT_THROW(MovingBody(small_box(), settings), InputError);
}

}  // namespace
}  // namespace bodkin
