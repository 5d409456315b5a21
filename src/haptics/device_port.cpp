#include "haptics/device_port.h"

#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <thread>
#include <utility>

#include "haptics/bounded_call.h"
#include "haptics/driver_values.h"

namespace bodkin::haptics {

namespace {

using Message = std::array<char, BODKIN_MESSAGE>;

std::string text_of(const Message& message) {
  return {message.data(), strnlen(message.data(), message.size())};
}

// Throws what a result other than BODKIN_OK means.
void must_succeed(const bodkin_driver& driver, int result, const Message& message) {
  if (result == BODKIN_OK) return;
  const DeviceFault fault = fault_from(result);
  std::string text = std::string(driver.name) + ": ";
  const std::string message_text = text_of(message);
  text += message_text.empty() ? std::string(text_of(fault)) : message_text;
  if (result == BODKIN_BAD_SETTINGS) throw InputError(text);
  throw DeviceError(fault, text);
}

[[noreturn]] void gave_up(const bodkin_driver& driver, const char* call, std::chrono::milliseconds patience) {
  throw DeviceError(DeviceFault::communication_lost, std::string(driver.name) +
                                                         ": the vendor's software has not returned from " + call +
                                                         " within " + std::to_string(patience.count() / 1000) +
                                                         " s: unplug the device, plug it in and start Bodkin again");
}

}  // namespace

std::vector<FoundDevice> list_devices(const bodkin_driver& driver, const std::string& settings,
                                      std::chrono::milliseconds patience) {
  struct Search {
    const bodkin_driver& driver;
    std::string settings;
    std::vector<FoundDevice> found;
    Message message{};
    int result = BODKIN_OK;
  };
  const auto search = std::make_shared<Search>(Search{driver, settings, {}, {}, BODKIN_OK});
  const auto keep = [](void* user, const char* identity, const char* title) {
    static_cast<Search*>(user)->found.push_back({identity, title});
  };
  const bool answered = returns_within(patience,
                                       [search, keep] {
                                         search->result = search->driver.list(search->settings.c_str(), keep,
                                                                              search.get(), search->message.data());
                                       },
                                       {});
  if (!answered) gave_up(driver, "looking for devices", patience);
  must_succeed(driver, search->result, search->message);
  return std::move(search->found);
}

// State shared by the port, the vendor's thread and abandoned calls.
struct DevicePort::Shared {
  Shared(const bodkin_driver& its_driver, std::string its_identity, std::string its_settings)
      : driver(its_driver), identity(std::move(its_identity)), settings(std::move(its_settings)) {}

  const bodkin_driver& driver;
  const std::string identity, settings;
  void* handle = nullptr;
  bodkin_abilities abilities{};
  Message message{};
  int result = BODKIN_OK;

  // A gate before the tick and before the exchange: no call passes once it is shut, and the thread that shuts it can
  // wait for the call inside.
  std::atomic<bool> shut{true};
  std::atomic<bool> inside{false};
  std::atomic<std::uint64_t> ticks{0};
  DeviceTick* tick = nullptr;
  DeviceState state;                         // of the vendor's loop
  DeviceFault answered = DeviceFault::none;  // the state that the next exchange's command answers

  bool enter() noexcept {
    inside.store(true);
    if (!shut.load()) return true;
    inside.store(false);
    return false;
  }
  void leave() noexcept {
    ticks.fetch_add(1, std::memory_order_relaxed);
    inside.store(false);
  }
  void shut_and_wait() noexcept {
    shut.store(true);
    while (inside.load()) std::this_thread::sleep_for(std::chrono::microseconds(100));
  }

  void stop_and_close() noexcept {
    if (handle == nullptr) return;
    shut_and_wait();
    driver.stop(handle);
    driver.close(handle);
    handle = nullptr;
  }

