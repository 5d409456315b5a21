#include "haptics/servo_tick.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

// Time controlled by the test.
struct VirtualTime {
  std::int64_t now = 0;   // ns
  std::int64_t cost = 0;  // ns that pass with each look
  TickClock clock() { return {&look, this}; }
  static std::int64_t look(void* user) noexcept {
    auto* time = static_cast<VirtualTime*>(user);
    return time->now += time->cost;
  }
};

ServoSettings servo_settings() {
  ServoSettings made;
  made.guard.peak_force = 10.0;
  made.guard.continuous_force = 4.0;
  made.guard.peak_torque = 200.0;
  return made;
}

// A wall below z = 0 of 0.5 N/mm.
Control wall(const ControlInput& input) {
  Control control;
  control.wrench.force.z() = std::max(0.0, -0.5 * input.needle.translation().z());
  return control;
}

class Servo {
 public:
  explicit Servo(const ServoSettings& with = servo_settings(), Controller controller = wall)
      : tick(std::make_unique<ServoTick>(with, std::move(controller), time.clock())) {}

  Wrench step(double dt = 0.001) {
    device.hand.translation().x() = ++ticks % 2 == 0 ? 1e-6 : 0.0;  // alive
    const Wrench wrench = tick->step(device, dt);
    GuardEvent event;
    while (tick->next_event(event)) events.push_back(event);
    return wrench;
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) step();
  }
  void command(ServoCommand::Kind kind) { EXPECT_TRUE(tick->command({.kind = kind})); }
  // Armed at z = 0, then 4 mm into the wall.
  void into_the_wall() {
    steps(60);
    command(ServoCommand::Kind::arm);
    steps(1100);
    for (int i = 0; i < 40; ++i) {
      device.hand.translation().z() -= 0.1;
      step();
    }
  }
  bool happened(GuardReason reason) const {
    return std::any_of(events.begin(), events.end(), [&](const GuardEvent& event) { return event.reason == reason; });
  }

  VirtualTime time;
  std::unique_ptr<ServoTick> tick;
  DeviceState device;
  std::vector<GuardEvent> events;
  int ticks = 0;
};

TEST(ServoTick, gives_no_force_before_it_is_armed_and_the_controllers_afterwards) {
  Servo servo;
  servo.device.hand.translation().z() = 0.0;
  servo.steps(100);
  servo.into_the_wall();
  EXPECT_NEAR(servo.step().force.z(), 2.0, 1e-9);
  EXPECT_TRUE(servo.happened(GuardReason::armed));
  EXPECT_TRUE(servo.happened(GuardReason::full_force));
}

TEST(ServoTick, shows_the_newest_tick) {
  Servo servo;
  servo.into_the_wall();
  const ServoSnapshot& snapshot = servo.tick->snapshot();
  EXPECT_EQ(snapshot.tick, 1199u);
  EXPECT_NEAR(snapshot.time, 1.2, 1e-9);
  EXPECT_EQ(snapshot.state, GuardState::active);
  EXPECT_NEAR(snapshot.wanted.force.z(), 2.0, 1e-9);
  EXPECT_NEAR(snapshot.applied.force.z(), 2.0, 1e-9);
  EXPECT_NEAR(snapshot.needle.translation().z(), -4.0, 1e-9);
}

TEST(ServoTick, carries_the_handle_whatever_the_needle_feels_and_counts_it_as_no_energy) {
  ServoSettings with = servo_settings();
  with.weight = 0.7;
  Servo servo(with);
  servo.device.hand.translation().z() = 0.0;
  servo.steps(100);
  EXPECT_TRUE(servo.step().force.isZero(0.0)) << "not before it is armed";
  servo.into_the_wall();
  EXPECT_NEAR(servo.step().force.z(), 2.7, 1e-9);
  EXPECT_NEAR(servo.tick->snapshot().energy.z(), 0.5 * 0.5 * 4.0 * 4.0, 0.11)
      << "of the wall's spring alone, half a tick late";
  servo.command(ServoCommand::Kind::freeze);
  EXPECT_NEAR(servo.step().force.z(), 0.7, 1e-9);
  with.weight = 6.0;
  EXPECT_THROW(Servo{with}, InputError);
}

