// All faults of a device or a simulation, on every device, with the hand feeling tissue: the time to zero force, and
// the reports. docs/safety.md has these times.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/simulation/real_time_guard.h"
#include "tests/simulation/safety_rig.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::haptics;
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

struct InjectedFault {
  std::string name;
  GuardReason reason;                      // the event that must come
  int longest;                             // ms of force after it
  std::function<void(SafetyRig&)> inject;  // once
};

InjectedFault reported(DeviceFault fault) {
  std::string name = "device_says_" + std::string(text_of(fault));
  for (char& letter : name) letter = letter == ' ' ? '_' : letter;
  return {name, GuardReason::device_fault, 1,
          [fault](SafetyRig& rig) { rig.spoil = [fault](DeviceState& device) { device.fault = fault; }; }};
}

InjectedFault pose(const char* name, GuardReason reason, int longest, std::function<void(DeviceState&)> spoil) {
  return {name, reason, longest, [spoil](SafetyRig& rig) { rig.spoil = spoil; }};
}

InjectedFault simulation(const char* name, GuardReason reason, int longest,
                         std::function<Control(const ControlInput&)> controller) {
  return {name, reason, longest, [controller](SafetyRig& rig) { rig.controller = controller; }};
}

std::vector<InjectedFault> all_faults() {
  std::vector<InjectedFault> faults;
  for (int code = 1; code <= static_cast<int>(DeviceFault::vendor_error); ++code) {
    faults.push_back(reported(static_cast<DeviceFault>(code)));
  }
  faults.push_back(pose("position_is_no_number", GuardReason::bad_pose, 1,
                        [](DeviceState& device) { device.hand.translation().x() = not_a_number; }));
  faults.push_back(pose("position_is_infinite", GuardReason::bad_pose, 1,
                        [](DeviceState& device) { device.hand.translation().x() = infinite; }));
  faults.push_back(pose("rotation_is_garbage", GuardReason::bad_pose, 1,
                        [](DeviceState& device) { device.hand.linear() = Mat3::Constant(7.0); }));
  faults.push_back(pose("position_jumps", GuardReason::jump, 1,
                        [](DeviceState& device) { device.hand.translation().x() += 30.0; }));
  faults.push_back(
      pose("hand_is_let_go", GuardReason::released, 20, [](DeviceState& device) { device.held = false; }));
  faults.push_back(pose("velocity_is_too_high", GuardReason::too_fast, 3,
                        [](DeviceState& device) { device.velocity = Vec3(1500.0, 0.0, 0.0); }));
  faults.push_back({"readings_freeze", GuardReason::frozen, 521, [](SafetyRig& rig) {
                      const Pose last = rig.device.hand;
                      rig.spoil = [last](DeviceState& device) { device.hand = last; };
                    }});
  faults.push_back(simulation("force_is_no_number", GuardReason::not_finite, 20, [](const ControlInput&) {
    return Control{{Vec3(not_a_number, 0.0, 0.0), Vec3::Zero()}, 0.0};
  }));
  faults.push_back(simulation("force_is_infinite", GuardReason::not_finite, 20, [](const ControlInput&) {
    return Control{{Vec3(0.0, -infinite, 0.0), Vec3::Zero()}, 0.0};
  }));
  faults.push_back(simulation("torque_is_no_number", GuardReason::not_finite, 20, [](const ControlInput&) {
    return Control{{Vec3::Zero(), Vec3(0.0, 0.0, not_a_number)}, 0.0};
  }));
  faults.push_back(simulation("simulation_throws", GuardReason::controller_failed, 20,
                              [](const ControlInput&) -> Control { throw std::runtime_error("broken"); }));
  faults.push_back(
      simulation("simulation_stops", GuardReason::stale_fault, 46, [age = 0.0](const ControlInput&) mutable {
        age += 0.001;
        return Control{{Vec3(0.0, 0.0, -2.0), Vec3::Zero()}, age};
      }));
  faults.push_back(
      {"nobody_wants_it_any_more", GuardReason::disarmed, 20, [](SafetyRig& rig) { rig.servo->disarm(); }});
  return faults;
}

const DeviceProfile& device_named(const std::string& name) {
  static const auto devices = devices_with_force();
  return *find_profile(devices, name);
}

// 25 mm deep in muscle, held by a spring of friction, feeling more than half a newton.
void push_in(SafetyRig& rig) {
  ASSERT_TRUE(rig.arm(true));
  rig.hand.hand_stiffness = 0.5;
  for (int i = 0; i < 1000 && rig.applied.force.norm() < 0.6; ++i) {
    rig.aim(-5.0 + 0.03 * i);
    ASSERT_TRUE(rig.run(1));
  }
  ASSERT_GE(rig.applied.force.norm(), 0.6);
  rig.counts.fill(0);
}

class Faults : public testing::TestWithParam<InjectedFault> {};

