#include "study/fitting/measured_curve.h"

#include <cmath>
#include <functional>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::study;
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A table of `rows` rows: a header, and each row's text from its number.
std::string table(const std::string& header, const std::function<std::string(int)>& row, int rows = 20) {
  std::string text = header + "\n";
  for (int i = 0; i < rows; ++i) text += row(i) + "\n";
  return text;
}

std::string refusal(const std::string& text) {
  try {
    parse_measured_curve(text, "curve.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(MeasuredCurve, reads_commas_semicolons_and_tabs_in_any_order_of_columns) {
  for (const char separator : {',', ';', '\t'}) {
    const std::string text =
        "# 22G in gelatine\n" + table(fmt::format("force_N{0}depth_mm{0}time_s", separator), [&](int i) {
          return fmt::format("{1}{0}{2}{0}{3}", separator, 0.1 * i, i, 0.25 * i) + (i == 3 ? "\n# a remark" : "");
        });
    const MeasuredCurve curve = parse_measured_curve(text, "curve.csv");
    ASSERT_EQ(curve.size(), 20U);
    EXPECT_EQ(curve.depth[3], 3.0);
    EXPECT_EQ(curve.time[3], 0.75);
    EXPECT_EQ(curve.force[19], 0.1 * 19);
  }
}

TEST(MeasuredCurve, needs_no_times_but_then_a_speed) {
  const MeasuredCurve curve = parse_measured_curve(
      table("depth_mm,force_N", [](int i) { return fmt::format("{},1", i < 10 ? i : 20 - i); }), "curve.csv");
  EXPECT_TRUE(curve.time.empty());
  EXPECT_THROW(sample_times(curve, std::nullopt), InputError);
  const std::vector<double> times = sample_times(curve, 2.0);
  EXPECT_THAT(std::vector<double>(times.begin(), times.begin() + 3), ElementsAre(0.0, 0.5, 1.0));
  EXPECT_EQ(times.back(), 9.5);  // out again: time continues
}

TEST(MeasuredCurve, refuses_what_is_not_such_a_table) {
  const auto good = [](int i) { return fmt::format("{},{},{}", 0.1 * i, i, 0.1 * i); };
  const std::string header = "time_s,depth_mm,force_N";
  const auto spoiled = [&](int at, const std::string& row) {
    return refusal(table(header, [&](int i) { return i == at ? row : good(i); }));
  };
  EXPECT_EQ(refusal(table(header, good)), "accepted");
  EXPECT_THAT(refusal(""), HasSubstr("empty"));
  EXPECT_THAT(refusal(table("1,2,3", good)), HasSubstr("expected the header time_s,depth_mm,force_N"));
  EXPECT_THAT(refusal(table("time_s,depth_mm,speed", good)), HasSubstr("column 'speed'"));
  EXPECT_THAT(refusal(table("time_s,depth_mm,force_mN", good)), HasSubstr("expected, force_N"));
  EXPECT_THAT(refusal(table("time_ms,depth_mm,force_N", good)), HasSubstr("expected, time_s"));
  EXPECT_THAT(refusal(table("time_s,depth_m,force_N", good)), HasSubstr("expected, depth_mm"));
  EXPECT_THAT(refusal(table("time_s,depth_mm,depth_mm", good)), HasSubstr("twice"));
  EXPECT_THAT(refusal(table("depth_mm", [](int i) { return std::to_string(i); })), HasSubstr("no column force_N"));
  EXPECT_THAT(refusal(table(header, good, 9)), HasSubstr("9 samples"));
  EXPECT_THAT(spoiled(4, "0.4,4"), HasSubstr("line 6: there are 2 columns"));
  EXPECT_THAT(spoiled(4, "0.4,4,nan"), HasSubstr("line 6: force_N is 'nan'"));
  EXPECT_THAT(spoiled(4, "0.4,inf,1"), HasSubstr("depth_mm is 'inf'"));
  EXPECT_THAT(spoiled(4, "0.4,,1"), HasSubstr("depth_mm is ''"));
  EXPECT_THAT(spoiled(4, "0.4,4 mm,1"), HasSubstr("expected a finite number"));
  EXPECT_THAT(spoiled(4, "0.3,4,1"), HasSubstr("line 6: time_s is 0.3 after 0.3"));
  EXPECT_THAT(spoiled(4, "0.4,4,\"1"), HasSubstr("quote"));
  EXPECT_THAT(spoiled(4, "0.4,4,\xff"), HasSubstr("0xFF"));
}

TEST(MeasuredCurve, refuses_values_in_other_units) {
  const auto scaled = [](double time, double depth, double force) {
    return refusal(table("time_s,depth_mm,force_N", [&](int i) {
      return fmt::format("{},{},{}", time * 0.1 * i, depth * i, force * 0.05 * i);
    }));
  };
  EXPECT_EQ(scaled(1.0, 1.0, 1.0), "accepted");
  EXPECT_THAT(scaled(1.0, 0.001, 1.0), HasSubstr("metres"));
  EXPECT_THAT(scaled(1.0, 1000.0, 1.0), HasSubstr("micrometres"));
  EXPECT_THAT(scaled(1.0, 1.0, 1000.0), HasSubstr("millinewtons"));
  EXPECT_THAT(scaled(1.0, 1.0, 0.0001), HasSubstr("kilonewtons"));
  EXPECT_THAT(scaled(1.0, 1.0, -1.0), HasSubstr("change their sign"));
  EXPECT_THAT(scaled(1000.0, 1.0, 1.0), HasSubstr("milliseconds"));
  EXPECT_THAT(scaled(0.001, 1.0, 1.0), HasSubstr("mm/s"));
}

}  // namespace
}  // namespace bodkin