TEST(ServoTick, a_frozen_needle_is_not_felt_and_comes_back_slowly) {
  Servo servo;
  servo.into_the_wall();
  servo.command(ServoCommand::Kind::freeze);
  EXPECT_TRUE(servo.step().force.isZero(0.0));
  for (int i = 0; i < 200; ++i) {
    servo.device.hand.translation().z() += 0.1;  // the hand goes 20 mm away
    servo.step();
  }
  EXPECT_NEAR(servo.tick->snapshot().needle.translation().z(), -4.0, 1e-9);
  EXPECT_NEAR(servo.tick->snapshot().wanted.force.z(), 2.0, 1e-9) << "the tissue still holds it";
  servo.command(ServoCommand::Kind::unfreeze);
  EXPECT_NEAR(servo.step().force.z(), 2.0 * 0.001 / 0.25, 1e-9);
  servo.steps(124);
  EXPECT_NEAR(servo.tick->snapshot().applied.force.z(), 1.0, 1e-6);
  servo.steps(200);
  EXPECT_NEAR(servo.tick->snapshot().applied.force.z(), 2.0, 1e-6);
  EXPECT_NEAR(servo.tick->snapshot().needle.translation().z(), -4.0, 1e-9);
}

TEST(ServoTick, buttons_clutch_and_freeze_and_their_bounces_do_not_count) {
  ServoSettings with = servo_settings();
  with.clutch_button = 0;
  with.freeze_button = 3;
  Servo servo(with);
  for (int i = 0; i < 30; ++i) {  // bouncing
    servo.device.buttons ^= 1U;
    servo.steps(5);
  }
  EXPECT_FALSE(servo.tick->snapshot().clutched);
  servo.device.buttons = 1U;
  servo.steps(25);
  EXPECT_TRUE(servo.tick->snapshot().clutched);
  servo.device.buttons = 0U;
  servo.steps(25);
  EXPECT_FALSE(servo.tick->snapshot().clutched);
  for (const bool frozen : {true, false}) {
    servo.device.buttons = 8U;
    servo.steps(25);
    servo.device.buttons = 0U;
    servo.steps(25);
    EXPECT_EQ(servo.tick->snapshot().frozen, frozen);
  }
}

TEST(ServoTick, a_button_can_be_the_dead_mans_switch) {
  ServoSettings with = servo_settings();
  with.dead_man_button = 1;
  Servo servo(with);
  servo.device.buttons = 2U;
  servo.into_the_wall();
  EXPECT_NEAR(servo.step().force.z(), 2.0, 1e-9);
  servo.device.buttons = 0U;
  servo.steps(20);
  EXPECT_TRUE(servo.tick->snapshot().applied.force.isZero(0.0));
  EXPECT_TRUE(servo.happened(GuardReason::released));
}

TEST(ServoTick, disarm_comes_after_every_waiting_arm_and_needs_no_place_in_the_queue) {
  Servo servo;
  servo.into_the_wall();
  while (servo.tick->command({.kind = ServoCommand::Kind::arm})) {
  }
  servo.tick->disarm();
  servo.steps(20);
  EXPECT_EQ(servo.tick->snapshot().state, GuardState::disarmed);
  EXPECT_TRUE(servo.tick->snapshot().applied.force.isZero(0.0));
  servo.device.hand.translation().z() = 0.0;
  servo.steps(3000);
  EXPECT_EQ(servo.tick->snapshot().state, GuardState::disarmed);
}

TEST(ServoTick, a_controller_that_throws_ends_the_force_and_rests_until_it_is_armed_again) {
  int calls = 0;
  bool bad = false;
  Servo servo(servo_settings(), [&](const ControlInput& input) {
    ++calls;
    if (bad) throw std::runtime_error("no tissue");
    return wall(input);
  });
  servo.into_the_wall();
  bad = true;
  const int before = calls;
  servo.steps(20);
  EXPECT_EQ(calls, before + 1);
  EXPECT_TRUE(servo.tick->snapshot().applied.force.isZero(0.0));
  EXPECT_EQ(servo.tick->snapshot().fault, GuardReason::controller_failed);
  bad = false;
  servo.device.hand.translation().z() = 0.0;
  servo.into_the_wall();
  EXPECT_NEAR(servo.step().force.z(), 2.0, 1e-9);
}

TEST(ServoTick, a_pose_that_is_no_number_never_reaches_the_controller) {
  bool finite = true;
  Servo servo(servo_settings(), [&](const ControlInput& input) {
    finite = finite && input.needle.matrix().allFinite();
    return wall(input);
  });
  servo.into_the_wall();
  servo.device.hand.translation().y() = std::nan("");
  EXPECT_TRUE(servo.step().force.isZero(0.0));
  servo.steps(10);
  EXPECT_TRUE(finite);
  EXPECT_EQ(servo.tick->snapshot().fault, GuardReason::bad_pose);
}

