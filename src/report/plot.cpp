#include "report/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "report/polyline.h"
#include <fmt/format.h>

#include "core/error.h"
#include "imaging/svg.h"
#include "imaging/tool.h"

namespace bodkin {

namespace {

// px of the picture
constexpr double width = 900.0;
constexpr double left_margin = 76.0;
constexpr double right_margin = 34.0;
constexpr double right_margin_with_axis = 76.0;
constexpr double title_room = 44.0;
constexpr double axis_room = 68.0;
constexpr double key_row = 19.0;
constexpr double key_sample = 40.0;  // the piece of line before a name in the key
constexpr double key_letter = 7.7;   // width of a letter in the key
constexpr double mark_row = 19.0;
constexpr double letter = 6.7;        // width of a letter of a name
constexpr double names_slant = 50.0;  // deg
constexpr double names_apart = 19.0;  // between slanted names
constexpr double names_lift = 16.0;   // from the plot to the names: the leaders' height
constexpr double wide_band = 70.0;
constexpr double marks_apart = 15.0;
constexpr std::size_t most_points = 4000;
constexpr double invisible = 0.1;

// Text inside single quotes, where gnuplot substitutes nothing. No quote may occur in it (gnuplot does not always
// honour a doubled one), so that it becomes an apostrophe; line ends cannot leave the command. `noenhanced` switches
// markup off.
std::string gnuplot_text(const std::string& text) {
  std::string safe = "'";
  for (const char c : text) {
    if (c == '\'') {
      safe += "\u2019";
    } else {
      safe += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return safe + "'";
}

struct AxisRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// Positions as near to `wanted` (ascending) as possible, at least `apart` from each other (pool adjacent violators).
std::vector<double> spread(const std::vector<double>& wanted, double apart) {
  struct Block {
    double sum;
    double count;
  };
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    blocks.push_back({wanted[i] - apart * static_cast<double>(i), 1.0});
    while (blocks.size() > 1) {
      const Block last = blocks.back();
      Block& before = blocks[blocks.size() - 2];
      if (before.sum / before.count <= last.sum / last.count) break;
      before = {before.sum + last.sum, before.count + last.count};
      blocks.pop_back();
    }
  }
  std::vector<double> placed;
  for (const Block& block : blocks) {
    for (double i = 0.0; i < block.count; ++i) {
      placed.push_back(block.sum / block.count + apart * static_cast<double>(placed.size()));
    }
  }
  return placed;
}

// The lowest and highest point of every run of points, in their order.
std::vector<std::size_t> points_to_draw(const PlotSeries& series) {
  const std::size_t count = std::min(series.x.size(), series.y.size());
  std::vector<std::size_t> kept;
  const std::size_t run = count > most_points ? (2 * count + most_points - 1) / most_points : 1;
  for (std::size_t first = 0; first < count; first += run) {
    std::size_t low = first, high = first;
    for (std::size_t i = first; i < std::min(first + run, count); ++i) {
      if (series.y[i] < series.y[low]) low = i;
      if (series.y[i] > series.y[high]) high = i;
    }
    kept.push_back(std::min(low, high));
    if (low != high) kept.push_back(std::max(low, high));
  }
  if (count > 0 && kept.back() != count - 1) kept.push_back(count - 1);
  return kept;
}

std::vector<PlotBand> merged(const std::vector<PlotBand>& bands) {
  std::vector<PlotBand> result;
  for (const PlotBand& band : bands) {
    const bool continues = !result.empty() && result.back().name == band.name &&
                           result.back().colour == band.colour && std::abs(result.back().to - band.from) < 1e-6;
    if (continues)
      result.back().to = band.to;
    else
      result.push_back(band);
  }
  return result;
}

// How gnuplot draws a line.
std::string line_style(const PlotSeries& series) {
  std::string dash;
  for (const int length : series.dash)
    dash += fmt::format("{}{}", dash.empty() ? "" : ",", std::clamp(length, 1, 50));
  return fmt::format("lw {} lc rgb '{}' dt {}", series.width, css_colour(series.colour),
                     dash.empty() ? "solid" : "(" + dash + ")");
}

// Writes the part of a gnuplot program that draws one plot.
class Script {
 public:
  explicit Script(const Plot& plot) : plot_(plot), bands_(merged(plot.bands)) { measure(); }

  // px
  double height() const { return height_; }
  double right_edge() const { return right_edge_; }
  // Ends the plotting area further to the left, so that plots below each other share their x axis.
  void end_at(double right_edge) { right_edge_ = right_edge; }

  // `above`: px of the picture, which is `picture` px high, above this plot.
  std::string write(double above, double picture) {
    above_ = above;
    picture_ = picture;
    frame();
    bands();
    dividers();
    key();
    marks();
    series();
    return std::move(text_);
  }

 private:
  template <typename... Arguments>
  void emit(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), text, std::forward<Arguments>(arguments)...);
    text_ += '\n';
  }

