// The requirements of every driver, for a vendor's device, a plug-in, or Bodkin's own hands (docs/devices.md).
// Compiled into each test program with drivers. Requirements for forces are in force_contract_test.cpp.
#include "tests/haptics/driver_contract.h"

#include <atomic>
#include <chrono>
#include <set>
#include <thread>

#include "tests/haptics/device_loop.h"
#include "tests/simulation/real_time_guard.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::haptics;

void PrintTo(const ContractSubject& subject, std::ostream* to) {
  *to << subject.name;
}

namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

class DriverContract : public testing::TestWithParam<ContractSubject> {
 protected:
  DriverContract() : scene_(GetParam().arrange()) {}
  ~DriverContract() override {
    if (scene_.leave) scene_.leave();
  }

  const bodkin_driver& driver() const { return *GetParam().driver; }
  DevicePort open() const { return {driver(), scene_.identity, scene_.settings}; }

  // The sentence of the refusal; empty if it opens.
  std::string refusal(const std::string& identity, const std::string& settings) const {
    try {
      const DevicePort port(driver(), identity, settings);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  }

  ContractScene scene_;
};

TEST_P(DriverContract, has_a_name_to_type_and_a_line_of_summary) {
  const std::string name = driver().name, summary = driver().summary;
  EXPECT_EQ(driver().abi, BODKIN_DRIVER_ABI);
  EXPECT_FALSE(name.empty());
  EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string::npos) << name;
  EXPECT_GT(summary.size(), 5u);
  EXPECT_EQ(summary.find('\n'), std::string::npos);
}

TEST_P(DriverContract, finds_what_can_be_opened_or_says_why_not) {
  try {
    const auto found = list_devices(driver(), scene_.settings);
    EXPECT_EQ(GetParam().fault_of_listing, DeviceFault::none);
    ASSERT_FALSE(found.empty());
    std::set<std::string> identities;
    for (const FoundDevice& device : found) {
      EXPECT_FALSE(device.title.empty());
      EXPECT_TRUE(identities.insert(device.identity).second) << "two devices are '" << device.identity << "'";
    }
  } catch (const DeviceError& error) {
    EXPECT_EQ(text_of(error.fault()), text_of(GetParam().fault_of_listing)) << error.what();
    EXPECT_GT(std::string(error.what()).size(), 40u) << "one sentence that says what to do";
  }
}

TEST_P(DriverContract, knows_what_the_device_can_do) {
  const DevicePort port = open();
  const DeviceAbilities& can = port.abilities();
  EXPECT_FALSE(can.name.empty());
  EXPECT_EQ(can.peak_force > 0.0, GetParam().renders_force) << can.peak_force;
  EXPECT_GE(can.continuous_force, 0.0);
  EXPECT_LE(can.continuous_force, can.peak_force);
  EXPECT_GE(can.peak_torque, 0.0);
  EXPECT_GE(can.rate, 100.0);
  EXPECT_LE(can.rate, 10000.0);
  EXPECT_GE((can.workspace_high - can.workspace_low).minCoeff(), 0.0);
}

TEST_P(DriverContract, tells_a_sound_pose_in_every_round) {
  DeviceLoop loop(open());
  loop.start();
  ASSERT_TRUE(loop.rounds(20));
  EXPECT_EQ(text_of(loop.last().fault), text_of(DeviceFault::none)) << loop.port().explain();
  EXPECT_EQ(loop.unsound(), 0);
  EXPECT_TRUE(loop.last().held || loop.port().abilities().has_dead_man);
}

TEST_P(DriverContract, is_not_connected_before_the_start_and_after_the_stop) {
  DevicePort port = open();
  DeviceState state;
  port.exchange({}, state);
  EXPECT_EQ(state.fault, DeviceFault::not_connected);
  DeviceLoop loop(std::move(port));
  loop.start();
  ASSERT_TRUE(loop.rounds(3));
  loop.stop();
  loop.port().exchange({}, state);
  EXPECT_EQ(state.fault, DeviceFault::not_connected);
  const auto rounds = loop.port().ticks();
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(loop.port().ticks(), rounds);
}

