#include "report/plot.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "imaging/tool.h"

namespace bodkin {
namespace {

void expect_well_formed(const std::string& svg) {
  const ToolResult result = run_tool({"xmllint", "--huge", "--noout", "-"}, svg, "libxml2-utils");
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
  const std::string svg = plot_svg(plot);
  expect_well_formed(svg);
  for (const char* text : {"a ramp", "depth, mm", "force, N", "skin", "fat", "skin gives way"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  }
}

TEST(Plot, text_cannot_reach_the_shell_or_leave_its_command) {
  const std::filesystem::path proof = std::filesystem::path(testing::TempDir()) / "plot_was_tricked";
  std::filesystem::remove(proof);
  Plot plot = ramp();
  for (const std::string& text :
       {"`touch " + proof.string() + "`", "'\nsystem 'touch " + proof.string() + "'\n",
        "\"; !touch " + proof.string(), std::string("it's {/*9 huge} _x ^2 \\n @home <&>")}) {
    plot.title = plot.x_label = plot.y_label = plot.right_label = text;
    plot.series[0].name = text;
    plot.bands = {{0.0, 4.0, 0xE0A080, text}};
    plot.marks = {{1.0, 1.0, text}};
    expect_well_formed(plot_svg(plot));
    EXPECT_FALSE(std::filesystem::exists(proof)) << text;
  }
  EXPECT_NE(plot_svg(plot).find("it\u2019s {/*9 huge} _x ^2 \\n @home &lt;&amp;>"), std::string::npos);
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
  const std::string tall = plot_svg(plot);
  EXPECT_LT(tall.size(), 300000U);
  EXPECT_NE(tall.find("> 50<"), std::string::npos);  // the axis still reaches up to the one sample
}

TEST(Plot, neighbouring_bands_of_one_name_are_named_once) {
  Plot plot = ramp();
  plot.bands = {{0.0, 2.0, 0xE0A080, "muscle"}, {2.0, 5.0, 0xE0A080, "muscle"}, {5.0, 6.0, 0xF0D070, "fat"}};
  const std::string svg = plot_svg(plot);
  EXPECT_EQ(svg.find("muscle"), svg.rfind("muscle"));
}

TEST(Plot, marks_at_one_place_share_a_number) {
  Plot plot = ramp();
  plot.marks = {{5.0, 1.0, "one"}, {5.0, 1.0, "two"}, {9.0, 1.8, "three"}};
  EXPECT_NE(plot_svg(plot).find("one; two"), std::string::npos);
}

TEST(Plot, plots_stand_below_each_other_in_one_picture) {
  std::vector<Plot> plots = {ramp(), ramp()};
  plots[1].title = "another ramp";
  plots[1].height = 200.0;
  plots[1].dividers = {{5.0, "half way"}};
  const std::string svg = plot_svg(plots);
  expect_well_formed(svg);
  for (const char* text : {"a ramp", "another ramp", "half way"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  const auto height = [](const std::string& picture) {
    const auto box = picture.find("viewBox=\"0 0 900 ");
    return std::stod(picture.substr(box + std::string("viewBox=\"0 0 900 ").size()));
  };
  EXPECT_EQ(height(svg), height(plot_svg(std::span(plots).first(1))) + height(plot_svg(std::span(plots).last(1))));
}

TEST(Plot, a_long_key_names_every_series_and_shows_its_dashes) {
  Plot plot = ramp();
  plot.series.clear();
  for (int i = 0; i < 11; ++i) {
    plot.series.push_back({.name = "series number " + std::to_string(i), .x = {0.0, 10.0}, .y = {0.0, 0.1 * i}});
    if (i % 2 == 1) plot.series.back().dash = {6, 3};
  }
  const std::string svg = plot_svg(plot);
  expect_well_formed(svg);
  for (const PlotSeries& series : plot.series) EXPECT_NE(svg.find(series.name), std::string::npos) << series.name;
  // Five dashed lines and their five samples in the key.
  std::size_t dashed = 0;
  for (auto at = svg.find("stroke-dasharray='6.0,3.0"); at != std::string::npos;
       at = svg.find("stroke-dasharray='6.0,3.0", at + 1))
    ++dashed;
  EXPECT_EQ(dashed, 10U);
}

TEST(Plot, nothing_at_all_and_a_flat_line_can_be_drawn) {
  expect_well_formed(plot_svg(Plot{}));
  Plot flat = ramp();
  flat.series = {{"", {1.0, 1.0}, {0.0, 0.0}}};
  expect_well_formed(plot_svg(flat));
}

}  // namespace
}  // namespace bodkin
