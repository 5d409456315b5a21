#include "haptics/device_port.h"

#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

#include "tests/simulation/real_time_guard.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/driver_values.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr auto impatient = 100ms;

// A driver in this program controlled by the test.
struct Fake {
  std::atomic<const char*> blocked{""};  // the call that does not return until this changes
  std::atomic<int> inside{0};            // calls that have not returned
  std::atomic<int> opened{0}, closed{0}, stopped{0};
  int result = BODKIN_OK;
  std::uint32_t owns_loop = 0;
  bodkin_state state{};
  bodkin_command command{};
  bodkin_tick tick = nullptr;
  void* user = nullptr;

  // A call, from its begin to its end.
  class Visit {
   public:
    Visit(Fake* host, const char* call) : host_(*host) {
      ++host_.inside;
      while (std::string(host_.blocked.load()) == call) std::this_thread::sleep_for(1ms);
    }
    ~Visit() { --host_.inside; }
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;

   private:
    Fake& host_;
  };
  // Lets all calls return and waits for them.
  void release() {
    blocked = "";
    while (inside.load() > 0) std::this_thread::sleep_for(1ms);
  }
};

Fake* fake = nullptr;

const bodkin_driver driver = {BODKIN_DRIVER_ABI,
                              "fake",
                              "for tests",
                              [](const char*, bodkin_found found, void* user, char*) {
                                const Fake::Visit visit(fake, "list");
                                found(user, "a", "A");
                                return fake->result;
                              },
                              [](const char*, const char*, void** handle, bodkin_abilities* abilities, char*) {
                                const Fake::Visit visit(fake, "open");
                                if (fake->result != BODKIN_OK) return fake->result;
                                *handle = fake;
                                abilities->peak_force = nan;
                                abilities->owns_loop = fake->owns_loop;
                                ++fake->opened;
                                return fake->result;
                              },
                              [](void*, bodkin_tick tick, void* user, char*) {
                                fake->tick = tick;
                                fake->user = user;
                                const Fake::Visit visit(fake, "start");
                                return fake->result;
                              },
                              [](void*, const bodkin_command* command, bodkin_state* state) {
                                const Fake::Visit visit(fake, "exchange");
                                fake->command = *command;
                                *state = fake->state;
                                return fake->result;
                              },
                              [](void*) {
                                const Fake::Visit visit(fake, "stop");
                                ++fake->stopped;
                                return fake->result;
                              },
                              [](void*) {
                                const Fake::Visit visit(fake, "close");
                                ++fake->closed;
                              },
                              nullptr};

class Port : public testing::Test {
 protected:
  Port() {
    fake = &fake_;
    fake_.state.rotation[0] = fake_.state.rotation[4] = fake_.state.rotation[8] = 1.0;
    fake_.state.held = 1;
  }
  ~Port() override { fake_.release(); }

  // Waits for the effect of an abandoned call's late return.
  static void eventually(const std::atomic<int>& count, int value) {
    for (int wait = 0; wait < 20000 && count.load() < value; ++wait) std::this_thread::sleep_for(1ms);
    EXPECT_EQ(count.load(), value);
  }

  Fake fake_;
};

template <typename Call>
std::string lost(Call call) {
  try {
    call();
  } catch (const DeviceError& error) {
    EXPECT_EQ(error.fault(), DeviceFault::communication_lost);
    return error.what();
  }
  ADD_FAILURE() << "the call returned";
  return {};
}

TEST_F(Port, a_list_that_blocks_is_given_up) {
  fake_.blocked = "list";
  EXPECT_THAT(lost([] { list_devices(driver, "", impatient); }), HasSubstr("looking for devices"));
  fake_.release();
}

TEST_F(Port, a_device_whose_opening_comes_back_late_is_closed) {
  fake_.blocked = "open";
  lost([] { DevicePort(driver, "", "", impatient); });
  EXPECT_EQ(fake_.opened, 0);
  fake_.release();
  eventually(fake_.closed, 1);
  EXPECT_EQ(fake_.stopped, 1);
}

TEST_F(Port, a_start_that_blocks_is_given_up_and_the_device_closed_afterwards) {
  {
    DevicePort port(driver, "", "");
    port.set_patience(impatient);
    fake_.blocked = "start";
    lost([&] { port.start(); });
    lost([&] { port.start(); });
    DeviceState state;
    port.exchange({}, state);
    EXPECT_EQ(state.fault, DeviceFault::not_connected);
  }
  EXPECT_EQ(fake_.closed, 0);
  fake_.release();
  eventually(fake_.closed, 1);
}

