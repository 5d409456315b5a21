#include "haptics/weighing.h"

#include <cmath>

#include "tests/one_tick.h"
#include <gtest/gtest.h>

#include "haptics/calibration.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

// A handle that hangs: mass and dry friction, carried by what the controller asks for.
struct Handle {
  double weight = 0.8;    // N
  double friction = 0.1;  // N
  double mass = 1.5e-4;   // N s^2/mm
  Weighing weighing;
  Vec3 position{5.0, -3.0, 10.0};
  double speed = 0.0;  // mm/s, upwards
  double force = 0.0;  // N

  // N at the end of so many seconds.
  double run(double seconds) {
    for (int tick = 0; tick < std::lround(seconds / one_tick); ++tick) {
      ControlInput input;
      input.needle.translation() = position;
      input.dt = one_tick;
      force = weighing.step(input).wrench.force.z();
      const double free = speed + one_tick / mass * (force - weight);
      speed = free - std::copysign(std::min(std::abs(free), one_tick / mass * friction), free);
      position.z() += speed * one_tick;
    }
    return force;
  }
};

TEST(Weighing, asks_for_nothing_until_it_is_told_to_carry) {
  Handle handle;
  handle.weight = handle.friction = 0.0;
  EXPECT_EQ(handle.run(0.5), 0.0);
}

TEST(Weighing, a_handle_lifted_and_lowered_tells_weight_and_friction) {
  Handle handle;
  handle.weighing.carry(0.0);
  handle.run(3.0);
  const double low = handle.position.z();
  handle.weighing.carry(25.0);
  const double from_below = handle.run(3.5);
  EXPECT_NEAR(handle.position.z() - low, 25.0, 5.0);
  handle.weighing.carry(0.0);
  const double from_above = handle.run(3.5);
  const WeightFit fit = weight_of(from_below, from_above);
  EXPECT_NEAR(fit.weight, 0.8, 0.05);
  EXPECT_NEAR(fit.friction, 0.1, 0.05);
}

TEST(Weighing, never_pulls_with_more_than_four_newton) {
  Weighing weighing;
  weighing.carry(0.0);
  ControlInput input;
  input.dt = one_tick;
  weighing.step(input);
  input.needle.translation() = Vec3(0.0, 0.0, -500.0);
  double most = 0.0;
  for (int tick = 0; tick < 100; ++tick) most = std::max(most, weighing.step(input).wrench.force.norm());
  EXPECT_LE(most, Weighing::force_limit + 1e-12);
  EXPECT_GT(most, Weighing::force_limit - 0.1);
}

}  // namespace
}  // namespace bodkin
