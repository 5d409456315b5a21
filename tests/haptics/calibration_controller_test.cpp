#include "haptics/calibration_controller.h"

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
  CalibrationController controller;
  int axis = 2;  // along which it moves
  Vec3 position{5.0, -3.0, 10.0};
  double speed = 0.0;  // mm/s
  double force = 0.0;  // N

  // N at the end of so many seconds.
  double run(double seconds) {
    for (int tick = 0; tick < std::lround(seconds / one_tick); ++tick) {
      ControlInput input;
      input.needle.translation() = position;
      input.dt = one_tick;
      force = controller.step(input).wrench.force[axis];
      const double free = speed + one_tick / mass * (force - weight);
      speed = free - std::copysign(std::min(std::abs(free), one_tick / mass * friction), free);
      position[axis] += speed * one_tick;
    }
    return force;
  }
};

TEST(CalibrationController, asks_for_nothing_until_it_is_told_to_carry) {
  Handle handle;
  handle.weight = handle.friction = 0.0;
  EXPECT_EQ(handle.run(0.5), 0.0);
}

TEST(CalibrationController, a_handle_lifted_and_lowered_tells_weight_and_friction) {
  Handle handle;
  handle.controller.carry(Vec3::Zero());
  handle.run(3.0);
  const double low = handle.position.z();
  handle.controller.carry(25.0 * Vec3::UnitZ());
  const double from_below = handle.run(3.5);
  EXPECT_NEAR(handle.position.z() - low, 25.0, 5.0);
  handle.controller.carry(Vec3::Zero());
  const double from_above = handle.run(3.5);
  const WeightFit fit = weight_of(from_below, from_above);
  EXPECT_NEAR(fit.weight, 0.8, 0.05);
  EXPECT_NEAR(fit.friction, 0.1, 0.05);
}

TEST(CalibrationController, a_handle_drawn_aside_and_back_tells_the_friction_of_that_axis) {
  for (const int axis : {0, 1}) {
    Handle handle;
    handle.weight = 0.0;
    handle.friction = 0.06;
    handle.axis = axis;
    handle.controller.carry(Vec3::Zero());
    handle.run(3.0);
    const double here = handle.position[axis];
    handle.controller.carry(15.0 * Vec3::Unit(axis));
    const double from_one_side = handle.run(3.0), way = handle.position[axis] - here;
    handle.controller.carry(Vec3::Zero());
    EXPECT_NEAR(level_friction(from_one_side, handle.run(3.0), way, 15.0), 0.06, 0.03);
  }
  EXPECT_EQ(level_friction(0.5, -0.5, 1.0, 15.0), 0.0) << "it was held";
}

TEST(CalibrationController, never_pulls_with_more_than_four_newton) {
  CalibrationController controller;
  controller.carry(Vec3::Zero());
  ControlInput input;
  input.dt = one_tick;
  controller.step(input);
  input.needle.translation() = Vec3(0.0, 0.0, -500.0);
  double most = 0.0;
  for (int tick = 0; tick < 100; ++tick) most = std::max(most, controller.step(input).wrench.force.norm());
  EXPECT_LE(most, CalibrationController::force_limit + 1e-12);
  EXPECT_GT(most, CalibrationController::force_limit - 0.1);
}

}  // namespace
}  // namespace bodkin