TEST_P(DriverContract, starts_again_after_a_stop_and_opens_again_after_a_close) {
  for (int opening = 0; opening < 2; ++opening) {
    DeviceLoop loop(open());
    for (int start = 0; start < 2; ++start) {
      loop.start();
      ASSERT_TRUE(loop.rounds(3)) << opening << start;
      EXPECT_EQ(text_of(loop.last().fault), text_of(DeviceFault::none)) << opening << start;
      loop.stop();
    }
  }
}

TEST_P(DriverContract, can_be_closed_without_a_start_and_without_a_stop) {
  { const DevicePort never_started = open(); }
  DeviceLoop loop(open());
  loop.start();
  ASSERT_TRUE(loop.rounds(3));
}

TEST_P(DriverContract, refuses_a_setting_that_it_does_not_know) {
  const std::string told = refusal(scene_.identity, scene_.settings + " colour=red");
  EXPECT_THAT(told, HasSubstr("colour"));
  EXPECT_THROW(list_devices(driver(), "colour=red"), InputError);
}

TEST_P(DriverContract, says_in_one_sentence_what_is_missing) {
  if (GetParam().absent_message.empty()) GTEST_SKIP() << "this driver needs nothing that can be missing";
  scene_ = {};
  const std::string told = refusal(GetParam().absent_identity, GetParam().absent_settings);
  for (const std::string& words : GetParam().absent_message) EXPECT_THAT(told, HasSubstr(words));
  EXPECT_THAT(told, HasSubstr(driver().name));
  EXPECT_EQ(told.find('\n'), std::string::npos);
}

TEST_P(DriverContract, tells_when_the_device_has_gone_or_the_hand_has_ended_and_goes_on_answering) {
  if (!scene_.ends) GTEST_SKIP() << "nothing can take this device away";
  DeviceLoop loop(open());
  loop.start();
  ASSERT_TRUE(loop.rounds(2));
  if (scene_.end) scene_.end();
  const bool is_fault = scene_.fault_at_end != DeviceFault::none;
  EXPECT_TRUE(comes_true([&] { return is_fault ? loop.last().fault == scene_.fault_at_end : loop.last().ended(); }))
      << text_of(loop.last().fault);
  ASSERT_TRUE(loop.rounds(20)) << "after its end";
  EXPECT_EQ(loop.unsound(), 0);
  EXPECT_EQ(text_of(loop.last().fault), text_of(scene_.fault_at_end));
  if (is_fault) {
    EXPECT_GT(loop.port().explain().size(), 20u);
  } else {
    EXPECT_TRUE(loop.last().ended());
  }
}

TEST_P(DriverContract, can_be_asked_about_its_fault_by_another_thread_at_any_time) {
  DeviceLoop loop(open());
  loop.start();
  std::atomic<bool> asking{true};
  std::thread asks([&] {
    while (asking) {
      static_cast<void>(loop.port().explain());
      static_cast<void>(loop.port().ticks());
    }
  });
  EXPECT_TRUE(loop.rounds(50));
  if (scene_.end) scene_.end();
  EXPECT_TRUE(loop.rounds(50));
  asking = false;
  asks.join();
}

TEST_P(DriverContract, allocates_and_locks_nothing_in_a_round) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer owns malloc and the locks in this build";
  DevicePort port = open();
  if (port.abilities().owns_loop)
    GTEST_SKIP() << "the rounds are the vendor's; force_contract_test.cpp looks at ours";
  port.start();
  DeviceState state;
  for (int round = 0; round < 3; ++round) port.exchange({}, state);
  {
    const RealTimeGuard guard;
    for (int round = 0; round < 50; ++round) port.exchange({}, state);
  }
  EXPECT_EQ(RealTimeGuard::heap_calls() + RealTimeGuard::lock_calls(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Drivers, DriverContract, testing::ValuesIn(contract_subjects()),
                         [](const auto& subject) { return subject.param.name; });

}  // namespace
}  // namespace bodkin
