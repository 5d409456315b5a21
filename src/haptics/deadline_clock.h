#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bodkin::haptics {

// Wakes a servo thread at absolute times of the monotonic clock, `period` apart, and counts the wake-ups that came
// too late for a tick's work. Late ticks are never caught up in a burst: missed deadlines are skipped, and between a
// wake-up and the next deadline there is always at least half a period. wait() neither locks nor allocates.
class DeadlineClock {
 public:
  // `period`: s, > 0.
  explicit DeadlineClock(double period);

  // The first deadline is one period from now.
  void start() noexcept;
  // Sleeps until the next deadline.
  void wait() noexcept;

  std::uint64_t deadlines() const noexcept { return deadlines_; }
  // Wake-ups more than one period late.
  std::uint64_t missed() const noexcept { return missed_; }
  // s by which the last wake-up came after its deadline.
  double lateness() const noexcept { return static_cast<double>(late_) * 1e-9; }
  // s, the latest wake-up.
  double worst_lateness() const noexcept { return static_cast<double>(worst_) * 1e-9; }

 private:
  std::int64_t period_;  // ns
  std::int64_t next_ = 0;
  std::uint64_t deadlines_ = 0;
  std::uint64_t missed_ = 0;
  std::int64_t late_ = 0;
  std::int64_t worst_ = 0;
};

// Locks the memory of the program in RAM during its lifetime, so that no tick waits for the disk. Several objects may
// exist at a time: the last one unlocks the memory. Any thread.
class LockedMemory {
 public:
  LockedMemory();
  ~LockedMemory();
  LockedMemory(const LockedMemory&) = delete;
  LockedMemory& operator=(const LockedMemory&) = delete;

  bool is_locked() const noexcept { return locked_; }

 private:
  bool locked_ = false;
};

// Requests priority over other threads for the calling thread (SCHED_FIFO, memory locked, fine timers) during its
// lifetime. Refused requests are listed, one sentence each, and the thread runs without them.
class RealTimePriority {
 public:
  RealTimePriority();
  ~RealTimePriority();
  RealTimePriority(const RealTimePriority&) = delete;
  RealTimePriority& operator=(const RealTimePriority&) = delete;

  const std::vector<std::string>& refused() const { return refused_; }

 private:
  bool scheduled_ = false;
  LockedMemory memory_;
  std::vector<std::string> refused_;
};

// Raises the priority of the calling thread, a vendor's, for its lifetime, unless the vendor has done so. Neither
// locks nor allocates. False: the system refused.
bool raise_this_thread() noexcept;

// The requests that the system would refuse to a servo thread of this program, one sentence each, tried in a thread
// that has ended when this returns.
std::vector<std::string> real_time_refusals();

}  // namespace bodkin::haptics