TEST(ServoTick, a_fault_comes_with_the_last_two_hundred_ticks) {
  Servo servo;
  EXPECT_EQ(servo.tick->fault_report().count, 0u);
  servo.into_the_wall();
  servo.device.fault = DeviceFault::communication_lost;
  servo.step();
  servo.device.fault = DeviceFault::none;
  servo.steps(300);
  const FaultReport& report = servo.tick->fault_report();
  ASSERT_EQ(report.count, 200u);
  EXPECT_EQ(report.fault.reason, GuardReason::device_fault);
  EXPECT_EQ(report.ticks.back().fault, DeviceFault::communication_lost);
  EXPECT_EQ(report.ticks.back().applied, Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(report.ticks.back().tick, 1200u);
  EXPECT_NEAR(report.ticks[198].applied.z(), 2.0, 1e-9);
  for (std::size_t i = 1; i < report.count; ++i) EXPECT_EQ(report.ticks[i].tick, report.ticks[i - 1].tick + 1);
}

TEST(ServoTick, counts_what_is_late_and_what_takes_too_long) {
  Servo servo;
  servo.steps(99);
  servo.step(0.0025);
  EXPECT_EQ(servo.tick->timings().ticks, 100u);
  EXPECT_EQ(servo.tick->timings().overruns, 1u);
  EXPECT_NEAR(servo.tick->timings().recent_success, 0.99, 1e-12);
  EXPECT_NEAR(servo.tick->timings().lateness.maximum(), 0.0015, 1e-12);

  servo.time.cost = 600'000;  // three looks at the clock: 1.2 ms in all
  servo.steps(100);
  EXPECT_EQ(servo.tick->timings().overruns, 101u);
  EXPECT_EQ(servo.tick->timings().recent_success, 0.0);
  EXPECT_NEAR(servo.tick->timings().compute.maximum(), 0.0012, 1e-12);
}

TEST(ServoTick, a_lateness_that_the_caller_knows_counts_instead) {
  Servo servo;
  for (int i = 0; i < 100; ++i) servo.tick->step(servo.device, 0.001, 0.0003);
  EXPECT_NEAR(servo.tick->timings().lateness.maximum(), 0.0003, 1e-12);
  EXPECT_EQ(servo.tick->timings().overruns, 0u);
}

TEST(ServoTick, a_servo_without_controller_or_at_an_impossible_rate_is_refused) {
  EXPECT_THROW(ServoTick(servo_settings(), Controller()), InputError);
  ServoSettings slow = servo_settings();
  slow.rate = 30.0;
  EXPECT_THROW(ServoTick(slow, wall), InputError);
}

// For ThreadSanitizer: commands, snapshots, events, timings and reports beside a running tick.
TEST(ServoTick, one_thread_ticks_while_another_commands_and_looks) {
  const auto tick = std::make_unique<ServoTick>(servo_settings(), wall);
  std::atomic<bool> done{false};
  std::thread servo([&] {
    DeviceState device;
    for (int i = 0; i < 20000; ++i) {
      device.hand.translation() = Vec3(1e-6 * (i % 2), 0.0, i % 4000 < 2000 ? 0.0 : -2.0);
      device.fault = i % 5000 == 4999 ? DeviceFault::overheated : DeviceFault::none;
      tick->step(device, 0.001);
    }
    done = true;
  });
  std::uint64_t last = 0;
  bool ordered = true;
  std::size_t events = 0;
  while (!done) {
    tick->command({.kind = ServoCommand::Kind::arm});
    const ServoSnapshot& snapshot = tick->snapshot();
    ordered = ordered && snapshot.tick >= last && snapshot.applied.force.allFinite();
    last = snapshot.tick;
    ordered = ordered && tick->timings().ticks <= 20000 && tick->fault_report().count <= FaultReport::most;
    GuardEvent event;
    while (tick->next_event(event)) ++events;
    std::this_thread::yield();
  }
  servo.join();
  EXPECT_TRUE(ordered);
  EXPECT_EQ(tick->snapshot().tick, 19999u);
  GuardEvent event;
  while (tick->next_event(event)) ++events;
  EXPECT_GT(events, 0u);
}

}  // namespace
}  // namespace bodkin
