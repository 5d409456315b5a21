// A device with its whole servo, on the mocks of the vendors' libraries: for any owner of the loop, no force
// before arming, none after a stop or a fault.
#include "haptics/device_servo.h"

#include <atomic>
#include <chrono>
#include <fstream>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "tests/haptics/driver_rig.h"
#include "tests/sanitized.h"
#include <gtest/gtest.h>
#include <sched.h>

namespace bodkin {

using namespace bodkin::haptics;

namespace {

using mock::Trouble;

class DeviceServoOf : public testing::TestWithParam<DriverSubject> {
 protected:
  DeviceServoOf() {
    board().clear();
    for (int i = 0; i < 3; ++i) board().hand[static_cast<std::size_t>(i)] = GetParam().origin_vendor[i];
    DevicePort port(*GetParam().driver, "", GetParam().words());
    const DeviceAbilities known = port.abilities();
    servo_ = std::make_unique<DeviceServo>(std::move(port), known, ServoSettings{}, [this](const ControlInput&) {
      Control control;
      if (pull_) control.wrench.force = Vec3(0.0, 0.0, 1.0);
      return control;
    });
  }
  ~DeviceServoOf() override {
    servo_.reset();
    EXPECT_EQ(board().violations.load(), 0) << board().first_violation.load();
    EXPECT_EQ(board().open_devices.load(), 0);
    board().clear();
  }

  mock::Board& board() const { return GetParam().board(); }
  double force() const { return Vec3(board().force[0], board().force[1], board().force[2]).norm(); }
  // Arms repeatedly until the force has ramped up: a busy machine may miss the rest that arming requires.
  bool comes_to_pull() {
    return comes_true([&] {
      const GuardState state = servo_->tick().snapshot().state;
      if (state == GuardState::disarmed || state == GuardState::faulted) {
        pull_ = false;
        servo_->tick().command({.kind = ServoCommand::Kind::arm});
      } else {
        pull_ = true;
      }
      return force() > 0.5;
    });
  }

  std::atomic<bool> pull_{false};
  std::unique_ptr<DeviceServo> servo_;
};

TEST_P(DeviceServoOf, pulls_only_between_arming_and_stopping) {
  servo_->start();
  pull_ = true;
  ASSERT_TRUE(comes_true([&] { return servo_->rounds() > 50; }));
  EXPECT_EQ(board().pushes.load(), 0) << "nobody has armed";
  pull_ = false;
  ASSERT_TRUE(comes_to_pull());
  EXPECT_TRUE(servo_->stop());
  EXPECT_EQ(force(), 0.0);
  EXPECT_FALSE(board().motors_on.load());
}

// kB
long locked_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmLck:")) return std::stol(line.substr(6));
  }
  return -1;
}

std::atomic<int> policy_of_the_loop{-1};

// Also where the loop is the vendor's.
TEST_P(DeviceServoOf, runs_ahead_of_other_programs_in_memory_that_stays) {
  if (!real_time_refusals().empty()) GTEST_SKIP() << real_time_refusals().front();
  policy_of_the_loop = -1;
  board().after_callback = [] { policy_of_the_loop = sched_getscheduler(0); };
  servo_->start();
  ASSERT_TRUE(comes_true([&] { return servo_->rounds() > 20; }));
  if (!sanitized) {  // a sanitizer lets no memory be locked
    EXPECT_GT(locked_memory(), 1000);
  }
  if (servo_->own_delay() == 0.0) {
    EXPECT_EQ(policy_of_the_loop, SCHED_FIFO);
  }
  EXPECT_TRUE(servo_->stop());
  EXPECT_EQ(locked_memory(), 0);
}

TEST_P(DeviceServoOf, a_fault_of_the_device_ends_the_force_and_is_told) {
  servo_->start();
  ASSERT_TRUE(comes_to_pull());
  board().trouble = Trouble::unplug;
  ASSERT_TRUE(comes_true([&] { return servo_->tick().snapshot().state == GuardState::faulted; }));
  EXPECT_TRUE(comes_true([&] { return force() == 0.0; }));
  EXPECT_TRUE(servo_->tick().snapshot().applied.force.isZero());
  board().trouble = Trouble::none;
  servo_->stop();
}

// A device at rest in our loop: it records the force of each round, and hangs on request.
struct QuietDevice {
  std::mutex mutex;
  std::vector<double> forces;  // N
  std::atomic<bool> hangs{false};

  std::vector<double> kept() {
    const std::scoped_lock lock(mutex);
    return forces;
  }
};

QuietDevice* quiet_device = nullptr;