  void measure() {
    for (const PlotSeries& series : plot_.series) {
      for (const double x : series.x) x_.include(x);
      for (const double y : series.y) (series.right_axis ? right_ : y_).include(y);
    }
    for (const PlotBand& band : bands_) {
      x_.include(band.from);
      x_.include(band.to);
    }
    for (AxisRange* range : {&x_, &y_, &right_}) {
      if (!(range->low < range->high))
        *range = {std::isfinite(range->low) ? range->low - 0.5 : 0.0,
                  std::isfinite(range->low) ? range->low + 0.5 : 1.0};
    }
    if (plot_.y_highest) y_.high = std::min(y_.high, *plot_.y_highest);
    y_ = with_headroom(y_);
    right_ = with_headroom(right_);

    // Slanted names need room above the plot, and on its right for those that lean over the edge.
    std::size_t longest = 0;
    for (const PlotBand& band : bands_) longest = std::max(longest, band.name.size());
    const double slanted = letter * static_cast<double>(std::min<std::size_t>(longest, 40));
    constexpr double slant = names_slant * std::numbers::pi / 180.0;
    const double names_room = names_lift + 14.0 + slanted * std::sin(slant);
    const double overhang = 20.0 + slanted * std::cos(slant);
    top_ = 12.0 + (plot_.title.empty() ? 0.0 : title_room) + (bands_.empty() ? 0.0 : names_room);
    right_edge_ = width - std::max(plot_.right_label.empty() ? right_margin : right_margin_with_axis,
                                   bands_.empty() ? 0.0 : overhang);
    groups_ = group_marks();
    measure_key();
    height_ = top_ + plot_.height + axis_room + key_height_ + mark_row * static_cast<double>(groups_.size()) +
              (groups_.empty() ? 0.0 : 10.0);
  }

  // There is a key when more than one series has a name. Its columns are as wide as the longest name.
  void measure_key() {
    std::size_t longest = 0;
    for (const PlotSeries& series : plot_.series) {
      if (series.name.empty()) continue;
      named_.push_back(&series);
      longest = std::max(longest, series.name.size());
    }
    if (named_.size() < 2) return named_.clear();
    key_column_ = key_sample + 24.0 + key_letter * static_cast<double>(std::min<std::size_t>(longest, 60));
    key_columns_ = std::max<std::size_t>(1, static_cast<std::size_t>((width - left_margin) / key_column_));
    key_columns_ = std::min(key_columns_, named_.size());
    const std::size_t rows = (named_.size() + key_columns_ - 1) / key_columns_;
    key_columns_ = (named_.size() + rows - 1) / rows;  // equally full rows
    key_height_ = key_row * static_cast<double>(rows) + 16.0;
  }

  static AxisRange with_headroom(const AxisRange& range) {
    const double span = range.high - range.low;
    const bool from_zero = range.low >= 0.0 && range.low < 0.5 * span;
    return {from_zero ? 0.0 : range.low - 0.06 * span, range.high + 0.08 * span};
  }

  double px_x(double x) const {
    return left_margin + (x - x_.low) / (x_.high - x_.low) * (right_edge_ - left_margin);
  }
  double px_y(double y) const {
    const double from_top = (plot_.y_down ? y - y_.low : y_.high - y) / (y_.high - y_.low);
    return top_ + from_top * plot_.height;
  }
  // gnuplot's screen coordinates, 0 to 1 from the bottom left.
  static double screen_x(double px) { return px / width; }
  double screen_y(double px) const { return 1.0 - (above_ + px) / picture_; }

