#include <algorithm>

#include "training/metric_groups.h"

namespace bodkin::training {

namespace {

using forces::EventKind;

constexpr double centimetre = 10.0;    // mm
constexpr double millilitre = 1000.0;  // mm^3
constexpr double least_amount =
    1000.0;  // mm^3; before they are collected a pressure is the opening one, then the closing one

// The handling of the fluid, over all insertions.
struct FluidRecord {
  double collected = 0.0;  // mm^3
  double readings = 0.0;
  std::optional<double> opening, closing, settling;  // mm, mm, s
  double open_withdrawals = 0.0;
};

FluidRecord read_fluid(const Attempt& attempt) {
  const anatomy::CsfFlowSettings& settings = *attempt.session().header.haptics.parts.csf_flow;
  FluidRecord found;
  double of_earlier = 0.0, of_this = 0.0;  // mm^3, of the insertions before and of the present one
  std::size_t connected = 0;
  bool returned = false;
  for (const session::SessionEvent& each : attempt.session().events) {
    const forces::Event& event = each.event;
    const std::size_t index = attempt.index_of(each);
    switch (event.kind) {
      case EventKind::contact:
        of_earlier += of_this;
        of_this = 0.0;
        returned = false;
        break;
      case EventKind::fluid_returned:
        returned = true;
        if (settings.manometer != attempt.session().ticks[index].input.other.manometer_moved) connected = index;
        break;
      case EventKind::manometer_on:
        connected = index;
        break;
      case EventKind::fluid_collected:
        of_this = event.value;
        break;
      case EventKind::pressure_read:
        found.readings += 1.0;
        if (!found.opening && of_earlier + of_this < least_amount) {
          found.opening = event.value;
          found.settling = attempt.time[index] - attempt.time[connected];
        } else if (of_earlier + of_this >= least_amount) {
          found.closing = event.value;
        }
        break;
      case EventKind::withdrawn:
        // With the stylet out, only fluid proves an open way: a touch of the skin does not matter.
        if (returned && settings.stylet == attempt.session().ticks[index].input.other.stylet_moved)
          found.open_withdrawals += 1.0;
        break;
      default:
        break;
    }
  }
  found.collected = of_earlier + of_this;
  return found;
}

std::optional<FluidRecord> fluid_of(const Measured& measured) {
  if (!measured.attempt.session().header.haptics.parts.csf_flow) return std::nullopt;
  return read_fluid(measured.attempt);
}

std::optional<double> scaled(const std::optional<double>& value, double unit) {
  return value ? std::optional(*value / unit) : std::nullopt;
}

std::optional<double> pressure_readings(const Measured& measured) {
  const auto fluid = fluid_of(measured);
  return fluid ? std::optional(fluid->readings) : std::nullopt;
}
std::optional<double> opening_pressure(const Measured& measured) {
  const auto fluid = fluid_of(measured);
  return fluid ? scaled(fluid->opening, centimetre) : std::nullopt;
}
std::optional<double> pressure_settling(const Measured& measured) {
  const auto fluid = fluid_of(measured);
  return fluid ? fluid->settling : std::nullopt;
}
std::optional<double> collected_volume(const Measured& measured) {
  const auto fluid = fluid_of(measured);
  return fluid ? std::optional(fluid->collected / millilitre) : std::nullopt;
}
std::optional<double> closing_pressure(const Measured& measured) {
  const auto fluid = fluid_of(measured);
  return fluid ? scaled(fluid->closing, centimetre) : std::nullopt;
}
std::optional<double> open_withdrawals(const Measured& measured) {
  const auto fluid = fluid_of(measured);
  return fluid ? std::optional(fluid->open_withdrawals) : std::nullopt;
}

}  // namespace

std::vector<Metric> metrics_of_fluid() {
  return {
      {"pressure_readings", "", "pressures read",
       "columns that settled in the manometer, where the patient has the part csf_flow", "Bodkin", pressure_readings},
      {"opening_pressure_cmH2O", "cmH2O", "opening pressure",
       "first settled height in the manometer, before a millilitre was collected", "Bodkin", opening_pressure},
      {"pressure_settling_s", "s", "time until the opening pressure was read",
       "from connecting the manometer, or the first fluid in it, to a column within 2 % of the pressure", "Bodkin",
       pressure_settling},
      {"collected_mL", "mL", "fluid collected",
       "what dripped, and what was in the manometer when it was taken off, over all insertions", "Bodkin",
       collected_volume},
      {"closing_pressure_cmH2O", "cmH2O", "closing pressure",
       "last settled height in the manometer, after a millilitre was collected", "Bodkin", closing_pressure},
      {"withdrawn_open", "", "withdrawals without the stylet",
       "withdrawals after fluid had returned with the stylet not put back", "Strupp et al. 1998", open_withdrawals}};
}

}  // namespace bodkin::training
