#include "haptics/device_servo.h"

#include <exception>
#include <utility>

namespace bodkin::haptics {

namespace {

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

  Wrench tick(const DeviceState& state, double dt) noexcept override { return servo.step(state, dt); }

  DevicePort port;
  ServoTick servo;
};

DeviceServo::DeviceServo(DevicePort port, const DeviceAbilities& known, const ServoSettings& settings,
                         Controller controller)
    : shared_(std::make_shared<Shared>(std::move(port), known, settings, std::move(controller))) {}

DeviceServo::~DeviceServo() {
  stop();
}

void DeviceServo::start(bool require_real_time) {
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
        return shared->servo.step(state, dt, lateness);
      });
  thread_->start();
  refused_ = thread_->refused();
}

bool DeviceServo::stop() noexcept {
  if (!started_) return true;
  started_ = false;
  shared_->servo.disarm();
  bool answered = thread_ == nullptr || thread_->stop();
  try {
    if (answered) shared_->port.stop();
  } catch (const std::exception&) {
    answered = false;  // the port has given the call up and ends the force when the device comes back
  }
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
