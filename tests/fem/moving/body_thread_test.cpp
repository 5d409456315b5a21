// The thread of a moving body. Tests poll it for at most some seconds.
#include "fem/moving/body_thread.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>
#include <thread>

#include "tests/fem/lattice_body.h"
#include <gtest/gtest.h>

#include "core/error.h"
#include "fem/solid/body_digests.h"

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

Pose probe_down(double depth) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(180.0 * degree, Vec3::UnitX()).toRotationMatrix();
  pose.translation() = Vec3(8.0, 20.0, 40.0 - depth);
  return pose;
}

// Advances time until `done`.
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
  BodyThread moving(small_box(), quick_settings());
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(moving.snapshot().steps, 0U);
  EXPECT_EQ(moving.snapshot().displacements.size(), 3U * 125U);
  double time = 0.0;
  EXPECT_TRUE(runs_until(moving, time, [](const BodySnapshot& picture) { return picture.steps >= 3; }));
  EXPECT_FALSE(moving.failed());
  for (const float moved : moving.motion()->read().moved) ASSERT_EQ(moved, 0.0F) << "nothing presses it";
}

TEST(BodyThread, follows_the_probe_and_tells_picture_and_needle_the_same) {
  BodyThread moving(small_box(), quick_settings());
  double time = 0.0;
  moving.move_probe(probe_down(6.0));
  ASSERT_TRUE(runs_until(moving, time,
                         [](const BodySnapshot& picture) { return picture.probe_nodes > 3U && picture.steps > 60; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // no step comes any more
  const BodySnapshot& picture = moving.snapshot();
  EXPECT_GT(picture.on_probe.force.z(), 0.05);
  EXPECT_LT(*std::min_element(picture.displacements.begin(), picture.displacements.end()), -5.9F);
  EXPECT_EQ(moving.motion()->read().moved, picture.displacements);
  // Withdrawn: back to its original place.
  moving.move_probe(std::nullopt);
  const std::uint64_t before = moving.snapshot().steps;
  ASSERT_TRUE(runs_until(moving, time, [before](const BodySnapshot& now) { return now.steps > before + 150; }));
  EXPECT_EQ(moving.snapshot().probe_nodes, 0U);
  const std::vector<float>& left = moving.motion()->read().moved;
  EXPECT_GT(*std::min_element(left.begin(), left.end()), -0.5F);
  EXPECT_FALSE(moving.failed());
}

// The probe feels what a needle does to the nodes that it holds, and the body's motion is as without it.
TEST(BodyThread, a_needle_in_the_hand_is_felt_by_the_probe) {
  BodyThread alone(small_box(), quick_settings()), pushed(small_box(), quick_settings());
  const Wrench by_needle{Vec3(0.1, -0.2, 0.7), Vec3(3.0, 4.0, -2.0)};
  pushed.push_probe(by_needle);
  double time = 0.0;
  const auto settle = [&](BodyThread& body) {
    body.move_probe(probe_down(6.0));
    return runs_until(body, time, [](const BodySnapshot& now) { return now.probe_nodes > 3U && now.steps > 60; });
  };
  ASSERT_TRUE(settle(alone));
  ASSERT_TRUE(settle(pushed));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // no step comes any more
  // Both rest in the same place: many further steps change nothing.
  EXPECT_LT((pushed.snapshot().on_probe.force - alone.snapshot().on_probe.force - by_needle.force).norm(), 0.01);
  const ProbeReading& reading = pushed.reading();
  EXPECT_EQ(reading.by_needle.force, by_needle.force);
  EXPECT_EQ(reading.on_probe.force, pushed.snapshot().on_probe.force);
  Vec3 middle = Vec3::Zero();
  const BodyField& field = pushed.motion()->read();
  ASSERT_EQ(field.held_count, reading.nodes);
  const BodyDescription box = small_box();
  for (const std::uint32_t node : field.held_nodes())
    middle += (box.mesh.nodes[node] + Eigen::Map<const Eigen::Vector3f>(&field.moved[3 * node]).cast<double>()) /
              static_cast<double>(field.held_count);
  const Vec3 torque = by_needle.torque + (middle - probe_down(6.0).translation()).cross(by_needle.force);
  EXPECT_LT((reading.by_needle.torque - torque).norm(), 1e-4);
  // Lifted: no contact.
  pushed.move_probe(std::nullopt);
  const std::uint64_t before = pushed.snapshot().steps;
  ASSERT_TRUE(runs_until(pushed, time, [before](const BodySnapshot& now) { return now.steps > before + 5; }));
  EXPECT_EQ(pushed.snapshot().on_probe.force, Vec3::Zero());
  EXPECT_EQ(pushed.snapshot().on_probe.torque, Vec3::Zero());
}

// A probe that is held still 3 mm above the skin of a patient who breathes: skin that rises by 9 mm there is pressed
// as deep as by a probe that comes down by 9 mm, and what is recorded of a step is all that it takes to make it
// again.
TEST(BodyThread, skin_that_rises_with_the_breath_is_pressed_by_a_probe_that_is_held_still) {
  Breathing breathing;
  breathing.centre = Vec3(8.0, 20.0, 34.0);
  breathing.motion = Vec3(0.0, 0.0, 9.0);
  breathing.radius = 500.0;  // hardly less beside the centre
  BodyThread breathes(small_box(), quick_settings(), BreathField(breathing)), still(small_box(), quick_settings());
  breathes.move_probe(probe_down(-3.0));
  still.move_probe(probe_down(6.0));
  double time = 0.0;
  for (; time < 1.0; time += 0.002) {
    breathes.set_time(time, 0.0);
    still.set_time(time);
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  EXPECT_EQ(breathes.snapshot().probe_nodes, 0U) << "breathed out it touches nothing";
  const auto settled = [](BodyThread& body) {
    return body.snapshot().probe_nodes > 3U && body.snapshot().steps > 150U;
  };
  for (int look = 0; look < 20000 && !(settled(breathes) && settled(still)); ++look, time += 0.002) {
    breathes.set_time(time, 1.0);
    still.set_time(time);
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const double force = still.snapshot().on_probe.force.z();
  EXPECT_GT(force, 0.05);
  EXPECT_NEAR(breathes.snapshot().on_probe.force.z(), force, 0.02 * force);
  EXPECT_EQ(breathes.reading().probe, probe_down(-3.0).translation()) << "where the hand has it";
  DeformableBodySolver again(small_box(), quick_settings());
  BodyField field = field_at_rest(again);
  BodyStep step;
  std::uint64_t steps = 0;
  while (breathes.steps()->pop(step)) {
    read_field(again, again.step(step.probe).fault, field);
    ASSERT_EQ(step.step, ++steps);
    ASSERT_EQ(step.digest, digest_of(field.moved));
  }
  EXPECT_GT(steps, 150U);
  EXPECT_EQ(field.held_nodes().size(), breathes.snapshot().probe_nodes);
}

TEST(BodyThread, a_probe_that_is_nowhere_is_a_fault_after_which_the_needle_meets_the_body_at_rest) {
  BodyThread moving(small_box(), quick_settings());
  double time = 0.0;
  moving.move_probe(probe_down(6.0));
  ASSERT_TRUE(runs_until(moving, time, [](const BodySnapshot& picture) { return picture.probe_nodes > 0; }));
  EXPECT_FALSE(moving.failed());
  moving.move_probe(probe_down(5e4));  // 50 m
  ASSERT_TRUE(runs_until(moving, time, [](const BodySnapshot& picture) { return picture.faults > 0; }));
  EXPECT_TRUE(moving.failed());
  EXPECT_TRUE(moving.motion()->read().moved.empty());
}

TEST(BodyThread, refuses_what_its_parts_refuse) {
  BodySolverSettings settings = quick_settings();
  settings.motion.density = -1.0;
  EXPECT_THROW(BodyThread(small_box(), settings), InputError);
}

}  // namespace
}  // namespace bodkin