TEST_F(Port, a_stop_that_blocks_is_given_up_and_so_is_the_closing) {
  {
    DevicePort port(driver, "", "");
    port.start();
    port.set_patience(impatient);
    fake_.blocked = "stop";
    EXPECT_THAT(lost([&] { port.stop(); }), HasSubstr("stopping"));
  }
  fake_.release();
  eventually(fake_.closed, 1);
}

TEST_F(Port, an_exchange_that_hangs_does_not_hang_the_stop) {
  auto port = std::make_unique<DevicePort>(driver, "", "");
  port->start();
  port->set_patience(impatient);
  fake_.blocked = "exchange";
  DeviceState state;
  std::thread servo([&state, &port = *port] { port.exchange({}, state); });
  while (fake_.inside.load() == 0) std::this_thread::sleep_for(1ms);
  lost([&] { port->stop(); });
  EXPECT_EQ(fake_.stopped, 0);  // not while the vendor's call is under way
  port.reset();
  fake_.release();
  servo.join();
  eventually(fake_.closed, 1);
}

TEST_F(Port, closes_what_it_opened_and_stops_it_first) {
  {
    DevicePort port(driver, "", "");
    port.start();
    DevicePort moved(std::move(port));
  }
  EXPECT_EQ(fake_.stopped, 1);
  EXPECT_EQ(fake_.closed, 1);
}

TEST_F(Port, refusals_arrive_with_their_fault_and_unknown_ones_as_vendor_errors) {
  fake_.result = BODKIN_BUSY;
  try {
    DevicePort(driver, "", "");
    FAIL();
  } catch (const DeviceError& error) {
    EXPECT_EQ(error.fault(), DeviceFault::busy);
    EXPECT_STREQ(error.what(), "fake: busy");
  }
  fake_.result = 77;
  try {
    DevicePort(driver, "", "");
    FAIL();
  } catch (const DeviceError& error) {
    EXPECT_EQ(error.fault(), DeviceFault::vendor_error);
  }
  fake_.result = BODKIN_BAD_SETTINGS;
  EXPECT_THROW(DevicePort(driver, "", ""), InputError);
}

TEST_F(Port, passes_forces_only_while_started) {
  DevicePort port(driver, "", "");
  DeviceState state;
  fake_.command.force[0] = -1.0;
  port.exchange({Vec3(1, 2, 3), Vec3::Zero()}, state);
  EXPECT_EQ(state.fault, DeviceFault::not_connected);
  EXPECT_DOUBLE_EQ(fake_.command.force[0], -1.0);  // the driver was not called
  port.start();
  port.exchange({Vec3(1, 2, 3), Vec3(4, 5, 6)}, state);
  EXPECT_THAT(fake_.command.force, testing::ElementsAre(1, 2, 3));
  EXPECT_THAT(fake_.command.torque, testing::ElementsAre(4, 5, 6));
  EXPECT_EQ(port.ticks(), 1u);
  port.stop();
  port.exchange({Vec3(7, 7, 7), Vec3::Zero()}, state);
  EXPECT_EQ(state.fault, DeviceFault::not_connected);
  EXPECT_THAT(fake_.command.force, testing::ElementsAre(1, 2, 3));
}

TEST_F(Port, sends_nothing_that_is_not_finite) {
  DevicePort port(driver, "", "");
  port.start();
  DeviceState state;
  port.exchange({Vec3(1, nan, 3), Vec3::Zero()}, state);
  EXPECT_THAT(fake_.command.force, testing::ElementsAre(0, 0, 0));
  port.exchange({Vec3(1, 2, 3), Vec3(0, 0, nan)}, state);
  EXPECT_THAT(fake_.command.force, testing::ElementsAre(0, 0, 0));
}

TEST_F(Port, answers_a_fault_with_zero_force_until_it_is_gone) {
  DevicePort port(driver, "", "");
  port.start();
  DeviceState state;
  const Wrench push{Vec3(1, 2, 3), Vec3::Zero()};
  fake_.state.fault = BODKIN_OVERHEATED;
  port.exchange(push, state);
  EXPECT_EQ(state.fault, DeviceFault::overheated);
  fake_.state.fault = BODKIN_OK;
  port.exchange(push, state);
  EXPECT_THAT(fake_.command.force, testing::ElementsAre(0, 0, 0));
  port.exchange(push, state);
  EXPECT_THAT(fake_.command.force, testing::ElementsAre(1, 2, 3));
}

