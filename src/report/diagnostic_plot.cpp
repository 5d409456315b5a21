#include "report/diagnostic_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "report/crossings.h"

namespace bodkin::report {

namespace {

constexpr double plot_height = 180.0;  // px
// After Okabe and Ito (2008), distinguishable in every kind of colour vision.
constexpr std::array<std::uint32_t, 6> diagnostic_colours = {0x0072B2, 0xD55E00, 0x009E73,
                                                             0xCC79A7, 0xE69F00, 0x56B4E9};

}  // namespace

std::string unit_of_diagnostic(const std::string& name) {
  using Ending = std::pair<std::string_view, std::string_view>;
  for (const auto& [ending, unit] :
       {Ending{"_N_mm", "N mm"}, Ending{"_N_per_mm", "N/mm"}, Ending{"_mm_s", "mm/s"}, Ending{"_mm3_s", "mm^3/s"},
        Ending{"_mm3", "mm^3"}, Ending{"_mm", "mm"}, Ending{"_MPa", "MPa"}, Ending{"_N", "N"}}) {
    if (name.ends_with(ending)) return std::string(unit);
  }
  return {};
}

std::vector<Plot> diagnostics_against_depth(std::span<const simulation::TickRecord> ticks,
                                            std::span<const session::RecordedDiagnostic> diagnostics) {
  const std::vector<Insertion> all = insertions(ticks);
  if (all.empty()) return {};
  const auto deepest = std::max_element(all.begin(), all.end(),
                                        [](const Insertion& a, const Insertion& b) { return a.deepest < b.deepest; });
  std::vector<Plot> plots;
  for (std::size_t i = 0; i < diagnostics.size(); ++i) {
    const std::string unit = unit_of_diagnostic(diagnostics[i].name);
    const std::string label = unit.empty() ? "no unit" : unit;
    auto plot = std::find_if(plots.begin(), plots.end(), [&](const Plot& one) { return one.y_label == label; });
    if (plot == plots.end()) {
      plot = plots.insert(plots.end(), Plot{});
      plot->x_label = "depth along the needle's line, mm";
      plot->y_label = label;
      plot->height = plot_height;
      plot->names_one = true;
    }
    PlotSeries series{.name = diagnostics[i].title,
                      .colour = diagnostic_colours[plot->series.size() % diagnostic_colours.size()],
                      .width = 1.6};
    for (std::size_t tick = deepest->first; tick <= deepest->last; ++tick) {
      const simulation::TickOutput& output = ticks[tick].output;
      if (!output.in_contact || !std::isfinite(output.diagnostics[i])) continue;
      series.x.push_back(output.depth);
      series.y.push_back(output.diagnostics[i]);
    }
    plot->series.push_back(std::move(series));
  }
  return plots;
}

}  // namespace bodkin::report
