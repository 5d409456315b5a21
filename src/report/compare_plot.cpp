#include "report/compare_plot.h"

#include <algorithm>

#include "report/crossings.h"
#include "report/force_plot.h"
#include "report/motion_plot.h"
#include <fmt/format.h>

#include "core/error.h"
#include "simulation/resistance_models.h"

namespace bodkin::report {

namespace {

constexpr double width_of_letter = 0.0095;  // of the name of a motion's part, as a fraction of the whole plot

struct Look {
  std::string_view name;
  std::uint32_t colour;
  std::vector<double> dash;
};

// Colours after Okabe and Ito (2008), distinguishable in every kind of colour vision; their yellow is too pale for a
// line, so olive replaces it, and wine (Tol 2021) is added. Dashes differ too, for print without colour. `others`:
// number of previous models with their own settings.
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
  // A model with its own settings: the colour of its model, the next free dash pattern.
  static const std::vector<std::vector<double>> spare = {{20, 6}, {2, 6},       {12, 3, 3, 3},
                                                         {5, 2},  {3, 2, 3, 6}, {16, 3, 2, 3, 2, 3}};
  const auto of_model = find(name.substr(0, name.find_first_of(" ;")));
  constexpr std::uint32_t of_others = 0x444444;
  return {name, of_model != looks.end() ? of_model->colour : of_others, spare[others++ % spare.size()]};
}

// The tissues that the tip passes on the insertion, over depth.
std::vector<PlotBand> bands_over_depth(const study::Comparison& comparison, const anatomy::TissueLibrary& library) {
  std::vector<simulation::TickRecord> ticks;
  for (std::size_t tick = 0; tick < comparison.depth.size(); ++tick) {
    if (comparison.phase_of(tick) != study::MotionPhase::insertion) continue;
    simulation::TickRecord record;
    record.tick = ticks.size();
    record.output.depth = comparison.depth[tick];
    record.output.tissue = comparison.tissue[tick];
    record.output.in_contact = comparison.depth[tick] > 0.0;
    ticks.push_back(record);
  }
  return bands_of(tissues_crossed(ticks, comparison.dt), library);
}

// Index of the depth in the material among a model's published numbers; irrelevant for the hand's depth.
std::size_t material_of(const study::ModelRun& run, PlottedDepth depth) {
  if (depth == PlottedDepth::hand) return 0;
  for (std::size_t i = 0; i < run.diagnostics.size(); ++i)
    if (run.diagnostics[i].name == simulation::material_depth_name) return i;
  throw InputError(
      fmt::format("--depth material: {} does not report it with the tables; leave out --mechanics tables", run.name));
}

// Beginning of the plot over depth, mm: before the skin as far as any model still has a force.
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
                                   double peak_force, PlottedDepth depth) {
  Plot over_depth, over_time;
  over_depth.x_label = depth_label(depth) + " (thick: insertion, thin: withdrawal)";
  over_time.x_label = "time, s";
  over_depth.y_label = over_time.y_label = "resistance, N";
  over_depth.height = 360.0;
  over_time.height = 300.0;
  over_depth.bands = bands_over_depth(comparison, library);
  over_time.bands = bands_over_time(comparison.tissue, comparison.dt, library);
  for (std::size_t part = 0; part < comparison.parts.size(); ++part) {
    const std::size_t first = comparison.first[part], ticks = comparison.first[part + 1] - first;
    if (ticks == 0) continue;
    const std::string_view name = study::phase_names[static_cast<std::size_t>(comparison.parts[part])];
    const double room = width_of_letter * static_cast<double>(name.size() * comparison.depth.size());
    over_time.dividers.push_back({static_cast<double>(first) * comparison.dt,
                                  static_cast<double>(ticks) > room ? std::string(name) : std::string()});
  }

  std::vector<double> time(comparison.depth.size());
  for (std::size_t tick = 0; tick < time.size(); ++tick) time[tick] = static_cast<double>(tick) * comparison.dt;
  const double least = least_depth(comparison);
  const auto draw = [&](PlotSeries& series, const study::ModelRun& run, std::size_t part) {
    const std::size_t published = run.diagnostics.size(), material = material_of(run, depth);
    for (std::size_t tick = comparison.first[part]; tick < comparison.first[part + 1]; ++tick) {
      if (comparison.depth[tick] < least) continue;
      const bool at_rest = depth == PlottedDepth::material && comparison.depth[tick] > 0.0;
      series.x.push_back(at_rest ? run.published[tick * published + material] : comparison.depth[tick]);
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
    bool continues = false;  // a stop with its withdrawal is one line
    for (std::size_t part = 0; part < comparison.parts.size(); ++part) {
      const study::MotionPhase phase = comparison.parts[part];
      const bool out = phase == study::MotionPhase::stop || phase == study::MotionPhase::withdrawal;
      if (phase == study::MotionPhase::insertion) draw(in, run, part);
      if (out && !continues) over_depth.series.push_back({.colour = look.colour, .width = 1.0, .dash = look.dash});
      if (out) draw(over_depth.series.back(), run, part);
      continues = out;
    }
    PlotSeries whole{.x = time, .y = run.force, .colour = look.colour, .width = 1.6, .dash = look.dash};
    over_depth.series.push_back(std::move(in));
    over_time.series.push_back(std::move(whole));
    highest = std::max(highest, run.peak);
    for (std::size_t i = 0; i < run.diagnostics.size(); ++i) {
      if (!is_place_on_line(run.diagnostics[i].name)) continue;
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
