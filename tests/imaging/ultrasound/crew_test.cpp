#include "imaging/ultrasound/crew.h"

#include <atomic>
#include <chrono>
#include <numeric>

#include <gtest/gtest.h>

namespace bodkin {
namespace {

TEST(Crew, does_every_turn_once_and_is_done_when_it_says_so) {
  for (const int threads : {1, 2, 3, 5}) {
    Crew crew(threads);
    for (const int count : {0, 1, 2, 7, 100}) {
      for (int round = 0; round < 30; ++round) {
        std::vector<int> done(static_cast<std::size_t>(count), 0);
        auto work = [&done](int turn) noexcept { ++done[static_cast<std::size_t>(turn)]; };
        crew.share(count, work);
        ASSERT_EQ(std::count(done.begin(), done.end(), 1), count);
      }
    }
  }
}

// Helpers that have gone to sleep come back, and those that never worked can be let go.
TEST(Crew, wakes_up_and_goes_home) {
  Crew idle(3);
  Crew crew(3);
  std::atomic<int> sum{0};
  auto work = [&sum](int turn) noexcept { sum += turn; };
  for (int round = 0; round < 3; ++round) {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    crew.share(10, work);
  }
  EXPECT_EQ(sum, 3 * 45);
}

// What one loop has written the next one reads, wherever it was computed.
TEST(Crew, loops_see_what_the_loop_before_wrote) {
  Crew crew(2);
  std::vector<int> values(64);
  std::iota(values.begin(), values.end(), 0);
  for (int round = 0; round < 200; ++round) {
    std::vector<int> shifted(values.size());
    auto shift = [&](int turn) noexcept {
      shifted[static_cast<std::size_t>(turn)] = values[static_cast<std::size_t>(turn + 1) % values.size()];
    };
    crew.share(64, shift);
    auto copy = [&](int turn) noexcept {
      values[static_cast<std::size_t>(turn)] = shifted[static_cast<std::size_t>(turn)];
    };
    crew.share(64, copy);
  }
  EXPECT_EQ(values[0], 200 % 64);
}

}  // namespace
}  // namespace bodkin
