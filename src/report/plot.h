#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "imaging/canvas.h"

namespace bodkin::report {

// A range of the x axis with a colour and a name above the plot. Neighbours of one name and colour are drawn as one.
struct PlotBand {
  double from = 0.0;
  double to = 0.0;
  std::uint32_t colour = 0;  // 0xRRGGBB
  std::string name;          // empty: only the colour
};

struct PlotSeries {
  std::string name;          // empty: not in the key
  std::vector<double> x, y;  // of equal length, finite
  std::uint32_t colour = 0x12385C;
  double width = 2.0;             // px
  bool right_axis = false;        // measured on the axis on the right
  std::vector<double> dash = {};  // px, strokes and gaps alternating; empty: a solid line
};

// The area between two lines over the axis on the left, filled; drawn below the series.
struct PlotRange {
  std::string name;                  // empty: not in the key
  std::vector<double> x, low, high;  // of equal length, finite
  std::uint32_t colour = 0x12385C;
};

// A numbered dot; its text stands in a list below the plot. Dots at (nearly) one place share a number.
struct PlotMark {
  double x = 0.0;
  double y = 0.0;
  std::string text;
};

// A vertical line with its name on its right, at the top of the plot, to mark a beginning.
struct PlotDivider {
  double x = 0.0;
  std::string name;
};

// The content of a plot.
struct Plot {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::string right_label;  // empty: no axis on the right
  std::vector<PlotBand> bands;
  std::vector<PlotRange> ranges;
  std::vector<PlotSeries> series;  // the last one on top
  std::vector<PlotMark> marks;
  std::vector<PlotDivider> dividers;
  std::optional<double> y_highest;  // limit of the y axis
  bool y_down = false;              // the y axis on the left points down
  bool names_one = false;           // a key even for a single name, if the labels do not state it
  double height = 330.0;            // px, of the plotting area; the whole image is 900 px wide
};

// The plots in one image, the first on top, with common left and right edges. Text need not be escaped. Series of
// very many points are thinned to visible detail, keeping extremes.
imaging::Canvas draw_plots(std::span<const Plot> plots);
imaging::Canvas draw_plot(const Plot& plot);

// Round numbers from `low` to `high`, about `wanted` of them: 1, 2 or 5 times a power of ten apart.
struct AxisTicks {
  std::vector<double> values;
  int decimals = 0;  // of their labels
};
AxisTicks axis_ticks(double low, double high, double wanted);

}  // namespace bodkin::report