  void frame() {
    emit("reset\nunset key");
    emit("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}", screen_x(left_margin), screen_x(right_edge_));
    emit("set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}", screen_y(top_), screen_y(top_ + plot_.height));
    emit("set xrange [{}:{}]\nset yrange [{}:{}]", x_.low, x_.high, plot_.y_down ? y_.high : y_.low,
         plot_.y_down ? y_.low : y_.high);
    emit(
        "set border 3 lw 1 lc rgb '#5b6670'\nset grid lw 0.6 lc rgb '#d5dade'\nset xzeroaxis lw 0.8 lc rgb "
        "'#8a949c'");
    emit("set xtics nomirror out scale 0.6 tc rgb '#26303a'\nset ytics nomirror out scale 0.6 tc rgb '#26303a'");
    emit("set xlabel {} tc rgb '#26303a'\nset ylabel {} tc rgb '#26303a' offset 1.5", gnuplot_text(plot_.x_label),
         gnuplot_text(plot_.y_label));
    if (!plot_.right_label.empty()) {
      emit(
          "set border 11\nset y2tics nomirror out scale 0.6 tc rgb '#26303a'\nset y2range [{}:{}]\nset y2label {} tc "
          "rgb "
          "'#26303a' offset -1.5",
          right_.low, right_.high, gnuplot_text(plot_.right_label));
    }
    if (!plot_.title.empty()) {
      emit("set label {} at screen {:.5f},{:.5f} left font 'DejaVu Sans Bold,16' tc rgb '#12212e'",
           gnuplot_text(plot_.title), screen_x(left_margin), screen_y(30.0));
    }
  }

  void bands() {
    std::vector<std::string> names;
    std::vector<double> centres;
    for (const PlotBand& band : bands_) {
      emit(
          "set object rectangle from {},graph 0 to {},graph 1 behind fillcolor rgb '{}' fillstyle transparent solid "
          "0.32 noborder",
          band.from, band.to, css_colour(band.colour));
      if (band.name.empty()) continue;
      // A narrow band of a colour that already has its name goes without.
      const bool known = std::find(names.begin(), names.end(), band.name) != names.end();
      if (known && px_x(band.to) - px_x(band.from) < wide_band) continue;
      names.push_back(band.name);
      centres.push_back(px_x(0.5 * (band.from + band.to)));
    }
    std::vector<double> places = spread(centres, names_apart);
    double limit = right_edge_;
    for (std::size_t i = places.size(); i-- > 0;) {
      places[i] = std::min(places[i], limit);
      limit = places[i] - names_apart;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      emit("set arrow from screen {:.5f},{:.5f} to screen {:.5f},{:.5f} nohead lw 1 lc rgb '#8a949c'",
           screen_x(centres[i]), screen_y(top_), screen_x(places[i]), screen_y(top_ - names_lift));
      emit("set label {} at screen {:.5f},{:.5f} left rotate by {} font ',12' tc rgb '#26303a'",
           gnuplot_text(names[i]), screen_x(places[i] + 2.0), screen_y(top_ - names_lift - 5.0), names_slant);
    }
  }

  // gnuplot's SVG forgets a change of dashes between two lines of one colour. A line of no length and no colour that
  // occurs elsewhere, drawn between them, makes it start anew.
  void separate_lines() { emit("set arrow from screen 0,0 to screen 0,0 nohead lw 0.1 lc rgb '#fefefe' dt solid"); }

  void dividers() {
    for (const PlotDivider& divider : plot_.dividers) {
      separate_lines();
      emit("set arrow from {},graph 0 to {},graph 1 nohead lw 1 lc rgb '#5b6670' dt (3,3)", divider.x, divider.x);
      emit("set label {} at {},graph 1 left offset 0.5,-0.8 font ',12' tc rgb '#26303a' front",
           gnuplot_text(divider.name), divider.x);
    }
  }

  void key() {
    for (std::size_t i = 0; i < named_.size(); ++i) {
      const std::size_t row = i / key_columns_, column = i % key_columns_;
      const double x = left_margin + key_column_ * static_cast<double>(column);
      const double y = top_ + plot_.height + axis_room + 9.0 + key_row * static_cast<double>(row);
      separate_lines();
      emit("set arrow from screen {:.5f},{:.5f} to screen {:.5f},{:.5f} nohead {}", screen_x(x), screen_y(y),
           screen_x(x + key_sample), screen_y(y), line_style(*named_[i]));
      emit("set label {} at screen {:.5f},{:.5f} left tc rgb '#26303a'", gnuplot_text(named_[i]->name),
           screen_x(x + key_sample + 8.0), screen_y(y));
    }
  }

