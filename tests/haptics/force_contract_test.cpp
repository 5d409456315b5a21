// Requirements of every driver of a device with motors in addition to driver_contract.cpp, proved on a mock of
// its vendor's library or service (docs/devices.md).
#include <optional>

#include "tests/haptics/driver_rig.h"
#include "tests/simulation/real_time_guard.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::haptics;

namespace {

using namespace std::chrono_literals;
using mock::Trouble;
using testing::HasSubstr;

constexpr int longest_push = 12;  // ms of the device's time from a fault to zero force (docs/devices.md)

class ForceContract : public testing::TestWithParam<DriverSubject> {
 protected:
  ForceContract() { reset(); }
  ~ForceContract() override {
    EXPECT_EQ(board().violations.load(), 0) << board().first_violation.load();
    EXPECT_EQ(board().open_devices.load(), 0);
    EXPECT_FALSE(board().motors_on.load());
    board().clear();
  }

  const DriverSubject& subject() const { return GetParam(); }
  mock::Board& board() const { return subject().board(); }

  void reset() const {
    board().clear();
    place(subject().origin_vendor);
  }
  void place(const Vec3& at) const {
    for (int i = 0; i < 3; ++i) board().hand[static_cast<std::size_t>(i)] = at[i];
  }
  void turn(const Mat3& rotation) const {
    for (int i = 0; i < 9; ++i) board().turn[static_cast<std::size_t>(i)] = rotation(i / 3, i % 3);
  }
  static Vec3 read(const std::array<std::atomic<double>, 3>& triple) { return {triple[0], triple[1], triple[2]}; }
  bool at_rest() const { return read(board().force).isZero() && read(board().torque).isZero(); }
  bool feels(const Vec3& force) const { return (read(board().force) - force).norm() < 1e-6; }

  DeviceFault fault_of_opening(const std::string& words) const {
    try {
      const DevicePort port(*subject().driver, "", words);
    } catch (const DeviceError& error) {
      reported_ = error.what();
      EXPECT_THAT(reported_, HasSubstr(std::string(subject().driver->name) + ": "));
      EXPECT_GT(reported_.size(), 40u) << "one sentence that says what to do";
      return error.fault();
    }
    return DeviceFault::none;
  }

  mutable std::string reported_;
};

TEST_P(ForceContract, finds_the_device_and_leaves_it_alone) {
  const auto found = list_devices(*subject().driver, subject().words());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found.front().title.empty());
  EXPECT_FALSE(board().motors_on);
  EXPECT_EQ(board().open_devices, 0);
  const DevicePort port(*subject().driver, found.front().identity, subject().words());
  EXPECT_EQ(board().open_devices, 1);
}

TEST_P(ForceContract, knows_what_the_device_can_do) {
  const DriverRig rig(subject());
  const DeviceAbilities& abilities = const_cast<DriverRig&>(rig).port().abilities();
  EXPECT_FALSE(abilities.name.empty());
  EXPECT_GT(abilities.peak_force, 1.0);
  EXPECT_LT(abilities.peak_force, 50.0);
  EXPECT_GT(abilities.stiffness, 0.1);  // N/mm, not N/m
  EXPECT_LT(abilities.stiffness, 20.0);
  EXPECT_GT(abilities.delay, 0.0);
  EXPECT_LE(abilities.delay, 0.003);  // s, not ms
  EXPECT_FALSE(abilities.delay_source.empty());
  EXPECT_TRUE(abilities.measures_rotation);
  EXPECT_GT((abilities.workspace_high - abilities.workspace_low).minCoeff(), 50.0);
  EXPECT_NEAR((abilities.workspace_high + abilities.workspace_low).norm(), 0.0, 1e-9);
}

TEST_P(ForceContract, there_is_no_force_before_the_start) {
  DriverRig rig(subject());
  rig.push({subject().force, subject().torque});
  std::this_thread::sleep_for(20ms);
  EXPECT_FALSE(board().motors_on);
  EXPECT_EQ(board().pushes, 0);
}

TEST_P(ForceContract, the_start_itself_does_not_push) {
  DriverRig rig(subject());
  rig.start();
  EXPECT_TRUE(rig.ticks(20));
  EXPECT_EQ(board().pushes, 0);
  EXPECT_TRUE(board().motors_on);
}

TEST_P(ForceContract, a_pushed_pose_arrives_in_the_operators_frame_and_millimetres) {
  DriverRig rig(subject());
  rig.start();
  place(subject().pushed_vendor);
  EXPECT_TRUE(comes_true([&] { return (rig.last().hand.translation() - subject().pushed).norm() < 1e-3; }))
      << rig.last().hand.translation().transpose();
}

TEST_P(ForceContract, a_velocity_arrives_in_the_operators_frame) {
  DriverRig rig(subject());
  rig.start();
  EXPECT_TRUE(rig.ticks(3));
  place(subject().pushed_vendor);  // within one millisecond
  const Vec3 expected = subject().pushed * 1000.0;
  EXPECT_TRUE(comes_true([&] { return (rig.fastest() - expected).norm() < 1e-2 * expected.norm(); }))
      << rig.fastest().transpose();
}

