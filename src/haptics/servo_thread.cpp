#include "haptics/servo_thread.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "core/settings_check.h"
#include "haptics/deadline_clock.h"
#include "haptics/guard_settings.h"
#include "haptics/tick_clock.h"

namespace bodkin::haptics {

namespace {

double seconds(std::int64_t nanoseconds) noexcept {
  return static_cast<double>(nanoseconds) * 1e-9;
}

}  // namespace

struct ServoThread::Shared {
  Shared(const ServoThreadSettings& from, Exchange with, Tick then)
      : settings(from), exchange(std::move(with)), tick(std::move(then)) {}

  ServoThreadSettings settings;
  Exchange exchange;
  Tick tick;
  std::atomic<bool> stopping{false};
  std::atomic<std::int64_t> last_round{0};  // ns
  std::atomic<std::uint64_t> rounds{0};
  std::atomic<std::uint64_t> missed{0};

  // Only for start and stop, never in a round.
  std::mutex mutex;
  std::condition_variable changed;
  bool begun = false;
  bool may_run = false;
  bool ended = false;
  std::vector<std::string> refused;
};

ServoThread::ServoThread(const ServoThreadSettings& settings, Exchange exchange, Tick tick) : settings_(settings) {
  check_range("servo", "period", settings.period, declaration_of(&GuardSettings::dt).range, "s");
  check_range("servo", "patience of stop()", settings.patience, above(0.0, 60.0), "s");
  check_range("servo", "time of a stall", settings.stall_after, {0.0, unbounded, false, false}, "s");
  if (!exchange || !tick) throw InputError("servo: a function is missing, expected an exchange and a tick");
  shared_ = std::make_shared<Shared>(settings, std::move(exchange), std::move(tick));
}

ServoThread::~ServoThread() {
  stop();
}

void ServoThread::run(const std::shared_ptr<Shared>& shared) noexcept {
  const auto exchange = [&shared](const Wrench& command, DeviceState& state) noexcept {
    try {
      shared->exchange(command, state);
    } catch (...) {
      state.fault = DeviceFault::vendor_error;
    }
  };
  const RealTimePriority priority;
  {
    std::unique_lock lock(shared->mutex);
    shared->refused = priority.refused();
    shared->begun = true;
    shared->changed.notify_all();
    shared->changed.wait(lock, [&] { return shared->may_run || shared->stopping; });
  }
  const TickClock clock = monotonic_clock();
  DeadlineClock deadlines(shared->settings.period);
  Wrench command;
  std::int64_t last = clock();
  deadlines.start();
  while (!shared->stopping.load(std::memory_order_acquire)) {
    deadlines.wait();
    DeviceState state;
    exchange(command, state);
    if (shared->stopping.load(std::memory_order_acquire)) break;
    const std::int64_t now = clock();
    command = shared->tick(state, seconds(now - last), deadlines.lateness());
    last = now;
    shared->missed.store(deadlines.missed(), std::memory_order_relaxed);
    shared->rounds.fetch_add(1, std::memory_order_relaxed);
    shared->last_round.store(clock(), std::memory_order_release);
  }
  // A call that returns after it was abandoned must not access the device.
  std::unique_lock lock(shared->mutex);
  const bool awaited = shared->may_run && !shared->ended;
  lock.unlock();
  if (awaited) {
    DeviceState state;
    exchange(Wrench{}, state);
  }
  lock.lock();
  shared->ended = true;
  shared->changed.notify_all();
}

void ServoThread::start() {
  if (thread_.joinable() || shared_->stopping) throw SystemError("servo: the thread was started already");
  shared_->last_round = monotonic_clock()();
  try {
    thread_ = std::thread([shared = shared_] { run(shared); });
  } catch (const std::system_error& error) {
    throw SystemError(std::string("servo: no thread can be made: ") + error.what());
  }
  std::unique_lock lock(shared_->mutex);
  shared_->changed.wait(lock, [this] { return shared_->begun; });
  refused_ = shared_->refused;
  if (settings_.require_real_time && !refused_.empty()) {
    lock.unlock();
    stop();
    throw SystemError("servo: " + refused_.front());
  }
  shared_->may_run = true;
  shared_->changed.notify_all();
}

bool ServoThread::stop() {
  shared_->stopping.store(true, std::memory_order_release);
  if (!thread_.joinable()) return stopped_in_time_;
  {
    std::unique_lock lock(shared_->mutex);
    shared_->changed.notify_all();
    stopped_in_time_ = shared_->changed.wait_for(lock, std::chrono::duration<double>(settings_.patience),
                                                 [this] { return shared_->ended; });
    shared_->ended = true;  // a call that returns later sees that it was abandoned
  }
  if (stopped_in_time_) {
    thread_.join();
  } else {
    thread_.detach();
  }
  return stopped_in_time_;
}

double ServoThread::silence() const noexcept {
  return seconds(monotonic_clock()() - shared_->last_round.load(std::memory_order_acquire));
}

bool ServoThread::is_stalled() const noexcept {
  return thread_.joinable() && silence() > settings_.stall_after;
}

std::uint64_t ServoThread::rounds() const noexcept {
  return shared_->rounds.load(std::memory_order_relaxed);
}

std::uint64_t ServoThread::missed() const noexcept {
  return shared_->missed.load(std::memory_order_relaxed);
}

}  // namespace bodkin::haptics
