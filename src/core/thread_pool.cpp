#include "core/thread_pool.h"

#include <exception>
#include <utility>

namespace bodkin {

namespace {

// Polls before a waiting thread sleeps, about ten microseconds: loops in quick succession find all threads awake.
constexpr int polls_before_sleep = 20000;

void wait_for_change(const std::atomic<std::uint32_t>& value, std::uint32_t old) noexcept {
  for (int poll = 0; poll < polls_before_sleep; ++poll) {
    if (value.load(std::memory_order_acquire) != old) return;
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

ThreadPool::ThreadPool(int threads) {
  if (threads == 0) threads = static_cast<int>(std::thread::hardware_concurrency());
  if (threads < 2) return;
  helpers_.reserve(static_cast<std::size_t>(threads - 1));
  try {
    for (int thread = 1; thread < threads; ++thread) helpers_.emplace_back([this, thread] { serve(thread); });
  } catch (const std::exception&) {  // the system starts no more threads
  }
}

ThreadPool::~ThreadPool() {
  ends_.store(true, std::memory_order_relaxed);
  loop_.fetch_add(1, std::memory_order_release);
  loop_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

// Takes indices of the running loop until none remains. An exchange succeeds only if neither the loop nor the number
// of remaining indices has changed since they were read; from then on the loop cannot end before this thread is done.
void ThreadPool::execute_iterations(int thread) noexcept {
  constexpr std::uint64_t lower_half = 0xFFFFFFFFU;
  std::uint64_t seen = remaining_.load(std::memory_order_acquire);
  while ((seen & lower_half) != 0) {
    if (!remaining_.compare_exchange_weak(seen, seen - 1, std::memory_order_acq_rel, std::memory_order_acquire))
      continue;
    call_(*this, work_, count_ - static_cast<std::size_t>(seen & lower_half), thread);
    if (unfinished_.fetch_sub(1, std::memory_order_acq_rel) == 1) unfinished_.notify_one();
    seen = remaining_.load(std::memory_order_acquire);
  }
}

void ThreadPool::serve(int thread) noexcept {
  for (std::uint32_t seen = 0;;) {
    wait_for_change(loop_, seen);
    seen = loop_.load(std::memory_order_acquire);
    if (ends_.load(std::memory_order_relaxed)) return;
    execute_iterations(thread);
  }
}

void ThreadPool::run_loop(std::size_t count, Call callback, const void* work) noexcept {
  call_ = callback;
  work_ = work;
  count_ = count;
  unfinished_.store(static_cast<std::uint32_t>(count), std::memory_order_relaxed);
  const std::uint64_t number = (remaining_.load(std::memory_order_relaxed) >> 32U) + 1;
  remaining_.store(number << 32U | count, std::memory_order_release);
  loop_.fetch_add(1, std::memory_order_release);
  loop_.notify_all();
  execute_iterations(0);
  for (std::uint32_t left = unfinished_.load(std::memory_order_acquire); left != 0;
       left = unfinished_.load(std::memory_order_acquire)) {
    wait_for_change(unfinished_, left);
  }
}

void ThreadPool::keep_exception() noexcept {
  if (!failed_.exchange(true, std::memory_order_relaxed)) exception_ = std::current_exception();
}

void ThreadPool::rethrow_exception() {
  if (!failed_.load(std::memory_order_relaxed)) return;
  failed_.store(false, std::memory_order_relaxed);
  std::rethrow_exception(std::exchange(exception_, nullptr));
}

}  // namespace bodkin
