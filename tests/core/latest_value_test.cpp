#include "core/latest_value.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <thread>

#include <gtest/gtest.h>

namespace bodkin {
namespace {

// Large enough that a torn copy would show.
struct Sample {
  std::uint64_t number = 0;
  std::array<std::uint64_t, 31> copies{};

  static Sample of(std::uint64_t number) {
    Sample sample;
    sample.number = number;
    sample.copies.fill(number);
    return sample;
  }
  bool whole() const {
    for (const std::uint64_t copy : copies) {
      if (copy != number) return false;
    }
    return true;
  }
};

TEST(LatestValue, gives_the_first_value_until_something_is_written) {
  LatestValue<int> value(7);
  EXPECT_FALSE(value.is_fresh());
  EXPECT_EQ(value.read(), 7);
}

TEST(LatestValue, gives_the_newest_of_several_and_then_the_same_again) {
  LatestValue<int> value;
  for (int number = 1; number <= 5; ++number) value.write(number);
  EXPECT_TRUE(value.is_fresh());
  EXPECT_EQ(value.read(), 5);
  EXPECT_FALSE(value.is_fresh());
  EXPECT_EQ(value.read(), 5);
  value.write(6);
  EXPECT_EQ(value.read(), 6);
}

TEST(LatestValue, what_was_read_stays_while_more_is_written) {
  LatestValue<int> value;
  value.write(1);
  const int& held = value.read();
  for (int number = 2; number < 50; ++number) value.write(number);
  EXPECT_EQ(held, 1);
  EXPECT_EQ(value.read(), 49);
}

TEST(LatestValue, a_reader_beside_a_writer_sees_whole_values_in_order_and_the_last_one) {
  constexpr std::uint64_t writes = 200000;
  LatestValue<Sample> value;
  std::atomic<bool> started{false};
  std::thread writer([&] {
    while (!started.load()) std::this_thread::yield();
    for (std::uint64_t number = 1; number <= writes; ++number) value.write(Sample::of(number));
  });
  started = true;
  std::uint64_t last = 0, torn = 0, backwards = 0;
  while (last < writes) {
    const Sample& sample = value.read();
    if (!sample.whole()) ++torn;
    if (sample.number < last) ++backwards;
    last = sample.number;
  }
  writer.join();
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(backwards, 0u);
  EXPECT_EQ(last, writes);
}

}  // namespace
}  // namespace bodkin