TEST_P(ForceContract, a_tool_that_points_away_from_the_operator_has_its_axis_along_y) {
  DriverRig rig(subject());
  rig.start();
  EXPECT_TRUE(comes_true([&] { return needle_axis(rig.last().hand).isApprox(Vec3::UnitY(), 1e-6); }));
  turn(subject().left_vendor);
  EXPECT_TRUE(comes_true([&] { return needle_axis(rig.last().hand).isApprox(-Vec3::UnitX(), 1e-6); }))
      << needle_axis(rig.last().hand).transpose();
}

TEST_P(ForceContract, a_force_reaches_the_motors_in_the_vendors_frame) {
  DriverRig rig(subject());
  rig.push({subject().force, subject().torque});
  rig.start();
  EXPECT_TRUE(comes_true([&] { return feels(subject().force_vendor); })) << read(board().force).transpose();
  if (rig.port().abilities().peak_torque > 0.0) {
    EXPECT_NEAR((read(board().torque) - subject().torque_vendor).norm(), 0.0, 1e-6)
        << read(board().torque).transpose();
  }
}

TEST_P(ForceContract, a_hand_that_holds_loosely_yields_the_way_it_is_pushed) {
  board().firm = false;
  DriverRig rig(subject());
  rig.push({subject().force, Vec3::Zero()});
  rig.start();
  EXPECT_TRUE(rig.ticks(2000));
  // 3.7 N against 0.3 N/mm, less the dry friction of each axis.
  const Vec3 moved = rig.last().hand.translation();
  EXPECT_NEAR((moved - subject().force / 0.3).norm(), 0.0, 0.4) << moved.transpose();
}

TEST_P(ForceContract, buttons_arrive_from_bit_0) {
  DriverRig rig(subject());
  rig.start();
  board().buttons = 2;
  EXPECT_TRUE(comes_true([&] { return rig.last().buttons == 2; }));
}

TEST_P(ForceContract, there_is_no_force_after_the_stop) {
  DriverRig rig(subject());
  rig.push({subject().force, subject().torque});
  rig.start();
  EXPECT_TRUE(comes_true([&] { return feels(subject().force_vendor); }));
  rig.stop();
  EXPECT_TRUE(at_rest());
  EXPECT_FALSE(board().motors_on);
  const auto pushes = board().pushes.load();
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(board().pushes, pushes);
}

TEST_P(ForceContract, there_is_no_force_after_the_device_is_gone) {
  {
    DriverRig rig(subject());
    rig.push({subject().force, subject().torque});
    rig.start();
    EXPECT_TRUE(comes_true([&] { return feels(subject().force_vendor); }));
  }
  EXPECT_TRUE(at_rest());
  EXPECT_FALSE(board().motors_on);
}

TEST_P(ForceContract, starts_again_after_a_stop_and_opens_again_after_a_close) {
  for (int opening = 0; opening < 3; ++opening) {
    DriverRig rig(subject());
    rig.push({subject().force, Vec3::Zero()});
    for (int start = 0; start < 2; ++start) {
      rig.start();
      EXPECT_TRUE(comes_true([&] { return feels(subject().force_vendor); }));
      rig.stop();
    }
  }
}

TEST_P(ForceContract, software_of_the_vendors_that_is_not_there_is_not_installed) {
  EXPECT_EQ(fault_of_opening(subject().absent), DeviceFault::not_installed);
  for (const std::string& words : subject().absent_message) EXPECT_THAT(reported_, HasSubstr(words));
}

TEST_P(ForceContract, software_of_the_vendors_that_does_not_fit_is_told_with_what_is_wrong) {
  EXPECT_EQ(fault_of_opening(subject().unfit), DeviceFault::wrong_version);
  for (const std::string& words : subject().unfit_message) EXPECT_THAT(reported_, HasSubstr(words));
}

TEST_P(ForceContract, a_setting_that_it_does_not_know_is_refused) {
  EXPECT_THROW(DevicePort(*subject().driver, "", subject().words() + " colour=red"), InputError);
}

TEST_P(ForceContract, a_device_that_cannot_be_opened_says_why) {
  for (const auto& [trouble, fault] : subject().at_open) {
    board().trouble = trouble;
    EXPECT_EQ(text_of(fault_of_opening(subject().words())), text_of(fault)) << reported_;
    EXPECT_EQ(board().open_devices, 0) << text_of(fault);
    board().trouble = Trouble::none;
  }
  EXPECT_EQ(board().pushes, 0);
}

