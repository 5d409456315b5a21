#include "report/force_limits.h"

#include <array>

#include <fmt/format.h>

#include "haptics/force_governor.h"

namespace bodkin::report {

namespace {

constexpr double limit_worth_telling = 0.05;  // s
constexpr std::array<std::uint8_t, 5> limit_flags = {haptics::force_limit::peak, haptics::force_limit::thermal,
                                                     haptics::force_limit::passivity, haptics::force_limit::slew,
                                                     haptics::force_limit::fault};

// The governor's effect on the force under one limit.
std::string limit_text(std::uint8_t limit, const anatomy::DeviceLimits& device) {
  switch (limit) {
    case haptics::force_limit::peak:
      return fmt::format("the device can push no more than {:g} N", device.peak_force);
    case haptics::force_limit::thermal:
      return fmt::format("its motors can hold no more than {:g} N for long", device.continuous_force);
    case haptics::force_limit::passivity:
      return "the tissue would have given back more energy than the hand had put in, and was damped";
    case haptics::force_limit::slew:
      return "the force would have risen faster than the limit allows";
    default:
      return "after a fault the force was taken to zero";
  }
}

std::string times(int count) {
  return count == 1 ? "once" : (count == 2 ? "twice" : fmt::format("{} times", count));
}

}  // namespace

ForceLimits force_limits(const session::Session& session) {
  ForceLimits found;
  bool limited_before = false;
  std::array<double, limit_flags.size()> limit_times{};
  for (const simulation::TickRecord& record : session.ticks) {
    const bool limited = (record.output.limits & ~haptics::force_limit::stiffness) != 0;
    for (std::size_t n = 0; n < limit_flags.size(); ++n) {
      if ((record.output.limits & limit_flags[n]) != 0) limit_times[n] += session.header.dt;
    }
    found.interventions += limited && !limited_before ? 1 : 0;
    found.time += limited ? session.header.dt : 0.0;
    limited_before = limited;
  }
  for (std::size_t n = 0; n < limit_flags.size(); ++n) {
    if (limit_times[n] > 0.0) found.limits.push_back({limit_flags[n], limit_times[n]});
  }
  return found;
}

std::string ForceLimits::sentence(const anatomy::DeviceLimits& device) const {
  if (time <= limit_worth_telling) return {};
  std::string reasons;
  for (const LimitTime& each : limits) {
    reasons += fmt::format("{}{} ({:.2f} s)", reasons.empty() ? "" : "; ", limit_text(each.limit, device), each.time);
  }
  return fmt::format("The force was limited {}, {:.2f} s in all: {}.", times(interventions), time, reasons);
}

}  // namespace bodkin::report
