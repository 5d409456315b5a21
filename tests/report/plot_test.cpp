#include "report/plot.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "io/run_program.h"

namespace bodkin {

using namespace bodkin::imaging;
using namespace bodkin::io;
using namespace bodkin::report;
namespace {

void expect_well_formed(const std::string& svg) {
  const ProgramResult result = run_program({"xmllint", "--huge", "--noout", "-"}, svg, "libxml2-utils");
  EXPECT_EQ(result.exit_code, 0) << result.errors.substr(0, 500);
}

Plot ramp() {
  Plot plot;
  plot.title = "a ramp";
  plot.x_label = "depth, mm";
  plot.y_label = "force, N";
  plot.series = {{"force", {0.0, 10.0}, {0.0, 2.0}}};
  return plot;
}

TEST(Plot, is_a_well_formed_picture_with_its_labels) {
  Plot plot = ramp();
  plot.bands = {{0.0, 4.0, 0xE0A080, "skin"}, {4.0, 10.0, 0xF0D070, "fat"}};
  plot.marks = {{4.0, 0.8, "skin gives way"}};
  const std::string svg = draw_plot(plot).svg();
  expect_well_formed(svg);
  for (const char* text : {"a ramp", "depth, mm", "force, N", "skin", "fat", "skin gives way"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  }
}

TEST(Plot, text_is_text_whatever_it_is) {
  Plot plot = ramp();
  for (const std::string& text : {std::string("<script>alert(1)</script>"), std::string("it's \"quoted\" & \xff\x01"),
                                  std::string("]]> --> <![CDATA[")}) {
    plot.title = plot.x_label = plot.y_label = plot.right_label = text;
    plot.series[0].name = text;
    plot.bands = {{0.0, 4.0, 0xE0A080, text}};
    plot.marks = {{1.0, 1.0, text}};
    const std::string svg = draw_plot(plot).svg();
    expect_well_formed(svg);
    EXPECT_EQ(svg.find("<script"), std::string::npos);
  }
}

// Columns of a row, or rows of a column, in which a picture has a colour.
std::vector<int> columns_of(const ImageRgb& image, int row, std::uint32_t colour) {
  std::vector<int> found;
  for (int column = 0; column < image.width; ++column) {
    if (image.at(column, row) == rgb(colour)) found.push_back(column);
  }
  return found;
}
std::vector<int> rows_of(const ImageRgb& image, int column, std::uint32_t colour) {
  std::vector<int> found;
  for (int row = 0; row < image.height; ++row) {
    if (image.at(column, row) == rgb(colour)) found.push_back(row);
  }
  return found;
}

TEST(Plot, a_range_is_filled_between_its_lines_and_stands_in_the_key) {
  Plot plot = ramp();
  plot.series[0].y = {9.0, 9.0};
  plot.ranges = {{"experts", {0.0, 10.0}, {2.0, 2.0}, {6.0, 6.0}, 0xFF0000}};
  const ImageRgb image = draw_plot(plot).pixels(1.0);
  // Down the middle of the plot the fill is one stretch, from 6 N to 2 N of an axis from 0 to 9.72 N.
  const int column = 300;
  std::vector<int> rows;
  for (int row = 0; row < image.height; ++row)
    if (image.at(column, row).red > image.at(column, row).blue + 20) rows.push_back(row);
  ASSERT_FALSE(rows.empty());
  EXPECT_NEAR((rows.back() - rows.front() + 1) / 330.0, 4.0 / 9.56, 0.03);
  EXPECT_NE(draw_plot(plot).svg().find("experts"), std::string::npos);
}

TEST(Plot, curves_lie_where_the_axes_say) {
  Plot plot;
  plot.x_label = "depth, mm";
  plot.series = {{"", {0.0, 10.0}, {0.0, 0.0}, 0x010101},     {"", {2.0, 2.0}, {0.0, 4.0}, 0xFF0000, 3.0},
                 {"", {6.0, 6.0}, {0.0, 4.0}, 0x0000FF, 3.0}, {"", {4.0, 4.0}, {0.0, 4.0}, 0x008000, 3.0},
                 {"", {7.0, 9.0}, {2.0, 2.0}, 0xFF00FF, 3.0}, {"", {7.0, 9.0}, {1.0, 1.0}, 0x00FFFF, 3.0},
                 {"", {7.0, 9.0}, {3.0, 3.0}, 0xFFFF00, 3.0}};
  for (const bool down : {false, true}) {
    plot.y_down = down;
    const ImageRgb image = draw_plot(plot).pixels(1.0);
    const int row = 12 + 200;
    const std::vector<int> two = columns_of(image, row, 0xFF0000), four = columns_of(image, row, 0x008000),
                           six = columns_of(image, row, 0x0000FF);
    ASSERT_FALSE(two.empty() || four.empty() || six.empty());
    EXPECT_NEAR(four[0] - two[0], six[0] - four[0], 1);
    // Each tenth of the way is a tenth of the axis: from 0 at px 76 to 10 at px 866.
    EXPECT_NEAR(0.5 * (four.front() + four.back()), 76.0 + 0.4 * 790.0, 1.0);
    const int column = 76 + 632;  // x = 8
    const std::vector<int> low = rows_of(image, column, 0x00FFFF), middle = rows_of(image, column, 0xFF00FF),
                           high = rows_of(image, column, 0xFFFF00);
    ASSERT_FALSE(low.empty() || middle.empty() || high.empty());
    EXPECT_NEAR(low[0] - middle[0], middle[0] - high[0], 1);
    EXPECT_EQ(low[0] > high[0], !down);
    // From 0 at one edge to 4 and some headroom, 0.32, at the other, over 330 px.
    EXPECT_NEAR(std::abs(low[0] - high[0]), 330.0 * 2.0 / 4.32, 1.5);
  }
}

TEST(Plot, a_curve_on_the_right_axis_is_measured_there) {
  Plot plot = ramp();
  plot.right_label = "depth, mm";
  plot.series = {{"", {0.0, 10.0}, {0.0, 2.0}, 0xFF0000, 3.0}, {"", {0.0, 10.0}, {0.0, 200.0}, 0x0000FF, 3.0, true}};
  const ImageRgb image = draw_plot(plot).pixels(1.0);
  EXPECT_TRUE(rows_of(image, 400, 0xFF0000).empty()) << "hidden by the one on top of it";
  EXPECT_FALSE(rows_of(image, 400, 0x0000FF).empty());
}

TEST(Plot, what_lies_beyond_the_axis_is_cut_off) {
  Plot plot = ramp();
  plot.series = {{"", {0.0, 5.0, 10.0}, {0.0, 100.0, 1.0}, 0xFF0000, 3.0}};
  plot.y_highest = 2.0;
  const ImageRgb image = draw_plot(plot).pixels(1.0);
  for (int column = 0; column < image.width; ++column) {
    for (const int row : rows_of(image, column, 0xFF0000)) EXPECT_GE(row, 56) << column;
  }
}

TEST(Plot, ticks_are_round_numbers_that_span_the_axis) {
  const AxisTicks tenths = axis_ticks(0.0, 1.08, 6.0);
  ASSERT_EQ(tenths.values.size(), 6U);
  EXPECT_NEAR(tenths.values[1], 0.2, 1e-12);
  EXPECT_EQ(tenths.decimals, 1);
  EXPECT_EQ(axis_ticks(-150.0, 150.0, 7.0).values, (std::vector<double>{-150, -100, -50, 0, 50, 100, 150}));
  EXPECT_EQ(axis_ticks(1e6, 3e6, 4.0).decimals, 0);
  EXPECT_EQ(axis_ticks(0.0, 0.004, 4.0).decimals, 3);
  for (const double span : {1e-6, 0.3, 7.0, 23.0, 1e5}) {
    const std::size_t count = axis_ticks(-0.31 * span, 0.69 * span, 8.0).values.size();
    EXPECT_GE(count, 3U) << span;
    EXPECT_LE(count, 9U) << span;
  }
}

TEST(Plot, a_long_series_is_thinned_and_its_peaks_stay) {
  Plot plot = ramp();
  plot.y_highest.reset();
  PlotSeries& series = plot.series[0];
  series.x.clear();
  series.y.clear();
  for (int i = 0; i < 300000; ++i) {
    series.x.push_back(0.001 * i);
    series.y.push_back(i == 123457 ? 50.0 : std::sin(0.01 * i));
  }
  const std::string tall = draw_plot(plot).svg();
  EXPECT_LT(tall.size(), 300000U);
  EXPECT_NE(tall.find(">50<"), std::string::npos);  // the axis still reaches up to the one sample
}

TEST(Plot, neighbouring_bands_of_one_name_are_named_once) {
  Plot plot = ramp();
  plot.bands = {{0.0, 2.0, 0xE0A080, "muscle"}, {2.0, 5.0, 0xE0A080, "muscle"}, {5.0, 6.0, 0xF0D070, "fat"}};
  const std::string svg = draw_plot(plot).svg();
  EXPECT_EQ(svg.find("muscle"), svg.rfind("muscle"));
}

TEST(Plot, marks_at_one_place_share_a_number) {
  Plot plot = ramp();
  plot.marks = {{5.0, 1.0, "one"}, {5.0, 1.0, "two"}, {9.0, 1.8, "three"}};
  EXPECT_NE(draw_plot(plot).svg().find("one; two"), std::string::npos);
}

TEST(Plot, plots_stand_below_each_other_in_one_picture) {
  std::vector<Plot> plots = {ramp(), ramp()};
  plots[1].title = "another ramp";
  plots[1].height = 200.0;
  plots[1].dividers = {{5.0, "half way"}};
  const std::string svg = draw_plots(plots).svg();
  expect_well_formed(svg);
  for (const char* text : {"a ramp", "another ramp", "half way"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  const auto height = [](const std::string& picture) {
    const auto box = picture.find("viewBox=\"0 0 900 ");
    return std::stod(picture.substr(box + std::string("viewBox=\"0 0 900 ").size()));
  };
  EXPECT_EQ(height(svg),
            height(draw_plots(std::span(plots).first(1)).svg()) + height(draw_plots(std::span(plots).last(1)).svg()));
}

TEST(Plot, a_single_series_is_named_where_the_plot_asks_for_it) {
  Plot plot = ramp();
  plot.series[0].name = "wall";
  EXPECT_EQ(draw_plot(plot).svg().find(">wall<"), std::string::npos);
  plot.names_one = true;
  EXPECT_NE(draw_plot(plot).svg().find(">wall<"), std::string::npos);
}

TEST(Plot, a_long_key_names_every_series_and_shows_its_dashes) {
  Plot plot = ramp();
  plot.series.clear();
  for (int i = 0; i < 11; ++i) {
    plot.series.push_back({.name = "series number " + std::to_string(i), .x = {0.0, 10.0}, .y = {0.0, 0.1 * i}});
    if (i % 2 == 1) plot.series.back().dash = {6, 3};
  }
  const std::string svg = draw_plot(plot).svg();
  expect_well_formed(svg);
  for (const PlotSeries& series : plot.series) EXPECT_NE(svg.find(series.name), std::string::npos) << series.name;
  // Five dashed lines and their five samples in the key.
  std::size_t dashed = 0;
  for (auto at = svg.find("stroke-dasharray=\"6 3"); at != std::string::npos;
       at = svg.find("stroke-dasharray=\"6 3", at + 1))
    ++dashed;
  EXPECT_EQ(dashed, 10U);
}

TEST(Plot, nothing_at_all_and_a_flat_line_can_be_drawn) {
  expect_well_formed(draw_plot(Plot{}).svg());
  Plot flat = ramp();
  flat.series = {{"", {1.0, 1.0}, {0.0, 0.0}}};
  expect_well_formed(draw_plot(flat).svg());
}

}  // namespace
}  // namespace bodkin
