#include "report/motion_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bodkin::report {

namespace {

constexpr std::array<std::string_view, 2> places_on_line = {"wall_mm", "reference_mm"};
constexpr std::uint32_t wall_colour = 0xD55E00, tip_colour = 0x12385C;

// The place published by a model while it resists; a new series after every gap.
void add_place(Plot& plot, const study::Profile& profile, std::size_t diagnostic) {
  bool open = false, named = false;
  for (const simulation::TickRecord& record : profile.ticks) {
    const simulation::TickOutput& output = record.output;
    const double place = output.diagnostics[diagnostic];
    const bool known = output.in_contact && output.resistance > 0.0 && std::isfinite(place);
    if (known && !open) {
      plot.series.push_back({.name = named ? "" : std::string(profile.diagnostics[diagnostic].title),
                             .colour = wall_colour,
                             .width = 1.6});
      named = true;
    }
    open = known;
    if (!known) continue;
    plot.series.back().x.push_back(static_cast<double>(record.tick) * profile.dt);
    plot.series.back().y.push_back(place);
  }
}

}  // namespace

bool is_place_on_line(std::string_view diagnostic) {
  return std::find(places_on_line.begin(), places_on_line.end(), diagnostic) != places_on_line.end();
}

std::vector<PlotBand> bands_over_time(std::span<const anatomy::TissueId> tissues, double dt,
                                      const anatomy::TissueLibrary& library) {
  std::vector<PlotBand> bands;
  for (std::size_t tick = 0; tick < tissues.size(); ++tick) {
    if (tissues[tick] == anatomy::tissue::air) continue;
    const anatomy::TissueProperties* properties = library.find(tissues[tick]);
    const std::uint32_t colour = properties != nullptr ? properties->colour : 0x808080U;
    const double from = static_cast<double>(tick) * dt, to = from + dt;
    const bool continues = !bands.empty() && tick > 0 && tissues[tick - 1] == tissues[tick];
    if (continues)
      bands.back().to = to;
    else
      bands.push_back({from, to, colour, ""});
  }
  return bands;
}

std::vector<Plot> profile_against_time(const study::Profile& profile, const anatomy::TissueLibrary& library) {
  Plot place, force;
  place.x_label = force.x_label = "time, s";
  place.y_label = "depth below the skin, mm";
  force.y_label = "resistance, N";
  place.height = 220.0;
  force.height = 180.0;
  std::vector<anatomy::TissueId> tissues;
  PlotSeries tip{.name = "tip", .colour = tip_colour, .width = 1.6}, resistance{.width = 1.4};
  const Vec3 direction = profile.path.direction();
  for (const simulation::TickRecord& record : profile.ticks) {
    tissues.push_back(record.output.tissue);
    tip.x.push_back(static_cast<double>(record.tick) * profile.dt);
    tip.y.push_back((record.input.needle.translation() - profile.path.entry).dot(direction) - profile.surface);
    resistance.y.push_back(record.output.resistance);
  }
  resistance.x = tip.x;
  place.series.push_back(std::move(tip));
  for (std::size_t i = 0; i < profile.diagnostics.size(); ++i) {
    if (is_place_on_line(profile.diagnostics[i].name)) add_place(place, profile, i);
  }
  force.series.push_back(std::move(resistance));
  place.bands = force.bands = bands_over_time(tissues, profile.dt, library);
  return {place, force};
}

}  // namespace bodkin::report
