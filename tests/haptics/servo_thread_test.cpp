#include "haptics/servo_thread.h"

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::haptics;
namespace {

template <typename Condition>
bool soon(const Condition& condition) {
  for (int i = 0; i < 20000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return condition();
}

Wrench push() {
  return {Vec3(0.0, 0.0, 1.0), Vec3::Zero()};
}

TEST(ServoThread, exchanges_and_ticks_in_turn_and_ends_with_a_command_of_zero) {
  struct Seen {
    std::atomic<int> exchanges{0}, ticks{0}, negative{0};
    std::atomic<double> last{-1.0};
  };
  const auto seen = std::make_shared<Seen>();
  ServoThread servo(
      {},
      [seen](const Wrench& command, DeviceState& state) {
        ++seen->exchanges;
        seen->last = command.force.z();
        state.hand.translation().x() = 4.0;
      },
      [seen](const DeviceState& state, double dt, double lateness) {
        ++seen->ticks;
        if (!(dt > 0.0) || !(lateness >= 0.0) || state.hand.translation().x() != 4.0) ++seen->negative;
        return push();
      });
  servo.start();
  EXPECT_TRUE(soon([&] { return seen->ticks > 20; }));
  EXPECT_EQ(seen->last, 1.0);
  EXPECT_TRUE(servo.stop());
  EXPECT_EQ(seen->last, 0.0);
  EXPECT_EQ(seen->negative, 0);
  const int ticks = seen->ticks;
  EXPECT_LE(seen->exchanges - ticks, 2);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(seen->ticks, ticks) << "no tick after stop";
  EXPECT_GE(servo.rounds(), 20u);
  EXPECT_TRUE(servo.stop()) << "harmless to repeat";
}

TEST(ServoThread, stop_leaves_an_exchange_behind_that_never_returns) {
  struct Hang {
    std::promise<void> release;
    std::shared_future<void> released = release.get_future().share();
    std::atomic<bool> hanging{false};
    std::atomic<int> exchanges{0}, ticks{0};
  };
  const auto hang = std::make_shared<Hang>();
  const std::weak_ptr<Hang> alive = hang;
  {
    ServoThread servo(
        {.patience = 0.1},
        [hang](const Wrench&, DeviceState&) {
          if (++hang->exchanges < 5) return;
          hang->hanging = true;
          hang->released.wait();
        },
        [hang](const DeviceState&, double, double) {
          ++hang->ticks;
          return push();
        });
    servo.start();
    EXPECT_TRUE(soon([&] { return hang->hanging.load(); }));
    EXPECT_TRUE(soon([&] { return servo.is_stalled(); }));
    EXPECT_GT(servo.silence(), 0.04);
    const auto before = std::chrono::steady_clock::now();
    EXPECT_FALSE(servo.stop());
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(10));
    EXPECT_FALSE(servo.is_stalled()) << "it is over";
  }
  EXPECT_EQ(hang->ticks, 4);
  hang->release.set_value();  // the vendor's library wakes up after all
  EXPECT_TRUE(soon([&] { return hang.use_count() == 1; })) << "the thread lets go of everything";
  EXPECT_EQ(hang->exchanges, 5) << "and touches the device no more";
  EXPECT_EQ(hang->ticks, 4);
}

TEST(ServoThread, an_exchange_that_throws_is_a_fault_of_the_device) {
  const auto fault = std::make_shared<std::atomic<DeviceFault>>(DeviceFault::none);
  ServoThread servo(
      {}, [](const Wrench&, DeviceState&) { throw std::runtime_error("gone"); },
      [fault](const DeviceState& state, double, double) {
        *fault = state.fault;
        return Wrench{};
      });
  servo.start();
  EXPECT_TRUE(soon([&] { return *fault == DeviceFault::vendor_error; }));
  EXPECT_TRUE(servo.stop());
}

TEST(ServoThread, says_what_the_system_did_not_grant_and_refuses_to_run_where_it_is_required) {
  const auto nothing = [](const Wrench&, DeviceState&) {};
  const auto still = [](const DeviceState&, double, double) { return Wrench{}; };
  ServoThread servo({}, nothing, still);
  servo.start();
  const bool granted = servo.refused().empty();
  EXPECT_TRUE(servo.stop());
  ServoThread strict({.require_real_time = true}, nothing, still);
  if (granted) {
    EXPECT_NO_THROW(strict.start());
  } else {
    EXPECT_THROW(strict.start(), SystemError);
    EXPECT_EQ(strict.rounds(), 0u);
  }
}

TEST(ServoThread, stops_without_having_started) {
  ServoThread servo(
      {}, [](const Wrench&, DeviceState&) {}, [](const DeviceState&, double, double) { return push(); });
  EXPECT_FALSE(servo.is_stalled());
  EXPECT_TRUE(servo.stop());
  EXPECT_THROW(servo.start(), SystemError);
}

TEST(ServoThread, settings_that_cannot_be_are_refused) {
  const auto nothing = [](const Wrench&, DeviceState&) {};
  const auto still = [](const DeviceState&, double, double) { return Wrench{}; };
  EXPECT_THROW(ServoThread({.period = 0.0}, nothing, still), InputError);
  EXPECT_THROW(ServoThread({.patience = 0.0}, nothing, still), InputError);
  EXPECT_THROW(ServoThread({}, nullptr, still), InputError);
  EXPECT_THROW(ServoThread({}, nothing, nullptr), InputError);
}

}  // namespace
}  // namespace bodkin
