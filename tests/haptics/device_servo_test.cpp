// A device with its whole servo, on the stand-ins for the vendors' libraries: whoever owns the loop, no force before
// somebody arms, none after a stop or a fault.
#include "haptics/device_servo.h"

#include <atomic>
#include <memory>

#include "tests/haptics/driver_rig.h"
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::haptics;

namespace {

using stand_in::Trouble;

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

  stand_in::Board& board() const { return GetParam().board(); }
  double force() const { return Vec3(board().force[0], board().force[1], board().force[2]).norm(); }
  // Arms again and again until the force has come in: a busy machine may miss the rest that arming asks for.
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

INSTANTIATE_TEST_SUITE_P(EveryDriver, DeviceServoOf, testing::ValuesIn(driver_subjects()),
                         [](const auto& subject) { return subject.param.name; });

}  // namespace
}  // namespace bodkin