  // Dots that would cover each other are one dot.
  std::vector<PlotMark> group_marks() const {
    std::vector<PlotMark> groups;
    for (const PlotMark& mark : plot_.marks) {
      const double y = std::clamp(mark.y, y_.low, y_.high);
      const auto close = std::find_if(groups.begin(), groups.end(), [&](const PlotMark& other) {
        return std::hypot(px_x(other.x) - px_x(mark.x), px_y(other.y) - px_y(y)) < marks_apart;
      });
      if (close != groups.end())
        close->text += "; " + mark.text;
      else
        groups.push_back({mark.x, y, mark.text});
    }
    return groups;
  }

  void marks() {
    double row = top_ + plot_.height + axis_room + key_height_ + 8.0;
    int number = 0;
    for (const PlotMark& group : groups_) {
      ++number;
      const auto dot = [&](double x, double y) {
        emit("set label '' at screen {:.5f},{:.5f} point pt 7 ps 1.45 lc rgb '#b3261e' front", x, y);
        emit("set label '{}' at screen {:.5f},{:.5f} center front font 'DejaVu Sans Bold,10' tc rgb '#ffffff'",
             number, x, y);
      };
      dot(screen_x(px_x(group.x)), screen_y(px_y(group.y)));
      dot(screen_x(left_margin + 8.0), screen_y(row));
      emit("set label {} at screen {:.5f},{:.5f} left font ',12' tc rgb '#26303a'", gnuplot_text(group.text),
           screen_x(left_margin + 24.0), screen_y(row));
      row += mark_row;
    }
  }

  // Without the points on straight lines between others, as far as the eye can see.
  std::vector<std::size_t> without_straights(const PlotSeries& series, const std::vector<std::size_t>& points) const {
    const AxisRange& range = series.right_axis ? right_ : y_;
    std::vector<std::array<double, 2>> places;
    for (const std::size_t i : points)
      places.push_back({px_x(series.x[i]), (series.y[i] - range.low) / (range.high - range.low) * plot_.height});
    std::vector<std::size_t> kept;
    for (const std::size_t place : corners_of(places, invisible)) kept.push_back(points[place]);
    return kept;
  }

  void series() {
    int index = 0;
    for (const PlotSeries& series : plot_.series) {
      emit("$data{} << END_OF_DATA", index++);
      for (const std::size_t i : without_straights(series, points_to_draw(series)))
        emit("{} {}", series.x[i], series.y[i]);
      emit("END_OF_DATA");
    }
    text_ += "plot ";
    for (int i = 0; i < index; ++i) {
      const PlotSeries& series = plot_.series[static_cast<std::size_t>(i)];
      fmt::format_to(std::back_inserter(text_), "{}$data{} using 1:2 axes {} with lines {} notitle",
                     i == 0 ? "" : ", ", i, series.right_axis ? "x1y2" : "x1y1", line_style(series));
    }
    if (index == 0) text_ += "NaN notitle";
    text_ += '\n';
  }

  const Plot& plot_;
  std::vector<PlotBand> bands_;
  std::vector<PlotMark> groups_;
  AxisRange x_, y_, right_;
  double top_ = 0.0, right_edge_ = 0.0, height_ = 0.0;  // px
  double above_ = 0.0, picture_ = 1.0;                  // px
  std::vector<const PlotSeries*> named_;                // in the key; empty: there is none
  std::size_t key_columns_ = 1;
  double key_column_ = 0.0, key_height_ = 0.0;  // px
  std::string text_;
};

}  // namespace

std::string plot_svg(const Plot& plot) {
  return plot_svg(std::span(&plot, 1));
}

std::string plot_svg(std::span<const Plot> plots) {
  std::vector<Script> scripts(plots.begin(), plots.end());
  double height = 0.0, right_edge = width;
  for (const Script& script : scripts) {
    height += script.height();
    right_edge = std::min(right_edge, script.right_edge());
  }
  for (Script& script : scripts) script.end_at(right_edge);
  std::string program = fmt::format(
      "set encoding utf8\nset terminal svg size {:.0f},{:.0f} dynamic rounded noenhanced font 'DejaVu Sans,13' "
      "background '#ffffff'\nset multiplot\n",
      width, height);
  double above = 0.0;
  for (Script& script : scripts) {
    program += script.write(above, height);
    above += script.height();
  }
  const ToolResult result = run_tool({"gnuplot", "-d", "-"}, program + "unset multiplot\n", "gnuplot-nox");
  if (result.exit_code != 0 || result.output.find("</svg>") == std::string::npos) {
    const std::string title = plots.empty() ? "" : plots.front().title;
    throw SystemError(fmt::format("gnuplot could not draw '{}': {}", title, result.errors));
  }
  return result.output;
}

}  // namespace bodkin
