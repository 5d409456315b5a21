#include "haptics/axis_passivity.h"

#include <cmath>
#include <numbers>

#include "tests/one_tick.h"
#include <gtest/gtest.h>

#include "core/random.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

TEST(AxisPassivity, the_energy_of_a_spring_pressed_and_let_go_is_counted_to_the_last_bit) {
  AxisPassivity passivity(0.01);
  // 2 N held while the hand moves 3 mm against it, 1 N while it moves 2 mm along with it.
  passivity.observe({0.0, 0.0, 2.0}, {0.0, 0.0, -3.0}, one_tick);
  EXPECT_DOUBLE_EQ(passivity.energy().z(), 6.0);
  passivity.observe({0.0, 0.0, 1.0}, {0.0, 0.0, 2.0}, one_tick);
  EXPECT_DOUBLE_EQ(passivity.energy().z(), 4.0);
  EXPECT_DOUBLE_EQ(passivity.energy().x(), 0.0);
}

TEST(AxisPassivity, an_axis_that_gives_energy_is_damped_and_its_neighbours_are_not) {
  AxisPassivity passivity(0.01);
  passivity.observe({1.0, 1.0, 0.0}, {0.2, -0.2, 0.0}, one_tick);  // x gives 0.2 N mm, y takes as much
  const Vec3 velocity(20.0, -20.0, 0.0);
  const Vec3 force = passivity.damped({1.0, 1.0, 0.0}, velocity, one_tick);
  // alpha = 0.2 / (0.001 * 400) = 0.5 N s/mm, of which the device renders 0.01.
  EXPECT_DOUBLE_EQ(force.x(), 1.0 - 0.01 * 20.0);
  EXPECT_DOUBLE_EQ(force.y(), 1.0);
  EXPECT_EQ(passivity.damping(), Vec3(0.01, 0.0, 0.0));
}

TEST(AxisPassivity, the_damping_gives_back_exactly_what_is_missing) {
  AxisPassivity passivity(1.0);
  passivity.observe({1.0, 0.0, 0.0}, {0.2, 0.0, 0.0}, one_tick);
  const Vec3 force = passivity.damped(Vec3::Zero(), {200.0, 0.0, 0.0}, one_tick);
  EXPECT_NEAR(force.x(), -1.0, 1e-12);
  passivity.observe(force, {0.2, 0.0, 0.0}, one_tick);
  EXPECT_NEAR(passivity.energy().x(), 0.0, 1e-15);
}

TEST(AxisPassivity, a_force_of_which_a_share_is_alive_is_damped_by_that_share) {
  AxisPassivity passivity(0.01);
  passivity.observe({1.0, 0.0, 0.0}, {0.2, 0.0, 0.0}, one_tick);
  EXPECT_DOUBLE_EQ(passivity.damped({1.0, 0.0, 0.0}, {20.0, 0.0, 0.0}, one_tick, 0.25).x(), 1.0 - 0.25 * 0.01 * 20.0);
}

TEST(AxisPassivity, what_a_count_of_an_encoder_makes_is_left_alone) {
  AxisPassivity passivity(1.0);
  passivity.observe({1.8, 0.0, 0.0}, {0.055, 0.0, 0.0}, one_tick);
  EXPECT_EQ(passivity.damped({1.8, 0.0, 0.0}, {55.0, 0.0, 0.0}, one_tick), Vec3(1.8, 0.0, 0.0));
}

TEST(AxisPassivity, a_hand_at_rest_is_never_pushed) {
  AxisPassivity passivity(1.0);
  passivity.observe({1.0, 0.0, 0.0}, {0.2, 0.0, 0.0}, one_tick);
  EXPECT_EQ(passivity.damped({0.3, 0.0, 0.0}, {0.4, 0.0, 0.0}, one_tick), Vec3(0.3, 0.0, 0.0));
}

TEST(AxisPassivity, half_a_second_without_force_ends_the_account) {
  AxisPassivity passivity(1.0);
  passivity.observe({1.0, 0.0, 0.0}, {-5.0, 0.0, 0.0}, one_tick);
  for (int i = 0; i < 498; ++i) passivity.observe(Vec3::Zero(), {1.0, 0.0, 0.0}, one_tick);
  EXPECT_DOUBLE_EQ(passivity.energy().x(), 5.0);
  for (int i = 0; i < 3; ++i) passivity.observe(Vec3::Zero(), {1.0, 0.0, 0.0}, one_tick);
  EXPECT_DOUBLE_EQ(passivity.energy().x(), 0.0);
}

// A mass on a spring that is a tick late gains energy with every swing; how far it swings after two seconds.
double swing_of_a_late_spring(double damping_limit) {
  constexpr double stiffness = 1.0;  // N/mm
  constexpr double mass = 1e-4;      // N s^2/mm: 0.1 kg
  AxisPassivity passivity(damping_limit);
  Vec3 position(1.0, 0.0, 0.0), velocity = Vec3::Zero(), applied = Vec3::Zero(), late = Vec3::Zero();
  double largest = 0.0;
  for (int tick = 0; tick < 2000; ++tick) {
    const Vec3 before = position;
    velocity += one_tick / mass * applied;
    position += one_tick * velocity;
    passivity.observe(applied, position - before, one_tick);
    applied = passivity.damped(late, velocity, one_tick);
    late = -stiffness * position;
    if (tick > 1800) largest = std::max(largest, position.norm());
  }
  return largest;
}

TEST(AxisPassivity, a_spring_that_would_shake_ever_more_comes_to_rest) {
  EXPECT_GT(swing_of_a_late_spring(0.0), 100.0);
  EXPECT_LT(swing_of_a_late_spring(0.005), 1.5);
}

}  // namespace
}  // namespace bodkin
