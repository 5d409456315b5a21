#include "core/thread_pool.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "core/parallel_for.h"

namespace bodkin {
namespace {

TEST(ThreadPool, calls_each_index_once_and_returns_when_all_are_done) {
  for (const int threads : {1, 2, 3, 5}) {
    ThreadPool pool(threads);
    for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
      for (int round = 0; round < 30; ++round) {
        std::vector<int> calls(count, 0);
        pool.run(count, [&calls](std::size_t index) noexcept { ++calls[index]; });
        ASSERT_EQ(static_cast<std::size_t>(std::count(calls.begin(), calls.end(), 1)), count);
      }
    }
  }
}

TEST(ThreadPool, wakes_sleeping_threads_and_ends_unused_ones) {
  const ThreadPool unused(3);
  ThreadPool pool(3);
  std::atomic<int> sum{0};
  for (int round = 0; round < 3; ++round) {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    pool.run(10, [&sum](int index) { sum += index; });
  }
  EXPECT_EQ(sum, 3 * 45);
}

TEST(ThreadPool, a_loop_reads_what_the_loop_before_it_wrote) {
  ThreadPool pool(2);
  std::vector<int> values(64), shifted(64);
  std::iota(values.begin(), values.end(), 0);
  for (int round = 0; round < 200; ++round) {
    pool.run(values.size(),
             [&](std::size_t index) noexcept { shifted[index] = values[(index + 1) % values.size()]; });
    pool.run(values.size(), [&](std::size_t index) noexcept { values[index] = shifted[index]; });
  }
  EXPECT_EQ(values[0], 200 % 64);
}

// Each thread adds to its own place without synchronisation; ThreadSanitizer would detect a shared one.
TEST(ThreadPool, tells_apart_the_threads_that_work_at_the_same_time) {
  ThreadPool pool(4);
  ASSERT_LE(pool.threads(), 4);
  std::vector<long> sums(static_cast<std::size_t>(pool.threads()), 0);
  for (int round = 0; round < 100; ++round) {
    pool.run(50, [&sums](int index, int thread) noexcept { sums[static_cast<std::size_t>(thread)] += index; });
  }
  EXPECT_EQ(std::accumulate(sums.begin(), sums.end(), 0L), 100L * 49 * 50 / 2);
}

TEST(ThreadPool, throws_the_exception_of_an_iteration_and_can_be_used_again) {
  for (const int threads : {1, 3}) {
    ThreadPool pool(threads);
    for (int round = 0; round < 20; ++round) {
      std::atomic<int> calls{0};
      const auto fail_once = [&calls](int index) {
        if (index == 5) throw std::runtime_error("iteration 5");
        ++calls;
      };
      std::string message;
      try {
        pool.run(100000, fail_once);
      } catch (const std::runtime_error& error) {
        message = error.what();
      }
      EXPECT_EQ(message, "iteration 5");
      if (threads == 1) {
        EXPECT_EQ(calls, 5);
      }
      calls = 0;
      pool.run(5, fail_once);
      EXPECT_EQ(calls, 5);
    }
  }
}

TEST(ParallelFor, calls_each_index_once) {
  for (const int count : {-1, 0, 1, 2, 100}) {
    std::vector<int> calls(static_cast<std::size_t>(std::max(count, 0)), 0);
    parallel_for(count, [&calls](int index) { ++calls[static_cast<std::size_t>(index)]; });
    EXPECT_EQ(std::count(calls.begin(), calls.end(), 1), std::max(count, 0));
  }
}

TEST(ParallelFor, reports_progress_in_ascending_order_from_the_calling_thread) {
  std::vector<double> fractions;
  std::vector<int> calls(1000, 0);
  parallel_for(
      1000, "counting",
      [&fractions](std::string_view stage, double fraction) {
        EXPECT_EQ(stage, "counting");
        fractions.push_back(fraction);
      },
      [&calls](int index) { ++calls[static_cast<std::size_t>(index)]; });
  EXPECT_EQ(std::count(calls.begin(), calls.end(), 1), 1000);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_LE(fractions.size(), 26U);
  ASSERT_FALSE(fractions.empty());
  EXPECT_EQ(fractions.back(), 1.0);
}

// A caller cancels a long computation by throwing from its progress function.
TEST(ParallelFor, an_exception_from_progress_ends_the_loop) {
  std::atomic<int> calls{0};
  EXPECT_THROW(parallel_for(
                   100000, "cancelled", [](std::string_view, double) { throw std::runtime_error("stop"); },
                   [&calls](int) { ++calls; }, 1),
               std::runtime_error);
  EXPECT_EQ(calls, 0);
}

}  // namespace
}  // namespace bodkin
