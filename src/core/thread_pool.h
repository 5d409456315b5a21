#pragma once

#include <atomic>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <thread>
#include <type_traits>
#include <vector>

namespace bodkin {

// A fixed set of threads that execute the iterations of a loop, for callers that run many loops in a row. The calling
// thread works too. Iterations are assigned one at a time in ascending order, so a thread that starts late or is
// interrupted delays no other. A result does not depend on the number of threads as long as each iteration writes
// only its own part of it.
//
// A loop neither locks nor allocates. Between loops the threads spin for some microseconds, then sleep.
//
// One loop at a time: run() must not be called from two threads at once, nor from within an iteration.
class ThreadPool {
  template <typename Index, typename Work>
  static constexpr bool takes_thread = std::is_invocable_v<const Work&, Index, int>;
  template <typename Index, typename Work>
  static constexpr bool never_throws =
      takes_thread<Index, Work> ? std::is_nothrow_invocable_v<const Work&, Index, int>
                                : std::is_nothrow_invocable_v<const Work&, Index>;

 public:
  // `threads`: including the calling one, at least 1; 0: one per core. If the system refuses to start that many, the
  // pool uses those that started.
  explicit ThreadPool(int threads = 0);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  // Including the calling thread.
  int threads() const noexcept { return static_cast<int>(helpers_.size()) + 1; }

  // Calls work(index) or work(index, thread) once for each index from 0 to count - 1 and returns when all calls have
  // returned. `count`: below 2^32; no calls below 1. `thread` is below threads() and differs between calls that run
  // at the same time: use it to select working memory; 0 is the calling thread. After an exception the indices that
  // have not started are skipped, and the first exception is thrown from here.
  template <std::integral Index, typename Work>
  void run(Index count, const Work& work) noexcept(never_throws<Index, Work>) {
    if (count < 1) return;
    if (helpers_.empty() || count == 1) {
      for (Index index = 0; index < count; ++index) call(work, index, 0);
      return;
    }
    run_loop(
        static_cast<std::size_t>(count),
        [](ThreadPool& pool, const void* erased, std::size_t index, int thread) noexcept {
          const Work& each = *static_cast<const Work*>(erased);
          if constexpr (never_throws<Index, Work>) {
            call(each, static_cast<Index>(index), thread);
          } else {
            if (pool.failed_.load(std::memory_order_relaxed)) return;
            try {
              call(each, static_cast<Index>(index), thread);
            } catch (...) {
              pool.keep_exception();
            }
          }
        },
        std::addressof(work));
    if constexpr (!never_throws<Index, Work>) rethrow_exception();
  }

 private:
  template <typename Index, typename Work>
  static void call(const Work& work, Index index, int thread) noexcept(never_throws<Index, Work>) {
    if constexpr (takes_thread<Index, Work>) {
      work(index, thread);
    } else {
      work(index);
    }
  }

  using Call = void (*)(ThreadPool& pool, const void* work, std::size_t index, int thread) noexcept;

  void run_loop(std::size_t count, Call callback, const void* work) noexcept;
  void execute_iterations(int thread) noexcept;
  void serve(int thread) noexcept;
  void keep_exception() noexcept;
  void rethrow_exception();

  static constexpr std::size_t cache_line = 64;

  // The loop that is running. Written before its indices are assigned; a thread reads it only while it holds one.
  Call call_ = nullptr;
  const void* work_ = nullptr;
  std::size_t count_ = 0;
  std::exception_ptr exception_;  // written by the thread that sets failed_

  // Upper half: number of the loop. Lower half: number of its indices not yet assigned.
  alignas(cache_line) std::atomic<std::uint64_t> remaining_{0};
  alignas(cache_line) std::atomic<std::uint32_t> unfinished_{0};  // indices whose call has not returned
  alignas(cache_line) std::atomic<std::uint32_t> loop_{0};        // what the threads sleep on
  std::atomic<bool> failed_{false}, ends_{false};
  std::vector<std::thread> helpers_;
};

}  // namespace bodkin
