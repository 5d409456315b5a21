#include "haptics/device_servo.h"

#include <atomic>
#include <chrono>
#include <exception>
#include <thread>
#include <utility>

#include "haptics/deadline_clock.h"

namespace bodkin::haptics {

namespace {

using Clock = std::chrono::steady_clock;

// The guard's ramp takes 20 ms of ticks. The wait ends if no tick arrives for the first time, and at the latest after
// the second.
constexpr std::chrono::milliseconds longest_silence{40};
constexpr std::chrono::milliseconds longest_ramp{120};
constexpr std::chrono::microseconds look_interval{500};

ServoSettings guarded(ServoSettings settings, const DeviceAbilities& abilities) {
  const double user_force = settings.guard.user_force, frozen_time = settings.guard.frozen_time;
  settings.guard = guard_settings(abilities, settings.rate);
  settings.guard.user_force = user_force;
  settings.guard.frozen_time = frozen_time;
  return settings;
}

}  // namespace

struct DeviceServo::Shared final : DeviceTick {
  Shared(DevicePort opened, const DeviceAbilities& known, const ServoSettings& settings, Controller controller)
      : port(std::move(opened)), servo(guarded(settings, known), std::move(controller)) {}

  // Runs in the vendor's thread.
  Wrench tick(const DeviceState& state, double dt) noexcept override {
    if (!raised) raise_this_thread();
    raised = true;
    return publish_step(servo.step(state, dt));
  }
  Wrench publish_step(const Wrench& applied) noexcept {
    const bool at_rest = applied.force.isZero(0.0) && applied.torque.isZero(0.0);
    pushes.store(!at_rest, std::memory_order_release);
    steps.fetch_add(1, std::memory_order_release);
    return applied;
  }

  // The wait for a force that has been disarmed to reach zero.
  void wait_for_zero() const noexcept {
    const auto begin = Clock::now();
    auto last_step = begin;
    std::uint64_t seen = steps.load(std::memory_order_acquire);
    while (pushes.load(std::memory_order_acquire)) {
      std::this_thread::sleep_for(look_interval);
      const auto now = Clock::now();
      const std::uint64_t count = steps.load(std::memory_order_acquire);
      if (count != seen) last_step = now;
      seen = count;
      if (now - last_step >= longest_silence || now - begin >= longest_ramp) return;
    }
  }

  DevicePort port;
  ServoTick servo;
  bool raised = false;              // the vendor's thread; only there
  std::atomic<bool> pushes{false};  // the newest tick has a force or a torque
  std::atomic<std::uint64_t> steps{0};
};

DeviceServo::DeviceServo(DevicePort port, const DeviceAbilities& known, const ServoSettings& settings,
                         Controller controller)
    : shared_(std::make_shared<Shared>(std::move(port), known, settings, std::move(controller))) {}

DeviceServo::~DeviceServo() {
  stop();
}

void DeviceServo::start(bool require_real_time) {
  if (shared_->port.abilities().owns_loop) memory_ = std::make_unique<LockedMemory>();
  shared_->port.start(shared_.get());
  started_ = true;
  if (shared_->port.abilities().owns_loop) return;
  ServoThreadSettings settings;
  settings.period = shared_->servo.period();
  settings.require_real_time = require_real_time;
  thread_ = std::make_unique<ServoThread>(
      settings,
      [shared = shared_](const Wrench& command, DeviceState& state) { shared->port.exchange(command, state); },
      [shared = shared_](const DeviceState& state, double dt, double lateness) {
        return shared->publish_step(shared->servo.step(state, dt, lateness));
      });
  thread_->start();
  refused_ = thread_->refused();
}

bool DeviceServo::stop() noexcept {
  if (!started_) return true;
  started_ = false;
  shared_->servo.disarm();
  shared_->wait_for_zero();
  bool answered = thread_ == nullptr || thread_->stop();
  try {
    if (answered) shared_->port.stop();
  } catch (const std::exception&) {
    answered = false;  // the port has abandoned the call and ends the force when the device returns
  }
  memory_.reset();
  return answered;
}

ServoTick& DeviceServo::tick() noexcept {
  return shared_->servo;
}

std::uint64_t DeviceServo::rounds() const noexcept {
  return thread_ != nullptr ? thread_->rounds() : shared_->port.ticks();
}

double DeviceServo::own_delay() const noexcept {
  return shared_->port.abilities().owns_loop ? 0.0 : shared_->servo.period();
}

std::string DeviceServo::explain() const {
  return shared_->port.explain();
}

}  // namespace bodkin::haptics