TEST_F(Port, a_pose_that_cannot_be_is_bad_data_and_the_hand_stays_where_it_was) {
  DevicePort port(driver, "", "");
  port.start();
  DeviceState state;
  fake_.state.position[1] = 5.0;
  port.exchange({}, state);
  EXPECT_EQ(state.fault, DeviceFault::none);
  const bodkin_state good = fake_.state;
  const auto spoil = [&](auto change) {
    fake_.state = good;
    change(fake_.state);
    port.exchange({}, state);
    EXPECT_EQ(state.fault, DeviceFault::bad_data);
    EXPECT_EQ(state.hand.translation(), Vec3(0, 5, 0));
    EXPECT_EQ(state.hand.linear(), Mat3::Identity());
  };
  spoil([](bodkin_state& s) { s.position[2] = nan; });
  spoil([](bodkin_state& s) { s.position[0] = 1e9; });
  spoil([](bodkin_state& s) { s.rotation[3] = std::numeric_limits<double>::infinity(); });
  spoil([](bodkin_state& s) { s.rotation[0] = 1.1; });
  spoil([](bodkin_state& s) { s.rotation[0] = -1.0; });  // a mirror
  spoil([](bodkin_state& s) { std::fill(std::begin(s.rotation), std::end(s.rotation), 0.0); });
}

TEST_F(Port, a_rotation_in_single_precision_becomes_a_true_one) {
  DevicePort port(driver, "", "");
  port.start();
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (int i = 0; i < 9; ++i) fake_.state.rotation[i] = static_cast<float>(turn(i / 3, i % 3));
  DeviceState state;
  port.exchange({}, state);
  EXPECT_EQ(state.fault, DeviceFault::none);
  EXPECT_TRUE(state.hand.linear().isApprox(turn, 1e-6));
  EXPECT_NEAR((state.hand.linear().transpose() * state.hand.linear() - Mat3::Identity()).norm(), 0.0, 1e-14);
}

TEST_F(Port, believes_no_ability_that_is_not_finite) {
  const DevicePort port(driver, "", "");
  EXPECT_DOUBLE_EQ(port.abilities().peak_force, 0.0);
  EXPECT_DOUBLE_EQ(port.abilities().rate, 1000.0);
}

TEST_F(Port, an_exchange_allocates_and_locks_nothing) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer owns malloc and the locks in this build";
  DevicePort port(driver, "", "");
  port.start();
  DeviceState state;
  {
    const RealTimeGuard guard;
    for (int tick = 0; tick < 10; ++tick) port.exchange({Vec3(1, 2, 3), Vec3::Zero()}, state);
  }
  EXPECT_EQ(RealTimeGuard::heap_calls(), 0u);
  EXPECT_EQ(RealTimeGuard::lock_calls(), 0u);
}

struct Pusher : DeviceTick {
  Wrench tick(const DeviceState&, double dt) noexcept override {
    last_dt = dt;
    ++calls;
    return {Vec3(1, 2, 3), Vec3::Zero()};
  }
  double last_dt = -1.0;
  int calls = 0;
};

TEST_F(Port, the_vendors_thread_gets_force_only_between_start_and_stop) {
  fake_.owns_loop = 1;
  DevicePort port(driver, "", "");
  Pusher pusher;
  EXPECT_THROW(port.start(), std::logic_error);
  port.start(&pusher);
  bodkin_command command{};
  fake_.tick(fake_.user, &fake_.state, nan, &command);
  EXPECT_THAT(command.force, testing::ElementsAre(1, 2, 3));
  EXPECT_DOUBLE_EQ(pusher.last_dt, 0.0);
  fake_.state.fault = BODKIN_FORCE_LIMIT;
  fake_.tick(fake_.user, &fake_.state, 0.001, &command);
  EXPECT_THAT(command.force, testing::ElementsAre(0, 0, 0));
  EXPECT_EQ(pusher.calls, 2);
  port.stop();
  fake_.state.fault = BODKIN_OK;
  fake_.tick(fake_.user, &fake_.state, 0.001, &command);
  EXPECT_THAT(command.force, testing::ElementsAre(0, 0, 0));
  EXPECT_EQ(pusher.calls, 2);
}

}  // namespace
}  // namespace bodkin
