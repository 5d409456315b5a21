#include "haptics/deadline_clock.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <ctime>
#include <mutex>
#include <thread>

#include <linux/capability.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace bodkin::haptics {

namespace {

constexpr std::int64_t second = 1'000'000'000;  // ns
constexpr int fifo_priority = 50;
constexpr unsigned long default_timer_slack = 0;  // ns; 0 asks for the system's own again

// Advice for the next run.
std::string permit(const char* limit) {
  return std::string("; permit it with the line '@realtime - ") + limit +
         "' in /etc/security/limits.d/bodkin.conf, add yourself to the group realtime and log in again";
}

// Locking less memory than the program needs would make later allocations fail.
bool may_lock_any_memory() noexcept {
  rlimit limit{};
  if (getrlimit(RLIMIT_MEMLOCK, &limit) == 0) {
    if (limit.rlim_cur == RLIM_INFINITY) return true;
    limit.rlim_cur = limit.rlim_max;
    if (limit.rlim_max == RLIM_INFINITY && setrlimit(RLIMIT_MEMLOCK, &limit) == 0) return true;
  }
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct sets[_LINUX_CAPABILITY_U32S_3] = {};
  return syscall(SYS_capget, &header, sets) == 0 && (sets[0].effective & 1U << CAP_IPC_LOCK) != 0;
}

// For the whole program.
std::mutex locks_mutex;
int locks = 0;

bool schedule_first() noexcept {
  sched_param parameters{};
  parameters.sched_priority = fifo_priority;
  return sched_setscheduler(0, SCHED_FIFO, &parameters) == 0;
}

std::int64_t now() noexcept {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<std::int64_t>(time.tv_sec) * second + time.tv_nsec;
}

}  // namespace

DeadlineClock::DeadlineClock(double period) : period_(std::llround(period * 1e9)) {}

void DeadlineClock::start() noexcept {
  next_ = now() + period_;
}

void DeadlineClock::wait() noexcept {
  const timespec deadline{static_cast<time_t>(next_ / second), static_cast<long>(next_ % second)};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, nullptr) == EINTR) {
  }
  const std::int64_t late = now() - next_;
  late_ = std::max<std::int64_t>(late, 0);
  ++deadlines_;
  worst_ = std::max(worst_, late);
  if (late > period_) ++missed_;
  const std::int64_t earliest = next_ + late + period_ / 2;
  next_ += period_;
  if (next_ < earliest) next_ += (earliest - next_ + period_ - 1) / period_ * period_;
}

LockedMemory::LockedMemory() {
  const std::lock_guard lock(locks_mutex);
  locked_ = locks > 0 || (may_lock_any_memory() && mlockall(MCL_CURRENT | MCL_FUTURE) == 0);
  if (locked_) ++locks;
}

LockedMemory::~LockedMemory() {
  if (!locked_) return;
  const std::lock_guard lock(locks_mutex);
  if (--locks == 0) munlockall();
}

RealTimePriority::RealTimePriority() {
  scheduled_ = schedule_first();
  if (!scheduled_)
    refused_.push_back(std::string("no real-time priority: ") + std::strerror(errno) + permit("rtprio 60"));
  if (!memory_.is_locked())
    refused_.push_back("memory is not locked: the system limits how much may be" + permit("memlock unlimited"));
  prctl(PR_SET_TIMERSLACK, 1UL);
}

RealTimePriority::~RealTimePriority() {
  if (scheduled_) {
    const sched_param ordinary{};
    sched_setscheduler(0, SCHED_OTHER, &ordinary);
  }
  prctl(PR_SET_TIMERSLACK, default_timer_slack);
}

bool raise_this_thread() noexcept {
  const int policy = sched_getscheduler(0) & ~SCHED_RESET_ON_FORK;
  return policy == SCHED_FIFO || policy == SCHED_RR || policy == SCHED_DEADLINE || schedule_first();
}

std::vector<std::string> real_time_refusals() {
  std::vector<std::string> refused;
  std::thread([&refused] { refused = RealTimePriority().refused(); }).join();
  return refused;
}

}  // namespace bodkin::haptics
