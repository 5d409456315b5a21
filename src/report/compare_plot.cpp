#include "report/compare_plot.h"

#include <algorithm>
#include <iterator>

#include "report/crossings.h"
#include "report/force_plot.h"

namespace bodkin::report {

namespace {

// Diagnostics that are a place on the needle's line, mm, to be compared with its depth.
constexpr std::string_view places_on_line[] = {"wall_mm", "reference_mm"};

struct Look {
  std::string_view name;
  std::uint32_t colour;
  std::vector<double> dash;
};

// Colours after Okabe and Ito (2008), told apart in every kind of colour vision; their yellow is too pale for a line,
// so that olive takes its place, and wine (Tol 2021) is added. Dashes differ as well, for print without colour.
// `others`: how many models with settings of their own there were.
Look look_of(std::string_view name, std::size_t& others) {
  static const std::vector<Look> looks = {
      {"layered", 0x000000, {}},
      {"layered_sum", 0x000000, {2, 4}},
      {"spring_damper_wall", 0xE69F00, {14, 5}},
      {"tracking_wall", 0x0072B2, {}},
      {"tracking_wall_leash", 0x0072B2, {7, 4}},
      {"depth_profile", 0x009E73, {14, 4, 2, 4}},
      {"volume_proxy", 0xCC79A7, {}},
      {"volume_proxy_viscous", 0xCC79A7, {4, 4}},
      {"three_component", 0x56B4E9, {10, 4, 2, 4, 2, 4}},
      {"fracture", 0xD55E00, {6, 3}},
      {"shaft_friction", 0x7A6A00, {3, 3}},
      {"embedded_needle", 0x882255, {}},
      {"closest_node", 0x882255, {8, 3, 2, 3}},
      {"surface_proxy", 0x44AA99, {5, 5}},
      {"registered", 0x44AA99, {12, 5, 4, 5}},
  };
  const auto find = [&](std::string_view wanted) {
    return std::find_if(looks.begin(), looks.end(), [&](const Look& look) { return look.name == wanted; });
  };
  if (const auto known = find(name); known != looks.end()) return *known;
  // A model with settings of its own: the colour of its model, the next free dashes.
  static const std::vector<std::vector<double>> spare = {{20, 6}, {2, 6},       {12, 3, 3, 3},
                                                         {5, 2},  {3, 2, 3, 6}, {16, 3, 2, 3, 2, 3}};
  return {name, find(name.substr(0, name.find_first_of(" ;")))->colour, spare[others++ % spare.size()]};
}

// The tissues that the tip passes on the insertion, over depth.
std::vector<PlotBand> bands_over_depth(const study::Comparison& comparison, const anatomy::TissueLibrary& library) {
  std::vector<simulation::TickRecord> ticks;
  for (std::size_t tick = 0; tick < comparison.first[1]; ++tick) {
    simulation::TickRecord record;
    record.tick = tick;
    record.output.depth = comparison.depth[tick];
    record.output.tissue = comparison.tissue[tick];
    record.output.in_contact = comparison.depth[tick] > 0.0;
    ticks.push_back(record);
  }
  return bands_of(tissues_crossed(ticks, comparison.dt), library);
}

// The same colours over time, without names.
std::vector<PlotBand> bands_over_time(const study::Comparison& comparison, const anatomy::TissueLibrary& library) {
  std::vector<PlotBand> bands;
  for (std::size_t tick = 0; tick < comparison.tissue.size(); ++tick) {
    const anatomy::TissueId here = comparison.tissue[tick];
    if (here == anatomy::tissue::air) continue;
    const anatomy::TissueProperties* properties = library.find(here);
    const std::uint32_t colour = properties != nullptr ? properties->colour : 0x808080U;
    const double from = static_cast<double>(tick) * comparison.dt, to = from + comparison.dt;
    const bool continues = !bands.empty() && tick > 0 && comparison.tissue[tick - 1] == here;
    if (continues)
      bands.back().to = to;
    else
      bands.push_back({from, to, colour, ""});
  }
  return bands;
}

// Where the plot over depth begins, mm: before the skin as far as any model still has a force.
double least_depth(const study::Comparison& comparison) {
  double least = 0.0;
  for (const study::ModelRun& run : comparison.models) {
    for (std::size_t tick = 0; tick < run.force.size(); ++tick) {
      if (run.force[tick] != 0.0) least = std::min(least, comparison.depth[tick]);
    }
  }
  return least - 1.0;
}

}  // namespace

std::vector<Plot> comparison_plots(const study::Comparison& comparison, const anatomy::TissueLibrary& library,
                                   double peak_force) {
  Plot over_depth, over_time;
  over_depth.x_label = "depth, mm (thick: insertion, thin: withdrawal)";
  over_time.x_label = "time, s";
  over_depth.y_label = over_time.y_label = "resistance, N";
  over_depth.height = 360.0;
  over_time.height = 300.0;
  over_depth.bands = bands_over_depth(comparison, library);
  over_time.bands = bands_over_time(comparison, library);
  for (std::size_t phase = 0; phase < study::motion_phases; ++phase) {
    if (comparison.first[phase] == comparison.first[phase + 1]) continue;
    over_time.dividers.push_back(
        {static_cast<double>(comparison.first[phase]) * comparison.dt, std::string(study::phase_names[phase])});
  }

  std::vector<double> time(comparison.depth.size());
  for (std::size_t tick = 0; tick < time.size(); ++tick) time[tick] = static_cast<double>(tick) * comparison.dt;
  const double least = least_depth(comparison);
  // Force over depth from the beginning of one phase to that of another.
  const auto draw = [&](PlotSeries& series, const study::ModelRun& run, study::MotionPhase from,
                        study::MotionPhase to) {
    const std::size_t end = comparison.first[static_cast<std::size_t>(to)];
    for (std::size_t tick = comparison.first[static_cast<std::size_t>(from)]; tick < end; ++tick) {
      if (comparison.depth[tick] < least) continue;
      series.x.push_back(comparison.depth[tick]);
      series.y.push_back(run.force[tick]);
    }
  };
  Plot places = over_time;
  places.y_label = "place on the line, mm";
  places.height = 220.0;
  places.series.push_back({.name = "tip", .x = time, .y = comparison.depth, .colour = 0x9AA7B1, .width = 1.0});
  double highest = 0.0;
  std::size_t others = 0;
  for (const study::ModelRun& run : comparison.models) {
    const Look look = look_of(run.name, others);
    PlotSeries in{.name = run.name, .colour = look.colour, .width = 2.2, .dash = look.dash};
    PlotSeries out{.colour = look.colour, .width = 1.0, .dash = look.dash};
    draw(in, run, study::MotionPhase::insertion, study::MotionPhase::stop);
    draw(out, run, study::MotionPhase::stop, study::MotionPhase::reinsertion);
    PlotSeries whole{.x = time, .y = run.force, .colour = look.colour, .width = 1.6, .dash = look.dash};
    over_depth.series.push_back(std::move(out));
    over_depth.series.push_back(std::move(in));
    over_time.series.push_back(std::move(whole));
    highest = std::max(highest, run.peak);
    for (std::size_t i = 0; i < run.diagnostics.size(); ++i) {
      const auto* const end = std::end(places_on_line);
      if (std::find(std::begin(places_on_line), end, run.diagnostics[i].name) == end) continue;
      PlotSeries place{.name = run.name + ": " + std::string(run.diagnostics[i].title),
                       .colour = look.colour,
                       .width = 1.6,
                       .dash = look.dash};
      for (std::size_t tick = 0; tick < time.size(); ++tick) {
        if (comparison.depth[tick] <= 0.0) continue;  // outside nothing is published
        place.x.push_back(time[tick]);
        place.y.push_back(run.published[tick * run.diagnostics.size() + i]);
      }
      places.series.push_back(std::move(place));
    }
  }
  if (highest > highest_share * peak_force) over_depth.y_highest = over_time.y_highest = highest_share * peak_force;
  if (places.series.size() > 1) return {over_depth, over_time, places};
  return {over_depth, over_time};
}

}  // namespace bodkin::report
