// The guard in closed loops with forces one to three milliseconds late.
#include <cmath>
#include <string>

#include "tests/haptics/held_on_device.h"
#include <gtest/gtest.h>

#include "haptics/stable_stiffness.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

DeviceAbilities device_like(double peak, double stiffness, double damping, double resolution, double delay) {
  DeviceAbilities device;
  device.peak_force = peak;
  device.stiffness = stiffness;
  device.damping = damping;
  device.resolution = resolution;
  device.delay = delay;
  return device;
}

// As the drivers state them, with another delay measured: the chain that a calibrated device has.
DeviceAbilities measured_device(DeviceAbilities device, double delay) {
  device.measured_delay = delay;
  device.stiffness = stable_stiffness(device, 1000.0).weakest();
  return device;
}

DeviceAbilities omega(double delay) {
  return measured_device(device_like(12.0, 5.0, 0.03, 0.01, 0.00025), delay);
}
DeviceAbilities falcon(double delay) {
  return measured_device(device_like(8.0, 3.0, 0.02, 0.0635, 0.001), delay);
}

DeviceModel light_grip(double mass, double delay) {
  DeviceModel model;
  model.mass = mass;
  model.damping = 0.0005;
  model.friction = 0.02;
  model.hand_mass = 0.05;
  model.grip_stiffness = 0.5;
  model.arm_stiffness = 0.2;
  model.delay = delay;
  return model;
}

// In and out of a wall for two seconds, and for half a second to and fro with the account active.
TEST(DelayedLoop, the_account_agrees_with_what_the_motors_gave_within_two_percent) {
  for (const bool ours : {true, false}) {
    for (const double ticks : {0.0, 0.5, 1.0, 2.0, 3.0}) {
      DeviceAbilities device = device_like(20.0, 1.0, 0.0, 0.02, 0.001 * ticks);
      device.owns_loop = !ours;
      DeviceModel model;
      model.mass = 0.15;
      model.damping = 0.002;
      model.delay = device.delay;
      model.grip_stiffness = 3.0;
      model.grip_damping = 0.01;
      model.arm_stiffness = 2.0;
      model.arm_damping = 0.02;
      HeldOnDevice loop(device, model);
      loop.arm();
      const Vec3 given = loop.model.given, energy = loop.guard.energy();
      double turned_over = 0.0, worst = 0.0, truth = 0.0, before = 0.0;
      for (int i = 0; i < 2500; ++i) {
        const double depth = 3.0 - 6.0 * std::sin(6.283 * 1.5 * 0.001 * i);
        loop.tick({0.0, 0.0, depth - 3.0}, wall_of(1.0));
        truth = given.z() - loop.model.given.z();
        turned_over += std::abs(truth - before);
        before = truth;
        worst = std::max(worst, std::abs(loop.guard.energy().z() - energy.z() - truth));
      }
      EXPECT_GT(turned_over, 30.0) << "N mm that went to and fro";
      EXPECT_LT(worst, 0.02 * std::max(turned_over, 1.0)) << ticks << " ticks, " << ours;
      // The energy that the delay creates, too: with each time in and out the wall gives more than it takes. A count
      // of the encoder is worth 0.06 N mm.
      EXPECT_NEAR(loop.guard.energy().z() - energy.z(), truth, 0.02 * std::abs(truth) + 0.1)
          << ticks << " ticks, " << ours;
    }
  }
}

TEST(DelayedLoop, an_account_without_the_delay_misses_most_of_what_it_creates) {
  // The purpose of this test: the same loop without a known delay.
  DeviceModel model = light_grip(0.15, 0.003);
  HeldOnDevice told(omega(0.003), model), untold(omega(0.0), model);
  for (HeldOnDevice* loop : {&told, &untold}) {
    loop->arm();
    for (int i = 0; i < 400; ++i) loop->tick({0.0, 0.0, 5.0 - 0.05 * std::min(i, 160)}, wall_of(1.0));
  }
  const double told_error = std::abs(told.guard.energy().z() + told.model.given.z());
  const double untold_error = std::abs(untold.guard.energy().z() + untold.model.given.z());
  EXPECT_LT(told_error, 0.05);
  EXPECT_GT(untold_error, 5.0 * told_error);
}

struct ShakingCase {
  const char* name;
  DeviceAbilities device;
  DeviceModel model;
  double stiffness;
};

// Runs into a wall with a light grip and stays there: half a second later nothing may shake.
void expect_quiet(const ShakingCase& c) {
  HeldOnDevice loop(c.device, c.model, 7);
  loop.arm();
  for (int i = 0; i < 2500; ++i) loop.tick({0.0, 0.0, std::max(-3.0, 5.0 - 0.08 * i)}, wall_of(c.stiffness));
  TurningPoints turns(0.05 + 2.0 * c.device.resolution);
  for (int i = 0; i < 500; ++i) {
    loop.tick({0.0, 0.0, -3.0}, wall_of(c.stiffness));
    turns.add(loop.model.position.z());
  }
  EXPECT_LE(turns.count(), 4) << c.name;
}

TEST(DelayedLoop, walls_that_shook_the_hand_for_good_are_calmed) {
  for (const double delay : {0.002, 0.003}) {
    for (const double mass : {0.08, 0.15, 0.25}) {
      expect_quiet({"omega.3, 5 N/mm", omega(delay), light_grip(mass, delay), 5.0});
      expect_quiet({"Falcon, its profile's 3 N/mm", falcon(delay), light_grip(mass, delay), 3.0});
      expect_quiet({"omega.3, 25 N/mm", omega(delay), light_grip(mass, delay), 25.0});
    }
  }
}

// The steps, and the time from the first to the last: a hand moved like a shaken one, regardless of the force.
TEST(DelayedLoop, a_hand_that_shakes_on_any_axis_has_no_force_within_a_tenth_of_a_second) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double hertz : {10.0, 14.0, 22.0, 27.0, 40.0, 80.0, 150.0, 200.0}) {
      HeldOnDevice loop(omega(0.002), DeviceModel{}, 3);
      loop.arm();
      const double wide = hertz < 20.0 ? 60.0 / hertz : 0.15;  // mm from the middle
      double calmed = 0.0, zero = 0.0;
      const Vec3 push = 3.0 * Vec3::UnitY();
      DeviceState state;
      for (int i = 0; i < 1500 && zero == 0.0; ++i) {
        const double time = 0.001 * i;
        state.hand.translation() = loop.state.hand.translation();
        state.hand.translation()[axis] += wide * std::sin(6.2832 * hertz * time);
        const Wrench& applied = loop.guard.step(state, {.wanted = {push, Vec3::Zero()}, .dt = 0.001});
        for (const GuardEvent& event : loop.guard.events()) {
          if (event.reason == GuardReason::halved) calmed = time;
        }
        if (calmed > 0.0 && applied.force.isZero(0.0)) zero = time;
      }
      EXPECT_GT(calmed, 0.0) << axis << ", " << hertz << " Hz";
      EXPECT_GT(zero, 0.0) << axis << ", " << hertz << " Hz";
      EXPECT_LE(zero - calmed, 0.1001) << axis << ", " << hertz << " Hz";
      EXPECT_EQ(loop.guard.fault(), GuardReason::oscillation);
    }
  }
}

}  // namespace
}  // namespace bodkin