TEST_P(ForceContract, a_fault_in_the_loop_is_reported_and_ends_the_force) {
  for (const auto& [trouble, fault] : subject().in_loop) {
    reset();
    {
      DriverRig rig(subject());
      rig.push({subject().force, subject().torque});
      rig.start();
      ASSERT_TRUE(comes_true([&] { return feels(subject().force_vendor); }));
      board().from_tick = board().ticks + 5;
      board().trouble = trouble;
      EXPECT_TRUE(rig.fault(fault)) << text_of(fault) << " expected, " << text_of(rig.last().fault) << " seen";
      EXPECT_TRUE(comes_true([&] { return at_rest(); })) << text_of(fault);
      const auto pushes = board().pushes.load();
      std::this_thread::sleep_for(10ms);
      EXPECT_EQ(board().pushes, pushes) << text_of(fault);
      EXPECT_LE(board().pushes_in_trouble, longest_push) << text_of(fault);
      if (fault != DeviceFault::bad_data) {
        EXPECT_FALSE(rig.port().explain().empty()) << text_of(fault);
      }
    }
    EXPECT_EQ(board().violations, 0) << text_of(fault) << ": " << board().first_violation.load();
    EXPECT_FALSE(board().motors_on) << text_of(fault);
  }
}

TEST_P(ForceContract, a_hand_that_lets_go_is_noticed) {
  DriverRig rig(subject());
  rig.start();
  EXPECT_TRUE(comes_true([&] { return rig.last().held; }));
  board().trouble = Trouble::hand_off;
  EXPECT_TRUE(comes_true([&] { return !rig.last().held; }));
}

TEST_P(ForceContract, late_replies_are_no_fault) {
  DriverRig rig(subject());
  rig.push({subject().force, Vec3::Zero()});
  board().trouble = Trouble::late;
  rig.start();
  EXPECT_TRUE(rig.ticks(20));
  EXPECT_EQ(rig.last().fault, DeviceFault::none);
  EXPECT_TRUE(feels(subject().force_vendor));
}

TEST_P(ForceContract, a_loop_that_freezes_does_not_hang_the_stop) {
  DriverRig rig(subject());
  rig.start();
  EXPECT_TRUE(rig.ticks(5));
  rig.port().set_patience(100ms);
  board().trouble = Trouble::freeze;
  const auto ticks = [&] { return rig.port().ticks(); };
  EXPECT_TRUE(comes_true([&] {
    const auto before = ticks();
    std::this_thread::sleep_for(20ms);
    return subject().reports_freeze ? rig.last().fault == DeviceFault::communication_lost : ticks() == before;
  })) << "nobody sees the standstill";
  try {
    rig.port().stop();
  } catch (const DeviceError& error) {
    EXPECT_EQ(error.fault(), DeviceFault::communication_lost);
  }
  rig.close();
  board().trouble = Trouble::none;
  EXPECT_TRUE(comes_true([&] { return board().open_devices == 0; }));
}

TEST_P(ForceContract, a_call_of_the_vendors_that_blocks_is_given_up_and_cleaned_up_after) {
  for (const Trouble blocked : {Trouble::open_blocks, Trouble::start_blocks, Trouble::stop_blocks}) {
    const int openings = board().openings;
    try {
      board().trouble = blocked;
      DriverRig rig(subject(), blocked == Trouble::open_blocks ? 100ms : usual_patience);
      if (blocked == Trouble::start_blocks) rig.port().set_patience(100ms);
      rig.start();
      rig.port().set_patience(100ms);
      rig.stop();
      ADD_FAILURE() << "nothing blocked";
    } catch (const DeviceError& error) {
      EXPECT_EQ(error.fault(), DeviceFault::communication_lost) << error.what();
    }
    board().trouble = Trouble::none;
    EXPECT_TRUE(comes_true([&] { return board().openings == openings + 1 && board().open_devices == 0; }));
  }
}

std::optional<RealTimeGuard>& guard() {
  thread_local std::optional<RealTimeGuard> one;
  return one;
}

struct Idle : DeviceTick {
  Wrench tick(const DeviceState&, double) noexcept override { return {Vec3(1, 0, 0), Vec3::Zero()}; }
};

TEST_P(ForceContract, a_tick_allocates_and_locks_nothing) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer owns malloc and the locks in this build";
  static std::atomic<std::size_t> calls, rounds;
  calls = rounds = 0;
  static const auto count = [] {
    guard().reset();
    calls += RealTimeGuard::heap_calls() + RealTimeGuard::lock_calls();
    ++rounds;
  };
  board().before_callback = [] { guard().emplace(); };
  board().after_callback = [] { count(); };
  DevicePort port(*subject().driver, "", subject().words());
  Idle tick;
  port.start(&tick);
  DeviceState state;
  while (!port.abilities().owns_loop && rounds < 50) {
    guard().emplace();
    port.exchange({Vec3(1, 0, 0), Vec3::Zero()}, state);
    count();
  }
  EXPECT_TRUE(comes_true([] { return rounds >= 50; }));
  port.stop();
  EXPECT_EQ(calls, 0u);
}

INSTANTIATE_TEST_SUITE_P(Drivers, ForceContract, testing::ValuesIn(driver_subjects()),
                         [](const auto& subject) { return subject.param.name; });

}  // namespace
}  // namespace bodkin
