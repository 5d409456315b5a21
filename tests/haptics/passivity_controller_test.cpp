#include "haptics/passivity_controller.h"

#include <cmath>
#include <limits>

#include "tests/one_tick.h"
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

PassivityController unlimited_controller() {
  return {one_tick, unlimited, unlimited, 0.5};
}

TEST(PassivityController, active_force_from_nothing_is_taken_back_whole) {
  PassivityController controller = unlimited_controller();
  EXPECT_NEAR(controller.step(1.0, -10.0, true), 0.0, 1e-12);
  EXPECT_NEAR(controller.damping(), 0.1, 1e-12);
  EXPECT_NEAR(controller.energy(), 0.0, 1e-15);
}

TEST(PassivityController, the_tabulated_sequence_uses_up_its_credit_first) {
  PassivityController controller = unlimited_controller();
  const double force[] = {0.5, 1.0, 1.0}, velocity[] = {10, 10, -10}, energy[] = {0.005, 0.015, 0.005};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(controller.step(force[i], velocity[i], true), force[i]);
    EXPECT_NEAR(controller.energy(), energy[i], 1e-15);
    EXPECT_EQ(controller.damping(), 0.0);
  }
  EXPECT_NEAR(controller.step(0.8, -10.0, true), 0.5, 1e-12);
  EXPECT_NEAR(controller.damping(), 0.03, 1e-12);
  EXPECT_NEAR(controller.energy(), 0.0, 1e-15);
}

TEST(PassivityController, below_the_velocity_threshold_the_debt_is_carried_on) {
  PassivityController controller = unlimited_controller();
  EXPECT_EQ(controller.step(1.0, -0.4, true), 1.0);
  EXPECT_NEAR(controller.energy(), -0.0004, 1e-15);
  EXPECT_EQ(controller.step(1.0, 0.0, true), 1.0);
  controller.step(0.0, -10.0, true);
  EXPECT_NEAR(controller.energy(), 0.0, 1e-15);
}

TEST(PassivityController, damping_is_bounded_by_the_device_and_the_rest_follows_later) {
  PassivityController controller(one_tick, 0.03, 6.0, 0.5);
  EXPECT_NEAR(controller.step(1.0, -10.0, true), 0.7, 1e-12);
  EXPECT_NEAR(controller.energy(), -0.007, 1e-15);
}

TEST(PassivityController, the_force_that_comes_out_is_bounded) {
  PassivityController controller(one_tick, unlimited, 6.0, 0.5);
  EXPECT_EQ(controller.step(-20.0, 50.0, true), 0.0);
  controller = PassivityController(one_tick, 1.0, 6.0, 0.5);
  controller.step(-20.0, 0.4, true);
  EXPECT_LE(std::abs(controller.step(-20.0, 0.6, true)), 6.0);
}

TEST(PassivityController, credit_is_forgotten_half_a_second_after_contact) {
  PassivityController controller = unlimited_controller();
  controller.step(5.0, 100.0, true);
  for (int tick = 0; tick < 490; ++tick) controller.step(0.0, 0.0, false);
  EXPECT_NEAR(controller.energy(), 0.5, 1e-12);
  for (int tick = 0; tick < 20; ++tick) controller.step(0.0, 0.0, false);
  EXPECT_EQ(controller.energy(), 0.0);
}

TEST(PassivityController, no_force_however_active_ever_gives_more_than_it_took) {
  PassivityController controller = unlimited_controller();
  Random random(11);
  double taken = 0.0;
  for (int tick = 0; tick < 100000; ++tick) {
    const double velocity = random.uniform(-100.0, 100.0);
    if (std::abs(velocity) < 0.5) continue;
    const double force = random.uniform(-3.0, 3.0) - 0.02 * velocity;  // a negative damper
    taken += controller.step(force, velocity, true) * velocity * one_tick;
    EXPECT_GE(taken, -1e-9);
  }
}

}  // namespace
}  // namespace bodkin
