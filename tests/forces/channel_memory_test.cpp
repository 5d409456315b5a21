#include "forces/channel_memory.h"

#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::forces;
namespace {

Vec3 place(std::size_t number) {
  return {10.0 * static_cast<double>(number), 0.0, 0.0};
}

TEST(ChannelMemory, remembers_how_deep_each_channel_was_cut) {
  ChannelMemory memory(1.0, 3.0);
  EXPECT_TRUE(memory.enter(place(0), Vec3::UnitZ()));
  memory.deepen(5.0);
  memory.deepen(3.0);  // on the way out
  EXPECT_TRUE(memory.enter(place(1), Vec3::UnitZ()));
  EXPECT_EQ(memory.deepest(), 0.0);
  EXPECT_FALSE(memory.enter(place(0), Vec3::UnitZ()));
  EXPECT_EQ(memory.deepest(), 5.0);
}

TEST(ChannelMemory, forgets_the_oldest_channels_one_by_one_when_it_is_full) {
  ChannelMemory memory(1.0, 3.0);
  for (std::size_t number = 0; number < ChannelMemory::capacity + 2; ++number) {
    EXPECT_TRUE(memory.enter(place(number), Vec3::UnitZ()));
    memory.deepen(1.0 + static_cast<double>(number));
  }
  EXPECT_EQ(memory.size(), ChannelMemory::capacity);
  for (std::size_t number = 2; number < ChannelMemory::capacity + 2; ++number) {
    EXPECT_FALSE(memory.enter(place(number), Vec3::UnitZ())) << number;
    EXPECT_EQ(memory.deepest(), 1.0 + static_cast<double>(number));
  }
  EXPECT_TRUE(memory.enter(place(0), Vec3::UnitZ()));
  EXPECT_EQ(memory.deepest(), 0.0);
}

}  // namespace
}  // namespace bodkin
