#include "core/hand_over.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

namespace bodkin {
namespace {

// Knows how many of its kind there are, and on which thread it was destroyed.
struct Load {
  explicit Load(std::uint64_t of) : number(of) {
    copies.fill(of);
    ++alive;
  }
  ~Load() {
    --alive;
    if (std::this_thread::get_id() == taker) ++destroyed_by_taker;
    copies.fill(0);
  }
  Load(const Load&) = delete;
  Load& operator=(const Load&) = delete;
  bool whole() const {
    for (const std::uint64_t copy : copies) {
      if (copy != number) return false;
    }
    return true;
  }

  std::uint64_t number;
  std::array<std::uint64_t, 31> copies{};
  static inline std::atomic<int> alive{0}, destroyed_by_taker{0};
  static inline std::thread::id taker;
};

TEST(HandOver, of_several_the_newest_is_taken_once) {
  HandOver<Load> hand_over;
  EXPECT_FALSE(hand_over.waits());
  EXPECT_EQ(hand_over.take(), nullptr);
  for (std::uint64_t number = 1; number <= 5; ++number) hand_over.offer(std::make_unique<Load>(number));
  EXPECT_TRUE(hand_over.waits());
  EXPECT_EQ(hand_over.take()->number, 5U);
  EXPECT_FALSE(hand_over.waits());
  EXPECT_EQ(hand_over.take(), nullptr);
}

TEST(HandOver, the_maker_destroys_what_was_not_taken_and_what_was_left) {
  {
    HandOver<Load> hand_over;
    auto held = std::make_unique<Load>(0);
    hand_over.offer(std::make_unique<Load>(1));
    EXPECT_EQ(Load::alive, 2);
    hand_over.offer(std::make_unique<Load>(2));  // 1 was never taken
    EXPECT_EQ(Load::alive, 2);
    auto taken = hand_over.take();
    held.swap(taken);
    hand_over.give_back(std::move(taken));
    EXPECT_EQ(Load::alive, 2);  // 0 was left, not destroyed
    hand_over.free_returned();
    EXPECT_EQ(Load::alive, 1);
    hand_over.free_returned();
    hand_over.offer(std::make_unique<Load>(3));
    taken = hand_over.take();
    EXPECT_EQ(taken->number, 3U);
    held.swap(taken);
    hand_over.give_back(std::move(taken));
    hand_over.offer(std::make_unique<Load>(4));  // and frees 2
    EXPECT_EQ(Load::alive, 2);
  }
  EXPECT_EQ(Load::alive, 0);
}

TEST(HandOver, a_taker_beside_a_maker_gets_whole_ones_in_order_and_the_last_and_destroys_none) {
  constexpr std::uint64_t offers = 20000;
  {
    HandOver<Load> hand_over;
    Load::taker = std::this_thread::get_id();
    Load::destroyed_by_taker = 0;
    std::atomic<bool> started{false};
    std::thread maker([&] {
      while (!started.load()) std::this_thread::yield();
      for (std::uint64_t number = 1; number <= offers; ++number) {
        hand_over.offer(std::make_unique<Load>(number));
        if (number % 3 == 0) hand_over.free_returned();
        if (number % 64 == 0) std::this_thread::yield();
      }
    });
    auto held = std::make_unique<Load>(0);
    started = true;
    std::uint64_t torn = 0, backwards = 0;
    int most_alive = 0;
    while (held->number < offers) {
      if (auto taken = hand_over.take()) {
        if (taken->number <= held->number) ++backwards;
        held.swap(taken);
        hand_over.give_back(std::move(taken));
      }
      most_alive = std::max(most_alive, Load::alive.load());
      if (!held->whole()) ++torn;
    }
    maker.join();
    EXPECT_EQ(torn, 0U);
    EXPECT_EQ(backwards, 0U);
    EXPECT_EQ(held->number, offers);
    EXPECT_LE(most_alive, 6);  // held, waiting, being made, and those on their way back
    EXPECT_EQ(Load::destroyed_by_taker, 0);
    Load::taker = {};
  }
  EXPECT_EQ(Load::alive, 0);
}

}  // namespace
}  // namespace bodkin
