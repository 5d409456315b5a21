#include "report/experiment_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace bodkin::report {

namespace {

constexpr std::array<std::uint32_t, 8> colours = {0x12385C, 0xD9722B, 0x2E8B6F, 0xA23B72,
                                                  0x6C8EBF, 0xC9A227, 0x6B4C9A, 0x5A6873};
constexpr std::uint32_t published_colour = 0xB3261E;
constexpr double shortest_band = 1e-9;
constexpr double short_line = 0.04;  // of the panel's width

const std::string label_of(io::Quantity quantity) {
  return std::string(io::quantity_names[static_cast<std::size_t>(quantity)].label);
}

class Panel {
 public:
  Panel(const io::Experiment& experiment, const study::ExperimentRun& run, const io::ExperimentPanel& panel)
      : experiment_(experiment), run_(run), panel_(panel) {}

  Plot draw() {
    plot_.title = panel_.title;
    plot_.height = panel_.height;
    plot_.y_down = panel_.down;
    plot_.x_label = panel_.x_label.empty() ? label_of(panel_.x) : panel_.x_label;
    for (const io::ExperimentCurve& curve : panel_.curves) {
      std::string& label = curve.right ? plot_.right_label : plot_.y_label;
      const std::string& wanted = curve.right ? panel_.right_label : panel_.y_label;
      if (label.empty()) label = wanted.empty() ? label_of(curve.quantity) : wanted;
      add_curve(curve);
    }
    if (panel_.tissues) add_bands();
    if (panel_.x == io::Quantity::time || panel_.x == io::Quantity::depth) add_published();
    return std::move(plot_);
  }

 private:
  // A new series after every gap in the quantity.
  void add_curve(const io::ExperimentCurve& curve) {
    const std::uint32_t colour = colours[curves_++ % colours.size()];
    const auto series = [&](std::string name) {
      plot_.series.push_back({std::move(name), {}, {}, colour, 1.8, curve.right});
    };
    series(curve.name.empty() && panel_.curves.size() > 1 ? label_of(curve.quantity) : curve.name);
    bool broken = false;
    for (const study::ExperimentTick& tick : run_.ticks) {
      if (!study::is_inside(panel_.window, tick)) continue;
      const double x = study::value_of(curve.x.value_or(panel_.x), tick, experiment_),
                   y = study::value_of(curve.quantity, tick, experiment_);
      const bool known = std::isfinite(x) && std::isfinite(y);
      if (known && broken && !plot_.series.back().x.empty()) series({});
      broken = !known;
      if (!known) continue;
      plot_.series.back().x.push_back(x);
      plot_.series.back().y.push_back(y);
    }
  }

  // The tissue at the tip, where it changes along the x axis.
  void add_bands() {
    for (const study::ExperimentTick& tick : run_.ticks) {
      if (!study::is_inside(panel_.window, tick) || tick.tissue == anatomy::tissue::air) {
        open_ = false;
        continue;
      }
      const double x = study::value_of(panel_.x, tick, experiment_);
      const anatomy::TissueProperties* tissue = experiment_.library.find(tick.tissue);
      if (tissue == nullptr) continue;
      if (open_ && plot_.bands.back().name == tissue->title) {
        plot_.bands.back().to = std::max(plot_.bands.back().to, x);
        continue;
      }
      // On the way back over an existing band.
      const bool covered = std::any_of(plot_.bands.begin(), plot_.bands.end(),
                                       [x](const PlotBand& band) { return x >= band.from && x <= band.to; });
      if (!covered) plot_.bands.push_back({open_ ? plot_.bands.back().to : x, x, tissue->colour, tissue->title});
      open_ = !covered;
    }
    std::erase_if(plot_.bands, [](const PlotBand& band) { return band.to - band.from < shortest_band; });
  }

  // Over the window of a published value, or short and at its position for a single moment.
  void add_published() {
    bool named = false;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const PlotSeries& series : plot_.series) {
      for (const double x : series.x) {
        low = std::min(low, x);
        high = std::max(high, x);
      }
    }
    const double width = std::max(0.0, high - low);
    for (const study::PublishedComparison& comparison : run_.comparisons) {
      const io::PublishedValue& value = comparison.published;
      const auto shows = [&](const io::ExperimentCurve& curve) { return curve.quantity == value.quantity; };
      const auto curve = std::find_if(panel_.curves.begin(), panel_.curves.end(), shows);
      if (curve == panel_.curves.end()) continue;
      double from = 0.0, to = 0.0, first = 0.0, last = 0.0;
      bool any = false;
      for (const study::ExperimentTick& tick : run_.ticks) {
        if (!study::is_inside(panel_.window, tick) || !study::is_inside(value.window, tick)) continue;
        const double x = study::value_of(panel_.x, tick, experiment_);
        from = any ? std::min(from, x) : x;
        to = any ? std::max(to, x) : x;
        if (!any) first = x;
        last = x;
        any = true;
      }
      if (!any) continue;
      if (value.aggregation == io::Aggregation::first || value.aggregation == io::Aggregation::last) {
        const double at = value.aggregation == io::Aggregation::first ? first : last;
        from = std::max(low, at - 0.5 * short_line * width);
        to = std::min(high, at + 0.5 * short_line * width);
      }
      plot_.series.push_back({named ? "" : "expected",
                              {from, to},
                              {value.value, value.value},
                              published_colour,
                              1.3,
                              curve->right,
                              {8, 5}});
      named = true;
    }
  }

  const io::Experiment& experiment_;
  const study::ExperimentRun& run_;
  const io::ExperimentPanel& panel_;
  Plot plot_;
  std::size_t curves_ = 0;
  bool open_ = false;
};

}  // namespace

std::vector<Plot> plots_of(const io::Experiment& experiment, const study::ExperimentRun& run) {
  std::vector<Plot> plots;
  for (const io::ExperimentPanel& panel : experiment.panels) plots.push_back(Panel(experiment, run, panel).draw());
  if (!plots.empty()) {
    std::string& title = plots.front().title;
    title = title.empty() ? experiment.title : experiment.title + ": " + title;
  }
  return plots;
}

}  // namespace bodkin::report
