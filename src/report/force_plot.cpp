#include "report/force_plot.h"

#include <algorithm>
#include <cmath>

#include "report/crossings.h"

#include "forces/gravity_compensation.h"
#include "haptics/force_governor.h"

namespace bodkin::report {

namespace {

constexpr double visible_difference = 0.1;  // N between request and applied force that are visible ...
constexpr double worth_a_curve = 0.01;      // ... and the fraction of ticks that makes a curve worthwhile
constexpr std::uint32_t earlier_colour = 0x9AA7B1, applied_colour = 0xD9722B, depth_colour = 0x2E8B6F;

}  // namespace

std::vector<session::SessionEvent> events_of(std::span<const simulation::TickRecord> ticks) {
  std::vector<session::SessionEvent> events;
  for (const simulation::TickRecord& record : ticks) {
    for (const forces::Event& event : record.output.events) events.push_back({record.tick, event});
  }
  return events;
}

Plot force_against_depth(std::span<const simulation::TickRecord> ticks, std::span<const session::SessionEvent> events,
                         double dt, const anatomy::Case& patient) {
  Plot plot;
  plot.x_label = "depth along the needle's line, mm";
  plot.y_label = "resistance, N";
  const std::vector<Insertion> all = insertions(ticks);
  if (all.empty()) return plot;
  const auto deepest = std::max_element(all.begin(), all.end(),
                                        [](const Insertion& a, const Insertion& b) { return a.deepest < b.deepest; });
  const auto part = ticks.subspan(deepest->first, deepest->last - deepest->first + 1);
  plot.bands = bands_of(tissues_crossed(part, dt), patient.library);

  PlotSeries force, earlier, applied;
  force.name = "tissue's resistance";
  earlier = {"other insertions", {}, {}, earlier_colour, 1.0, false};
  applied = {"passed on to the hand", {}, {}, applied_colour, 1.2, false};
  const forces::GravityCompensation compensation(patient.description.haptics.compensation);
  double highest = 0.0;
  std::size_t different = 0;
  for (const Insertion& insertion : all) {
    const bool main = insertion.first == deepest->first;
    for (std::size_t i = insertion.first; i <= insertion.last; ++i) {
      const simulation::TickRecord& record = ticks[i];
      const simulation::TickOutput& output = record.output;
      PlotSeries& series = main ? force : earlier;
      series.x.push_back(output.depth);
      series.y.push_back(output.resistance);
      if (!main) continue;
      highest = std::max(highest, output.resistance);
      // The resisting part of the applied force: without the device's weight, along the needle.
      const Vec3 felt = output.applied.force - compensation.step(record.input.needle.translation());
      applied.x.push_back(output.depth);
      applied.y.push_back(-felt.dot(needle_axis(record.input.needle)));
      different += std::abs(applied.y.back() - output.resistance) > visible_difference ? 1 : 0;
    }
  }
  if (!earlier.x.empty()) plot.series.push_back(earlier);
  plot.series.push_back(force);
  if (static_cast<double>(different) > worth_a_curve * static_cast<double>(part.size()))
    plot.series.push_back(applied);
  const double limit = highest_share * patient.description.device.peak_force;
  if (highest > limit) plot.y_highest = limit;

  for (const session::SessionEvent& event : events) {
    const bool inside = event.tick >= part.front().tick && event.tick <= part.back().tick;
    if (!inside || !is_notable(event.event.kind)) continue;
    const auto record =
        std::lower_bound(part.begin(), part.end(), event.tick,
                         [](const simulation::TickRecord& r, std::uint64_t tick) { return r.tick < tick; });
    if (record == part.end()) continue;
    // A puncture occurred at the force of the previous tick.
    const auto before = record == part.begin() ? record : record - 1;
    plot.marks.push_back({event.event.depth, std::max(record->output.resistance, before->output.resistance),
                          event_text(event.event, patient.library)});
  }
  return plot;
}

Plot force_and_depth_against_time(std::span<const simulation::TickRecord> ticks, double dt) {
  Plot plot;
  plot.x_label = "time, s";
  plot.y_label = "resistance, N";
  plot.right_label = "depth, mm";
  plot.height = 240.0;
  PlotSeries force, depth;
  force.name = "resistance";
  force.width = 1.4;
  depth = {"depth", {}, {}, depth_colour, 1.6, true};
  for (const simulation::TickRecord& record : ticks) {
    const double time = static_cast<double>(record.tick) * dt;
    force.x.push_back(time);
    force.y.push_back(record.output.resistance);
    depth.x.push_back(time);
    depth.y.push_back(record.output.depth);
  }
  plot.series = {depth, force};
  return plot;
}

Plot energy_against_time(std::span<const simulation::TickRecord> ticks, double dt) {
  Plot plot;
  plot.x_label = "time, s";
  plot.y_label = "energy, N mm";
  plot.height = 200.0;
  PlotSeries energy, damped;
  energy.name = "given by the hand so far";
  energy.width = 1.4;
  damped = {"not 0: damping was added", {}, {}, applied_colour, 1.2, false};
  bool any = false;
  for (const simulation::TickRecord& record : ticks) {
    const double time = static_cast<double>(record.tick) * dt;
    const bool acted = (record.output.limits & haptics::force_limit::passivity) != 0;
    energy.x.push_back(time);
    energy.y.push_back(record.output.energy);
    damped.x.push_back(time);
    damped.y.push_back(acted ? record.output.energy : 0.0);
    any = any || acted;
  }
  plot.series = {energy};
  if (any) plot.series.push_back(damped);
  return plot;
}

std::vector<Plot> second_hand_against_time(const session::Session& session) {
  PlotSeries depth, pressure, force;
  depth = {"depth of the needle", {}, {}, depth_colour, 1.6, true};
  pressure.name = "pressure in the syringe";
  pressure.width = force.width = 1.4;
  for (const simulation::TickRecord& record : session.ticks) {
    depth.x.push_back(static_cast<double>(record.tick) * session.header.dt);
    depth.y.push_back(record.output.depth);
  }
  for (const session::SecondSample& sample : session.second) {
    pressure.x.push_back(sample.time);
    pressure.y.push_back(1000.0 * sample.pressure);
    force.x.push_back(sample.time);
    force.y.push_back(sample.force);
  }
  Plot forces;
  forces.x_label = "time, s";
  forces.height = 200.0;
  if (!session.header.second || session.header.second->role == session::SecondRole::probe) {
    force.name = "force of the probe on the skin";
    forces.y_label = "force, N";
    forces.series = {force};
    return {forces};
  }
  Plot pressures = forces;
  pressures.y_label = "pressure, kPa";
  forces.y_label = "force, N";
  pressures.right_label = forces.right_label = "depth, mm";
  force.name = "force on the thumb";
  pressures.series = {depth, pressure};
  forces.series = {depth, force};
  return {pressures, forces};
}

}  // namespace bodkin::report
