#include "views/chart_columns.h"

#include <cmath>

#include <gtest/gtest.h>

namespace bodkin::views {
namespace {

TEST(ChartCurve, a_column_has_the_least_and_the_greatest_of_its_samples) {
  ChartCurve curve(1.0);
  for (const double value : {3.0, -1.0, 2.0}) curve.add(0.5, value);
  curve.lift();
  curve.add(2.5, 7.0);
  const auto columns = curve.columns(0.0, 4.0, 4);
  EXPECT_EQ(columns[0], (ChartColumn{-1.0F, 3.0F}));
  EXPECT_TRUE(columns[1].empty()) << "the pen was lifted";
  EXPECT_EQ(columns[2], (ChartColumn{7.0F, 7.0F}));
  EXPECT_TRUE(columns[3].empty());
  EXPECT_EQ(curve.range(), (ChartColumn{-1.0F, 7.0F}));
}

TEST(ChartCurve, a_quick_needle_leaves_no_gap) {
  ChartCurve curve(1.0);
  curve.add(0.5, 0.0);
  curve.add(10.5, 10.0);
  const auto columns = curve.columns(0.0, 11.0, 11);
  for (std::size_t i = 0; i < columns.size(); ++i) EXPECT_NEAR(columns[i].most, static_cast<double>(i), 1e-5);
}

TEST(ChartCurve, a_peak_of_one_sample_survives_any_number_of_others) {
  ChartCurve curve(0.01, 256);
  for (int i = 0; i < 200000; ++i) curve.add(0.001 * i, i == 123456 ? 9.0 : std::sin(0.01 * i));
  EXPECT_LE(curve.reach() / curve.step(), 256.0 + 1e-9) << "its memory does not grow";
  const auto columns = curve.columns(0.0, 200.0, 100);
  EXPECT_EQ(columns[61].most, 9.0F) << "at 123.456 s";
  EXPECT_NEAR(columns[60].most, 1.0, 1e-3);
  EXPECT_NEAR(columns[60].least, -1.0, 1e-3);
}

TEST(ChartCurve, one_odd_tick_does_not_set_the_axis_and_a_true_peak_does) {
  ChartCurve curve(0.05);
  for (double depth = 0.0; depth < 40.0; depth += 0.05) curve.add(depth, depth == 0.0 ? 0.0 : 0.05 * depth);
  EXPECT_NEAR(curve.usual_most(), 2.0, 0.01);
  curve.lift();
  curve.add(20.0, 25.0);
  EXPECT_NEAR(curve.usual_most(), 2.0, 0.05) << "cut off";
  EXPECT_EQ(curve.range().most, 25.0F) << "but not forgotten";
  curve.lift();
  for (double depth = 39.0; depth < 41.0; depth += 0.05) curve.add(depth, 6.0);  // two millimetres of bone
  EXPECT_NEAR(curve.usual_most(), 6.0, 0.01);
  EXPECT_EQ(ChartCurve(0.1).usual_most(), 0.0);
}

TEST(ChartCurve, leaves_out_what_has_no_place) {
  ChartCurve curve(1.0);
  curve.add(-1.0, 5.0);
  curve.add(std::nan(""), 5.0);
  curve.add(1.0, std::nan(""));
  EXPECT_TRUE(curve.range().empty());
  EXPECT_EQ(curve.reach(), 0.0);
  EXPECT_TRUE(curve.columns(5.0, 5.0, 3)[0].empty()) << "an axis without length";
}

TEST(ChartCurve, begins_anew_when_it_is_cleared) {
  ChartCurve curve(0.5, 16);
  for (int i = 0; i < 100; ++i) curve.add(i, 1.0);
  EXPECT_GT(curve.step(), 0.5);
  curve.clear();
  EXPECT_EQ(curve.step(), 0.5);
  EXPECT_TRUE(curve.columns(0.0, 100.0, 10)[0].empty());
}

TEST(ChartAxis, ends_at_a_round_number_that_holds_all) {
  EXPECT_EQ(axis_end(0.0, 4.0), 4.0);
  EXPECT_EQ(axis_end(4.3, 4.0), 5.0);
  EXPECT_EQ(axis_end(6.1, 4.0), 8.0);
  EXPECT_EQ(axis_end(8.2, 4.0), 10.0);
  EXPECT_EQ(axis_end(13.0, 4.0), 20.0);
  EXPECT_EQ(axis_end(20.0, 4.0), 20.0);
  EXPECT_EQ(axis_step(60.0, 6), 10.0);
  EXPECT_EQ(axis_step(60.0, 5), 20.0);
  EXPECT_EQ(axis_step(4.0, 4), 1.0);
}

}  // namespace
}  // namespace bodkin::views
