#include "tests/haptics/device_loop.h"

#include <chrono>
#include <cmath>
#include <utility>

namespace bodkin {

using namespace bodkin::haptics;

using namespace std::chrono_literals;

bool comes_true(const std::function<bool()>& condition) {
  for (int wait = 0; wait < 30000; ++wait) {
    if (condition()) return true;
    std::this_thread::sleep_for(1ms);
  }
  return false;
}

Wrench DeviceLoop::Hand::tick(const DeviceState& state, double) noexcept {
  const std::lock_guard lock(mutex_);
  last_ = state;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(state.velocity[i]) > std::abs(fastest_[i])) fastest_[i] = state.velocity[i];
  }
  const Mat3 turn = state.hand.linear();
  const bool sound = state.hand.matrix().allFinite() && (turn * turn.transpose()).isIdentity(1e-6) &&
                     std::abs(turn.determinant() - 1.0) < 1e-6;
  if (!sound) ++unsound_;
  return wrench_;
}

void DeviceLoop::Hand::push(const Wrench& wrench) {
  const std::lock_guard lock(mutex_);
  wrench_ = wrench;
}

DeviceState DeviceLoop::Hand::last() const {
  const std::lock_guard lock(mutex_);
  return last_;
}

Vec3 DeviceLoop::Hand::fastest() const {
  const std::lock_guard lock(mutex_);
  return fastest_;
}

int DeviceLoop::Hand::unsound() const {
  const std::lock_guard lock(mutex_);
  return unsound_;
}

DeviceLoop::DeviceLoop(DevicePort port) : port_(std::make_unique<DevicePort>(std::move(port))) {}

DeviceLoop::~DeviceLoop() {
  close();
  ended_ = true;
  if (servo_.joinable()) servo_.join();
}

void DeviceLoop::start() {
  port_->start(&hand_);
  if (port_->abilities().owns_loop) return;
  servo_ = std::thread([this, &port = *port_] {
    DeviceState state;
    Wrench wrench;
    while (!ended_) {
      port.exchange(wrench, state);
      if (state.fault == DeviceFault::not_connected) break;
      wrench = hand_.tick(state, 0.001);
      std::this_thread::sleep_for(50us);
    }
  });
}

void DeviceLoop::stop() {
  port_->stop();
  ended_ = true;
  if (servo_.joinable()) servo_.join();
  ended_ = false;
}

void DeviceLoop::close(bool hangs) {
  if (port_ == nullptr) return;
  ended_ = true;
  if (servo_.joinable() && !hangs) servo_.join();
  port_.reset();
}

bool DeviceLoop::rounds(int count) {
  const std::uint64_t goal = port_->ticks() + static_cast<std::uint64_t>(count);
  return comes_true([&] { return port_->ticks() >= goal; });
}

}  // namespace bodkin