const bodkin_driver quiet_driver = {BODKIN_DRIVER_ABI,
                                    "quiet",
                                    "for tests",
                                    [](const char*, bodkin_found, void*, char*) { return int{BODKIN_OK}; },
                                    [](const char*, const char*, void** handle, bodkin_abilities* abilities, char*) {
                                      *handle = quiet_device;
                                      abilities->peak_force = 10.0;
                                      abilities->continuous_force = 5.0;
                                      return int{BODKIN_OK};
                                    },
                                    [](void*, bodkin_tick, void*, char*) { return int{BODKIN_OK}; },
                                    [](void* handle, const bodkin_command* command, bodkin_state* state) {
                                      auto& device = *static_cast<QuietDevice*>(handle);
                                      while (device.hangs) std::this_thread::sleep_for(std::chrono::milliseconds(1));
                                      const std::scoped_lock lock(device.mutex);
                                      device.forces.push_back(Vec3(command->force).norm());
                                      for (const int i : {0, 4, 8}) state->rotation[i] = 1.0;
                                      state->held = 1;
                                      return int{BODKIN_OK};
                                    },
                                    [](void*) { return int{BODKIN_OK}; },
                                    [](void*) {},
                                    nullptr};

class StoppedServo : public testing::Test {
 protected:
  StoppedServo() { quiet_device = &device_; }
  ~StoppedServo() override {
    device_.hangs = false;
    servo_.reset();
    comes_true([this] { return left_.expired(); });  // a loop that was left behind comes back and ends
  }

  // Its force has ramped up when this returns.
  void start() {
    device_.forces.clear();
    left_.reset();
    const auto life = std::make_shared<int>(0);
    left_ = life;
    DevicePort port(quiet_driver, "", "");
    const DeviceAbilities known = port.abilities();
    auto pull = std::make_shared<std::atomic<bool>>(false);
    ServoSettings settings;
    settings.guard.frozen_time = 0.0;
    servo_ = std::make_unique<DeviceServo>(std::move(port), known, settings, [pull, life](const ControlInput& input) {
      Control control;
      *pull = input.guard == GuardState::ramping || input.guard == GuardState::active;
      if (*pull) control.wrench.force = Vec3(0.0, 0.0, 4.0);
      return control;
    });
    servo_->start();
    ASSERT_TRUE(comes_true([&] {
      const GuardState state = servo_->tick().snapshot().state;
      if (state == GuardState::disarmed || state == GuardState::faulted)
        servo_->tick().command({.kind = ServoCommand::Kind::arm});
      const std::vector<double> forces = device_.kept();
      return !forces.empty() && forces.back() > 2.0;
    }));
  }

  // Rounds in which the force was smaller than in the one before and not yet zero, at the end of the session.
  std::size_t falling_rounds() {
    const std::vector<double> forces = device_.kept();
    std::size_t end = forces.size(), count = 0;
    while (end > 0 && forces[end - 1] == 0.0) --end;
    while (end > 1 && forces[end - 1] < forces[end - 2]) {
      --end;
      ++count;
    }
    return count;
  }

  QuietDevice device_;
  std::weak_ptr<int> left_;  // lives as long as the controller
  std::unique_ptr<DeviceServo> servo_;
};

TEST_F(StoppedServo, ramps_the_force_to_zero) {
  // A busy machine may hold up the loop for longer than the whole ramp takes.
  std::size_t falling = 0;
  for (int attempt = 0; attempt < 10 && falling < 10; ++attempt) {
    ASSERT_NO_FATAL_FAILURE(start());
    EXPECT_TRUE(servo_->stop());
    falling = falling_rounds();
    EXPECT_EQ(device_.kept().back(), 0.0);
  }
  EXPECT_GE(falling, 10U);
}

TEST_F(StoppedServo, does_not_wait_for_a_ramp_that_no_tick_drives) {
  ASSERT_NO_FATAL_FAILURE(start());
  device_.hangs = true;
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(servo_->stop());
  // 0.04 s for the ticks, half a second for the exchange; the rest is for a busy machine.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

// An inkwell, or a Desktop that refines its calibration, moves the pose while the force is on.
TEST_P(DeviceServoOf, a_calibration_that_moves_the_pose_brings_the_force_in_anew) {
  if (GetParam().name != "openhaptics") GTEST_SKIP() << "this vendor's servo is not calibrated while it runs";
  servo_->start();
  ASSERT_TRUE(comes_to_pull());
  const int before = board().calibrations;
  board().calibration_shift = 8.0;  // mm
  board().trouble = Trouble::needs_update;
  bool faulted = false, went_to_zero = false, came_back = false;
  comes_true([&] {
    faulted = faulted || servo_->tick().snapshot().state == GuardState::faulted;
    went_to_zero = went_to_zero || (board().calibrations > before && force() < 0.05);
    came_back = went_to_zero && force() > 0.5;
    return faulted || came_back;
  });
  EXPECT_FALSE(faulted) << text_of(servo_->tick().snapshot().fault);
  EXPECT_TRUE(came_back);
  board().trouble = Trouble::none;
}

INSTANTIATE_TEST_SUITE_P(EveryDriver, DeviceServoOf, testing::ValuesIn(driver_subjects()),
                         [](const auto& subject) { return subject.param.name; });

}  // namespace
}  // namespace bodkin