TEST_P(Faults, end_the_force_in_time_and_are_told) {
  const InjectedFault& fault = GetParam();
  int slowest = 0;
  for (const char* device : {"Touch", "Phantom Premium 1.5", "omega.3", "Virtuose 6D Desktop"}) {
    SafetyRig rig(all_resistances().front(), all_constraints().front(), device_named(device), 5);
    push_in(rig);
    const double before = rig.applied.force.norm();
    fault.inject(rig);
    int ticks = 0;
    while (ticks < 2000) {
      ++ticks;
      ASSERT_TRUE(rig.run(1)) << device;
      EXPECT_LE(rig.applied.force.norm(), std::max(before, 3.0) + 1e-9) << device;
      if (rig.applied.force.isZero(0.0) && rig.applied.torque.isZero(0.0)) break;
    }
    EXPECT_LE(ticks, fault.longest) << device;
    slowest = std::max(slowest, ticks);
    for (int i = 0; i < 200; ++i) {  // and stays there
      ASSERT_TRUE(rig.run(1));
      EXPECT_TRUE(rig.applied.force.isZero(0.0)) << device;
    }
    EXPECT_EQ(rig.count(fault.reason), 1) << device;
    EXPECT_EQ(rig.state(), fault.reason == GuardReason::released || fault.reason == GuardReason::disarmed
                               ? GuardState::disarmed
                               : GuardState::faulted);
    if (rig.state() == GuardState::faulted) {
      const FaultReport& report = rig.servo->fault_report();
      EXPECT_EQ(report.fault.reason, fault.reason);
      EXPECT_EQ(report.count, 200u);
    }
    // A lost device can return, with a new arming.
    rig.spoil = nullptr;
    rig.controller = nullptr;
    rig.device = DeviceState{};
    rig.hand.position = Vec3(0.0, 0.0, SafetyRig::middle + 5.0);
    ASSERT_TRUE(rig.arm(true));
    EXPECT_EQ(rig.state(), GuardState::active) << device;
  }
  if (std::getenv("BODKIN_CAMPAIGN_TICKS") != nullptr)
    std::printf("%s: zero after %d ms\n", fault.name.c_str(), slowest);
}

std::string name_of_fault(const testing::TestParamInfo<InjectedFault>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Safety, Faults, testing::ValuesIn(all_faults()), name_of_fault);

TEST(SafetyFaults, a_gap_between_ticks_starts_again_from_zero_and_late_ticks_make_no_steps) {
  SafetyRig rig(all_resistances().front(), all_constraints().front(), device_named("Touch"), 5);
  push_in(rig);
  for (const double period : {0.003, 0.010, 0.020, 0.049}) {  // late, but not too late
    const double before = rig.applied.force.norm();
    rig.tick(period);
    EXPECT_TRUE(rig.is_safe()) << period;
    EXPECT_LE(rig.applied.force.norm(), before + 1.0 + 1e-9);
    ASSERT_TRUE(rig.run(50));
  }
  EXPECT_EQ(rig.count(GuardReason::tick_gap), 0);
  rig.tick(0.060);
  EXPECT_LT(rig.applied.force.norm(), 0.01);
  EXPECT_EQ(rig.count(GuardReason::tick_gap), 1);
  EXPECT_EQ(rig.state(), GuardState::ramping);
  for (int i = 0; i < 200; ++i) {  // a burst of late ticks
    rig.tick(i % 3 == 0 ? 0.012 : 0.001);
    ASSERT_TRUE(rig.is_safe());
  }
}

TEST(SafetyFaults, hot_motors_get_less_and_then_nothing) {
  SafetyRig rig(all_resistances().front(), all_constraints().front(), device_named("Touch"), 5);
  push_in(rig);
  rig.spoil = [heat = 0.7](DeviceState& device) mutable {
    heat = std::min(1.0, heat + 0.002);
    device.temperature = heat;
  };
  ASSERT_TRUE(rig.run(151));
  EXPECT_TRUE(rig.applied.force.isZero(1e-12));
  EXPECT_EQ(rig.count(GuardReason::hot), 1);
}

// Servo, workspace, tissue, guard, snapshot, events and fault report, through arming, puncture, fault and command.
TEST(SafetyFaults, the_whole_servo_allocates_nothing_and_locks_nothing) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer owns malloc and the locks in this build";
  SafetyRig rig(all_resistances().front(), all_constraints().front(), device_named("Touch"), 5);
  std::size_t heap = 1, locks = 1;
  {
    const RealTimeGuard guard;
    rig.arm(true);
    for (int i = 0; i < 3000; ++i) {
      rig.aim(-5.0 + 0.02 * i);
      if (i == 1000) rig.servo->command({.kind = ServoCommand::Kind::freeze});
      if (i == 1200) rig.servo->command({.kind = ServoCommand::Kind::unfreeze});
      if (i == 1400) rig.servo->command({.kind = ServoCommand::Kind::move_body, .middle = Vec3(0.0, 0.0, 22.0)});
      rig.tick();
      if (i == 2500) rig.device.fault = DeviceFault::overheated;
      rig.servo->timings();
    }
    heap = RealTimeGuard::heap_calls();
    locks = RealTimeGuard::lock_calls();
  }
  EXPECT_EQ(heap, 0u);
  EXPECT_EQ(locks, 0u);
  EXPECT_EQ(rig.count(GuardReason::armed), 1);
  EXPECT_EQ(rig.count(GuardReason::device_fault), 1);
}

}  // namespace
}  // namespace bodkin
