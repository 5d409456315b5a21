#include <cmath>
#include <vector>

#include "tests/one_tick.h"
#include "tests/simulation/real_time_guard.h"
#include <gtest/gtest.h>

#include "haptics/device_port.h"
#include "haptics/drivers/simulated.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

const std::string quick =
    "speed_mm_s=100 depth_mm=20 wait_s=1 tremor_mm=0 ";  // 30 mm above, 20 mm below: 0.5 s a way

// Every state of a whole performance, `push` in N on the hand.
std::vector<DeviceState> performance(const std::string& settings, const Vec3& push = Vec3::Zero()) {
  DevicePort port(simulated_driver(), "", settings);
  port.start();
  std::vector<DeviceState> states;
  DeviceState state;
  while (!state.ended() && states.size() < 100'000) {
    port.exchange({push, Vec3::Zero()}, state);
    states.push_back(state);
  }
  return states;
}

Vec3 at(const std::vector<DeviceState>& states, double time) {
  return states.at(static_cast<std::size_t>(std::lround(time / one_tick)) - 1).hand.translation();
}

TEST(SimulatedDriver, rests_goes_in_waits_comes_out_and_ends) {
  const auto states = performance(quick);
  EXPECT_EQ(states.size(), 4000u);  // 1.5 s rest, 0.5 s in, 1 s there, 0.5 s out, 0.5 s rest
  EXPECT_TRUE(at(states, 1.4).isZero());
  EXPECT_NEAR(at(states, 1.75).z(), -25.0, 1e-2 + 100.0 * 0.001);
  EXPECT_NEAR(at(states, 2.9).z(), -50.0, 1e-3);
  EXPECT_NEAR(at(states, 3.9).z(), 0.0, 1e-2);
  for (const DeviceState& state : states) {
    ASSERT_EQ(state.fault, DeviceFault::none);
    ASSERT_TRUE(needle_axis(state.hand).isApprox(-Vec3::UnitZ()));
  }
  EXPECT_NEAR(states[1750].velocity.z(), -100.0, 2.0);
}

TEST(SimulatedDriver, yields_to_the_force_as_its_spring_says) {
  const auto states = performance(quick + "stiffness_N_mm=0.5", {1.0, 0.0, 2.0});
  EXPECT_NEAR((at(states, 2.9) - Vec3(2.0, 0.0, -50.0 + 4.0)).norm(), 0.0, 0.05);
}

TEST(SimulatedDriver, goes_along_its_axis_from_above_the_entry) {
  const auto states = performance(quick + "tilt_deg=30 lateral_mm=5");
  const Vec3 entry(5.0, 0.0, -30.0), axis(0.0, 0.5, -std::sqrt(3.0) / 2.0);
  EXPECT_TRUE(needle_axis(states.front().hand).isApprox(axis));
  EXPECT_TRUE(at(states, 1.0).isApprox(entry - 30.0 * axis, 1e-9));
  EXPECT_NEAR((at(states, 2.9) - (entry + 20.0 * axis)).norm(), 0.0, 1e-3);
  const auto side = performance(quick + "side_deg=30");
  EXPECT_TRUE(needle_axis(side.front().hand).isApprox(Vec3(0.5, 0.0, -std::sqrt(3.0) / 2.0)));
}

TEST(SimulatedDriver, trembles_as_its_seed_says_and_not_while_it_is_armed) {
  const std::string trembling = "speed_mm_s=100 depth_mm=0 wait_s=4 tremor_mm=0.5 ";
  const auto one = performance(trembling + "seed=1"), again = performance(trembling + "seed=1");
  const auto other = performance(trembling + "seed=2");
  double sum = 0.0;
  int count = 0;
  bool differs = false;
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].hand.translation(), again[i].hand.translation());
    differs = differs || one[i].hand.translation() != other[i].hand.translation();
    if (i < 1500) {
      ASSERT_TRUE(one[i].hand.translation().isZero());
    }
    if (i < 2500 || i >= 5500) continue;
    sum += one[i].hand.translation().x() * one[i].hand.translation().x();
    ++count;
  }
  EXPECT_TRUE(differs);
  EXPECT_GT(std::sqrt(sum / count), 0.25);  // the hand's mass and spring pass on what is near 10 Hz
  EXPECT_LT(std::sqrt(sum / count), 1.5);
}

TEST(SimulatedDriver, begins_anew_with_every_start) {
  DevicePort port(simulated_driver(), "", quick);
  DeviceState state;
  for (int start = 0; start < 2; ++start) {
    port.start();
    for (int tick = 0; tick < 4000; ++tick) {
      port.exchange({}, state);
      ASSERT_EQ(state.ended(), tick == 3999) << tick;
    }
    port.stop();
  }
}

TEST(SimulatedDriver, has_a_force_and_can_be_found) {
  EXPECT_EQ(list_devices(simulated_driver(), "").size(), 1u);
  const DevicePort port(simulated_driver(), "", "peak_N=4 rate_Hz=500");
  EXPECT_EQ(port.abilities().peak_force, 4.0);
  EXPECT_EQ(port.abilities().rate, 500.0);
  EXPECT_FALSE(port.abilities().owns_loop);
}

TEST(SimulatedDriver, refuses_settings_that_make_no_sense) {
  for (const char* settings : {"speed_mm_s=0", "speed_mm_s=nan", "depth_mm=-31", "tilt_deg=90", "tremor_mm=-1",
                               "seed=-1", "stiffness_N_mm=0", "rate_Hz=100", "colour=red", "speed_mm_s"}) {
    EXPECT_THROW(DevicePort(simulated_driver(), "", settings), InputError) << settings;
  }
}

TEST(SimulatedDriver, an_exchange_allocates_and_locks_nothing) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer owns malloc and the locks in this build";
  DevicePort port(simulated_driver(), "", "");
  port.start();
  DeviceState state;
  {
    const RealTimeGuard guard;
    for (int round = 0; round < 3000; ++round) port.exchange({Vec3(0, 0, 1), Vec3::Zero()}, state);
  }
  EXPECT_EQ(RealTimeGuard::heap_calls() + RealTimeGuard::lock_calls(), 0u);
}

}  // namespace
}  // namespace bodkin