  static void run(void* user, const bodkin_state* from, double dt, bodkin_command* command) noexcept;
};

void DevicePort::Shared::run(void* user, const bodkin_state* from, double dt, bodkin_command* command) noexcept {
  auto& self = *static_cast<Shared*>(user);
  *command = bodkin_command{};
  if (!self.enter()) return;
  read_state(*from, self.state);
  const Wrench wrench = self.tick->tick(self.state, std::isfinite(dt) && dt > 0.0 ? dt : 0.0);
  if (self.state.fault == DeviceFault::none) *command = command_from(wrench);
  self.leave();
}

DevicePort::DevicePort(const bodkin_driver& driver, const std::string& identity, const std::string& settings,
                       std::chrono::milliseconds patience)
    : shared_(std::make_shared<Shared>(driver, identity, settings)), patience_(patience) {
  const bool answered = returns_within(
      patience,
      [shared = shared_] {
        shared->result = shared->driver.open(shared->identity.c_str(), shared->settings.c_str(), &shared->handle,
                                             &shared->abilities, shared->message.data());
      },
      [shared = shared_] { shared->stop_and_close(); });
  if (!answered) gave_up(driver, "opening the device", patience);
  must_succeed(driver, shared_->result, shared_->message);
  if (shared_->handle == nullptr) {
    throw DeviceError(DeviceFault::vendor_error,
                      std::string(driver.name) + ": the driver opened no device, although it reported success");
  }
  abilities_ = abilities_from(shared_->abilities);
}

DevicePort::DevicePort(DevicePort&& other) noexcept
    : shared_(std::move(other.shared_)),
      patience_(other.patience_),
      abilities_(std::move(other.abilities_)),
      started_(std::exchange(other.started_, false)),
      lost_(other.lost_) {}

DevicePort::~DevicePort() {
  close();
}

void DevicePort::close() noexcept {
  if (shared_ == nullptr) return;
  shared_->shut.store(true);
  // A round that hangs in the vendor's call has read this object, before its end.
  static_cast<void>(shared_->inside.load());
  if (lost_) return;  // the abandoned call closes the device, if it ever returns
  try {
    returns_within(patience_, [shared = shared_] { shared->stop_and_close(); }, {});
  } catch (...) {
    shared_->stop_and_close();  // no thread left: a device under force is worse than a wait
  }
}

void DevicePort::must_answer(bool answered, const char* call) {
  if (answered) return;
  shared_->shut.store(true);
  lost_ = true;
  started_ = false;
  gave_up(shared_->driver, call, patience_);
}

void DevicePort::start(DeviceTick* tick) {
  if (started_) return;
  must_answer(!lost_, "the call before");
  if (abilities_.owns_loop && tick == nullptr) throw std::logic_error("this device owns its loop and needs a tick");
  shared_->tick = tick;
  shared_->state = {};
  shared_->answered = DeviceFault::none;
  shared_->shut.store(false);
  const bool answered = returns_within(
      patience_,
      [shared = shared_] {
        shared->message = {};
        shared->result = shared->driver.start(shared->handle, Shared::run, shared.get(), shared->message.data());
      },
      [shared = shared_] { shared->stop_and_close(); });
  must_answer(answered, "starting");
  if (shared_->result != BODKIN_OK) shared_->shut_and_wait();
  must_succeed(shared_->driver, shared_->result, shared_->message);
  started_ = true;
}

void DevicePort::exchange(const Wrench& command, DeviceState& state) noexcept {
  Shared& shared = *shared_;
  if (!shared.enter()) {
    state.fault = DeviceFault::not_connected;
    return;
  }
  const bodkin_command out = shared.answered == DeviceFault::none ? command_from(command) : bodkin_command{};
  bodkin_state in{};
  const int result = shared.driver.exchange(shared.handle, &out, &in);
  if (result != BODKIN_OK) in.fault = static_cast<std::uint32_t>(fault_from(result));
  read_state(in, state);
  shared.answered = state.fault;
  shared.leave();
}

void DevicePort::stop() {
  if (!started_) return;
  shared_->shut.store(true);
  const bool answered = returns_within(
      patience_,
      [shared = shared_] {
        shared->shut_and_wait();
        shared->message = {};
        shared->result = shared->driver.stop(shared->handle);
      },
      [shared = shared_] { shared->stop_and_close(); });
  must_answer(answered, "stopping");
  started_ = false;
  must_succeed(shared_->driver, shared_->result, shared_->message);
}

std::uint64_t DevicePort::ticks() const noexcept {
  return shared_->ticks.load(std::memory_order_relaxed);
}

std::string DevicePort::explain() const {
  if (lost_ || shared_->driver.explain == nullptr) return {};
  Message message{};
  shared_->driver.explain(shared_->handle, message.data());
  return text_of(message);
}

}  // namespace bodkin::haptics
