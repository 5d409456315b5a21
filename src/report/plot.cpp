#include "report/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "report/polyline.h"
#include <fmt/format.h>

namespace bodkin::report {

namespace {

// px of the picture
constexpr double width = 900.0;
constexpr double left_margin = 76.0;
constexpr double right_margin = 34.0;
constexpr double right_margin_with_axis = 76.0;
constexpr double title_room = 44.0;
constexpr double axis_room = 68.0;
constexpr double tick_length = 5.0;
constexpr double x_ticks_apart = 90.0, y_ticks_apart = 40.0;  // about
constexpr double label_line = 0.36;                           // of a text's size, from its middle to its base line
constexpr double key_row = 19.0;
constexpr double key_sample = 40.0;  // the piece of line before a name in the key
constexpr double mark_row = 19.0;
constexpr double mark_radius = 7.5;
constexpr double longest_name = 270.0;  // that gets space above and beside the plot
constexpr double names_slant = 50.0;    // deg
constexpr double names_apart = 19.0;    // between slanted names
constexpr double names_lift = 16.0;     // from the plot to the names: the leaders' height
constexpr double wide_band = 70.0;
constexpr double marks_apart = 15.0;
constexpr double small_text = 12.0, plain_text = 13.0, title_text = 16.0;
constexpr std::size_t most_points = 4000;
constexpr double invisible = 0.1;

constexpr std::uint32_t paper = 0xFFFFFF, text_ink = 0x26303A, title_ink = 0x12212E, axis_ink = 0x5B6670,
                        grid_ink = 0xD5DADE, zero_ink = 0x8A949C, mark_ink = 0xB3261E;
constexpr double band_opacity = 0.32;
constexpr double range_opacity = 0.22;
constexpr double range_sample = 10.0;  // px, height of its sample in the key

using Place = Eigen::Vector2d;

struct AxisRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// Positions as near as possible to `wanted` (ascending), at least `apart` from each other (pool adjacent violators).
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

struct KeyEntry {
  std::string name;
  std::uint32_t colour;
  const PlotSeries* series;  // null: a range
};

class PlotArtist {
 public:
  explicit PlotArtist(const Plot& plot) : plot_(plot), bands_(merged(plot.bands)) { measure(); }

  // px
  double height() const { return height_; }
  double right_edge() const { return right_edge_; }
  // Ends the plotting area farther to the left, so that stacked plots share their x axis.
  void end_at(double right_edge) {
    right_edge_ = right_edge;
    groups_ = group_marks();
  }

  imaging::Canvas draw() {
    bands();
    axes();
    series();
    dividers();
    key();
    marks();
    if (!plot_.title.empty()) write({left_margin, 30.0 + label_line * title_text}, plot_.title, title_style());
    return std::move(canvas_);
  }

