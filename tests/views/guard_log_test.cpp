#include "views/guard_log.h"

#include <numeric>

#include <gtest/gtest.h>

namespace bodkin::views {
namespace {

using haptics::GuardReason;
using haptics::GuardState;

std::uint32_t bit(GuardReason reason) {
  return 1U << static_cast<std::uint32_t>(reason);
}

TEST(GuardLog, names_states_and_why_the_force_went_away) {
  GuardLog log;
  log.note(0.0, GuardState::disarmed, GuardReason::none, 0);
  EXPECT_TRUE(log.lines().empty()) << "nothing happened";
  log.note(0.1, GuardState::ramping, GuardReason::none, 0);
  log.note(1.1, GuardState::active, GuardReason::none, 0);
  log.note(4.0, GuardState::faulted, GuardReason::too_fast, 0);
  ASSERT_EQ(log.lines().size(), 3U);
  EXPECT_TRUE(log.lines()[0].bad);
  EXPECT_EQ(log.lines()[0].words, "no force: " + std::string(haptics::text_of(GuardReason::too_fast)));
  EXPECT_EQ(log.lines()[0].time, 4.0);
  EXPECT_EQ(log.lines()[2].words, "ramping");
}

TEST(GuardLog, a_limit_is_a_line_when_it_begins_and_is_counted) {
  GuardLog log;
  for (int i = 0; i < 10; ++i) log.note(0.1 * i, GuardState::disarmed, GuardReason::none, bit(GuardReason::peak));
  ASSERT_EQ(log.lines().size(), 1U);
  EXPECT_EQ(log.lines()[0].times, 1);
  log.note(2.0, GuardState::disarmed, GuardReason::none, 0);
  log.note(3.0, GuardState::disarmed, GuardReason::none, bit(GuardReason::peak));
  ASSERT_EQ(log.lines().size(), 1U);
  EXPECT_EQ(log.lines()[0].times, 2);
  EXPECT_EQ(log.lines()[0].time, 3.0);
}

TEST(GuardLog, keeps_the_newest) {
  GuardLog log;
  for (int i = 0; i < 200; ++i) {
    log.note(i, i % 2 == 0 ? GuardState::ramping : GuardState::active, GuardReason::none, 0);
  }
  EXPECT_EQ(log.lines().size(), GuardLog::most_lines);
  EXPECT_EQ(log.lines().front().time, 199.0);
}

TEST(GuardLog, a_sentence_stands_at_its_own_time_where_it_has_one) {
  GuardLog log;
  log.note(2.0, "0.5 s: second hand: armed");
  EXPECT_EQ(log.lines().front().time, 0.5);
  EXPECT_EQ(log.lines().front().words, "second hand: armed");
  for (const char* sentence : {"calibrated 2026-11-02", "3 supports are in a line", "12 s", "", "1.5 N: the bone"}) {
    log.note(3.0, sentence);
    EXPECT_EQ(log.lines().front().time, 3.0) << sentence;
    EXPECT_EQ(log.lines().front().words, sentence);
  }
}

TEST(HistogramColumns, every_value_is_in_one_column_of_the_logarithmic_axis) {
  haptics::LatencyHistogram histogram;
  for (int i = 0; i < 90; ++i) histogram.record(12e-6);
  for (int i = 0; i < 9; ++i) histogram.record(150e-6);
  histogram.record(0.5);  // outside the axis
  const auto columns = histogram_columns(histogram, 1e-6, 1e-2, 4);
  EXPECT_NEAR(columns[0], 0.0, 1e-12);
  EXPECT_NEAR(columns[1], 0.90, 1e-12) << "10 to 100 us";
  EXPECT_NEAR(columns[2], 0.09, 1e-12);
  EXPECT_NEAR(columns[3], 0.01, 1e-12);
  EXPECT_NEAR(std::accumulate(columns.begin(), columns.end(), 0.0), 1.0, 1e-12);
  const auto empty = histogram_columns(haptics::LatencyHistogram(), 1e-6, 1e-2, 4);
  EXPECT_EQ(empty, std::vector<double>(4, 0.0));
}

}  // namespace
}  // namespace bodkin::views
