#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bodkin::haptics {

// Wakes a servo thread at absolute moments of the monotonic clock, `period` apart, and counts the wake-ups that came
// too late to do a tick's work in time. What is late is never caught up in a burst: deadlines that have gone by are
// left out, and between a wake-up and the next deadline there is always half a period at least. wait() neither locks
// nor allocates.
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

// Keeps the memory of the program in place while it lives, so that no tick waits for the disk. Several may live at a
// time: the memory is let go with the last. Any thread.
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

// Asks the system to run the calling thread ahead of others (SCHED_FIFO, memory locked, fine timers) while it lives.
// What the system does not grant is listed, one sentence each, and the thread runs on without it.
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

// Lets the calling thread, a vendor's, run ahead of others for as long as it lives, unless the vendor has seen to it.
// Neither locks nor allocates. False: the system does not grant it.
bool raise_this_thread() noexcept;

// What the system would not grant a servo thread of this program, one sentence each, tried out in a thread that has
// ended when this returns.
std::vector<std::string> real_time_refusals();

}  // namespace bodkin::haptics