 private:
  void measure() {
    for (const PlotSeries& series : plot_.series) {
      for (const double x : series.x) x_.include(x);
      for (const double y : series.y) (series.right_axis ? right_ : y_).include(y);
    }
    for (const PlotRange& range : plot_.ranges) {
      for (const double x : range.x) x_.include(x);
      for (const double low : range.low) y_.include(low);
      for (const double high : range.high) y_.include(high);
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

    // Slanted names need space above the plot, and on its right for those that lean over the edge.
    double slanted = 0.0;
    for (const PlotBand& band : bands_) slanted = std::max(slanted, imaging::text_width(band.name, small_text));
    slanted = std::min(slanted, longest_name);
    const double names_room = names_lift + 14.0 + slanted * std::sin(names_slant * degree);
    const double overhang = 20.0 + slanted * std::cos(names_slant * degree);
    top_ = 12.0 + (plot_.title.empty() ? 0.0 : title_room) + (slanted > 0.0 ? names_room : 0.0);
    right_edge_ = width - std::max(plot_.right_label.empty() ? right_margin : right_margin_with_axis,
                                   slanted > 0.0 ? overhang : 0.0);
    groups_ = group_marks();
    measure_key();
    height_ = top_ + plot_.height + axis_room + key_height_ + mark_row * static_cast<double>(groups_.size()) +
              (groups_.empty() ? 0.0 : 10.0);
    canvas_.set_size(width, height_);
  }

  // There is a key if more than one series or range has a name, or the plot names a single one. Its columns are as
  // wide as the longest name.
  void measure_key() {
    double longest = 0.0;
    const auto name = [&](const KeyEntry& entry) {
      if (entry.name.empty()) return;
      named_.push_back(entry);
      longest = std::max(longest, imaging::text_width(entry.name, plain_text));
    };
    for (const PlotRange& range : plot_.ranges) name({range.name, range.colour, nullptr});
    for (const PlotSeries& series : plot_.series) name({series.name, series.colour, &series});
    if (named_.size() < (plot_.names_one ? 1 : 2)) return named_.clear();
    key_column_ = key_sample + 24.0 + longest;
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
  double px_y(double y, bool right_axis = false) const {
    const AxisRange& range = right_axis ? right_ : y_;
    const double below = (y - range.low) / (range.high - range.low);
    return top_ + (plot_.y_down && !right_axis ? below : 1.0 - below) * plot_.height;
  }
  double bottom() const { return top_ + plot_.height; }

  static imaging::TextStyle title_style() { return {.size = title_text, .ink = title_ink, .bold = true}; }
  static imaging::TextStyle style(double size, imaging::TextAnchor anchor = imaging::TextAnchor::start,
                                  double angle = 0.0) {
    return {.size = size, .ink = text_ink, .anchor = anchor, .angle = angle};
  }
  void write(const Place& at, const std::string& text, const imaging::TextStyle& look) {
    canvas_.text(at, text, look);
  }

  void axes() {
    const AxisTicks x = axis_ticks(x_.low, x_.high, (right_edge_ - left_margin) / x_ticks_apart);
    const AxisTicks y = axis_ticks(y_.low, y_.high, plot_.height / y_ticks_apart);
    imaging::Path grid, ticks;
    for (const double value : x.values) {
      grid.add(imaging::Path::segment({px_x(value), top_}, {px_x(value), bottom()}));
      ticks.add(imaging::Path::segment({px_x(value), bottom()}, {px_x(value), bottom() + tick_length}));
      write({px_x(value), bottom() + 21.0}, tick_label(value, x), style(plain_text, imaging::TextAnchor::middle));
    }
    for (const double value : y.values) {
      grid.add(imaging::Path::segment({left_margin, px_y(value)}, {right_edge_, px_y(value)}));
      ticks.add(imaging::Path::segment({left_margin - tick_length, px_y(value)}, {left_margin, px_y(value)}));
      write({left_margin - 9.0, px_y(value) + label_line * plain_text}, tick_label(value, y),
            style(plain_text, imaging::TextAnchor::end));
    }
    imaging::Path border =
        imaging::Path::polyline({{left_margin, top_}, {left_margin, bottom()}, {right_edge_, bottom()}});
    if (!plot_.right_label.empty()) {
      border.line_to({right_edge_, top_});
      const AxisTicks right = axis_ticks(right_.low, right_.high, plot_.height / y_ticks_apart);
      for (const double value : right.values) {
        const double at = px_y(value, true);
        ticks.add(imaging::Path::segment({right_edge_, at}, {right_edge_ + tick_length, at}));
        write({right_edge_ + 9.0, at + label_line * plain_text}, tick_label(value, right), style(plain_text));
      }
      write({std::min(width - 14.0, right_edge_ + 54.0), top_ + 0.5 * plot_.height}, plot_.right_label,
            style(plain_text, imaging::TextAnchor::middle, 90.0));
    }
    canvas_.stroke(grid, {grid_ink, 0.6});
    if (y_.low < 0.0 && y_.high > 0.0)
      canvas_.stroke(imaging::Path::segment({left_margin, px_y(0.0)}, {right_edge_, px_y(0.0)}), {zero_ink, 0.8});
    canvas_.stroke(border, {axis_ink});
    canvas_.stroke(ticks, {axis_ink});
    write({0.5 * (left_margin + right_edge_), bottom() + 47.0}, plot_.x_label,
          style(plain_text, imaging::TextAnchor::middle));
    write({28.0, top_ + 0.5 * plot_.height}, plot_.y_label, style(plain_text, imaging::TextAnchor::middle, 90.0));
  }

  static std::string tick_label(double value, const AxisTicks& ticks) {
    return std::abs(value) >= 1e6 || ticks.decimals > 5 ? fmt::format("{:.6g}", value)
                                                        : fmt::format("{:.{}f}", value, ticks.decimals);
  }

  void bands() {
    std::vector<std::string> names;
    std::vector<double> centres;
    for (const PlotBand& band : bands_) {
      canvas_.fill(imaging::Path::rectangle(px_x(band.from), top_, px_x(band.to) - px_x(band.from), plot_.height),
                   {band.colour, band_opacity});
      if (band.name.empty()) continue;
      // A narrow band of a colour that is already named gets no name.
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
      canvas_.stroke(imaging::Path::segment({centres[i], top_}, {places[i], top_ - names_lift}), {zero_ink});
      write({places[i] + 5.0, top_ - names_lift - 2.0}, names[i],
            style(small_text, imaging::TextAnchor::start, names_slant));
    }
  }

  void dividers() {
    for (const PlotDivider& divider : plot_.dividers) {
      const double x = px_x(divider.x);
      canvas_.stroke(imaging::Path::segment({x, top_}, {x, bottom()}), {axis_ink, 1.0, {3.0, 3.0}});
      write({x + 5.0, top_ + 15.0}, divider.name, style(small_text));
    }
  }

  void key() {
    for (std::size_t i = 0; i < named_.size(); ++i) {
      const std::size_t row = i / key_columns_, column = i % key_columns_;
      const Place at(left_margin + key_column_ * static_cast<double>(column),
                     bottom() + axis_room + 9.0 + key_row * static_cast<double>(row));
      const KeyEntry& entry = named_[i];
      if (entry.series != nullptr) {
        canvas_.stroke(imaging::Path::segment(at, at + Place(key_sample, 0.0)), line_style(*entry.series));
      } else {
        canvas_.fill(imaging::Path::rectangle(at.x(), at.y() - 0.5 * range_sample, key_sample, range_sample),
                     {entry.colour, range_opacity});
      }
      write(at + Place(key_sample + 8.0, label_line * plain_text), entry.name, style(plain_text));
    }
  }

  static imaging::LineStyle line_style(const PlotSeries& series) {
    return {series.colour, series.width, series.dash};
  }

  // Overlapping dots are merged into one.
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
    double row = bottom() + axis_room + key_height_ + 8.0;
    int number = 0;
    for (const PlotMark& group : groups_) {
      ++number;
      const auto dot = [&](const Place& at) {
        canvas_.fill(imaging::Path::circle(at, mark_radius), mark_ink);
        write(at + Place(0.0, label_line * 10.0), std::to_string(number),
              {.size = 10.0, .ink = paper, .anchor = imaging::TextAnchor::middle, .bold = true});
      };
      dot({px_x(group.x), px_y(group.y)});
      dot({left_margin + 8.0, row});
      write({left_margin + 24.0, row + label_line * small_text}, group.text, style(small_text));
      row += mark_row;
    }
  }

  // Without points visibly on straight lines between others; clipped to the axes.
  void series() {
    imaging::Canvas area(right_edge_ - left_margin, plot_.height);
    for (const PlotRange& range : plot_.ranges) {
      std::vector<Place> outline;
      for (std::size_t i = 0; i < range.x.size(); ++i)
        outline.emplace_back(px_x(range.x[i]) - left_margin, px_y(range.high[i]) - top_);
      for (std::size_t i = range.x.size(); i-- > 0;)
        outline.emplace_back(px_x(range.x[i]) - left_margin, px_y(range.low[i]) - top_);
      area.fill(imaging::Path::polygon(outline), {range.colour, range_opacity});
    }
    for (const PlotSeries& series : plot_.series) {
      std::vector<std::array<double, 2>> places;
      for (const std::size_t i : points_to_draw(series))
        places.push_back({px_x(series.x[i]) - left_margin, px_y(series.y[i], series.right_axis) - top_});
      std::vector<Place> points;
      for (const std::size_t i : corners_of(places, invisible)) points.emplace_back(places[i][0], places[i][1]);
      area.stroke(imaging::Path::polyline(points), line_style(series));
    }
    canvas_.place(std::move(area), left_margin, top_);
  }

  const Plot& plot_;
  std::vector<PlotBand> bands_;
  std::vector<PlotMark> groups_;
  AxisRange x_, y_, right_;
  double top_ = 0.0, right_edge_ = 0.0, height_ = 0.0;  // px
  std::vector<KeyEntry> named_;                         // in the key; empty: there is none
  std::size_t key_columns_ = 1;
  double key_column_ = 0.0, key_height_ = 0.0;  // px
  imaging::Canvas canvas_{0.0, 0.0};
};

}  // namespace

AxisTicks axis_ticks(double low, double high, double wanted) {
  const double rough = (high - low) / std::max(wanted, 1.0);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double step = power * (rough > 5.0 * power ? 10.0 : rough > 2.0 * power ? 5.0 : rough > power ? 2.0 : 1.0);
  AxisTicks ticks;
  ticks.decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  const double first = std::ceil(low / step - 1e-9), last = std::floor(high / step + 1e-9);
  for (double number = first; number <= last; number += 1.0) ticks.values.push_back(number * step + 0.0);
  return ticks;
}

imaging::Canvas draw_plots(std::span<const Plot> plots) {
  std::vector<PlotArtist> artists(plots.begin(), plots.end());
  double height = 0.0, right_edge = width;
  for (const PlotArtist& artist : artists) {
    height += artist.height();
    right_edge = std::min(right_edge, artist.right_edge());
  }
  imaging::Canvas canvas(width, std::ceil(height));
  canvas.fill_all(paper);
  double above = 0.0;
  for (PlotArtist& artist : artists) {
    artist.end_at(right_edge);
    canvas.place(artist.draw(), 0.0, above);
    above += artist.height();
  }
  return canvas;
}

imaging::Canvas draw_plot(const Plot& plot) {
  return draw_plots(std::span(&plot, 1));
}

}  // namespace bodkin::report
