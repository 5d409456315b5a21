#include "station/device_check.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include <fmt/format.h>

namespace bodkin::station {

namespace {

constexpr std::chrono::milliseconds check_interval{10};
constexpr double least_success = 0.99;  // of the rounds must be on time

}  // namespace

DeviceObservation observe_device(haptics::DeviceServo& servo, double seconds,
                                 const std::function<bool(double elapsed)>& watch) {
  DeviceObservation seen;
  servo.start();
  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  while (elapsed() < seconds) {
    std::this_thread::sleep_for(check_interval);
    if (!watch(elapsed())) break;
    if (servo.rounds() == 0) continue;
    const haptics::ServoSnapshot& now = servo.tick().snapshot();
    if (now.device.fault != haptics::DeviceFault::none) {
      if (seen.fault == haptics::DeviceFault::none) seen.sentence = servo.explain();
      seen.fault = now.device.fault;
      continue;
    }
    if (now.device.ended()) break;
    seen.low = seen.low.cwiseMin(now.device.hand.translation());
    seen.high = seen.high.cwiseMax(now.device.hand.translation());
    seen.buttons |= now.device.buttons;
    seen.hottest = std::max(seen.hottest, now.device.temperature);
    seen.strongest = std::max(seen.strongest, now.applied.force.norm());
    if (!now.device.held) seen.released += std::chrono::duration<double>(check_interval).count();
  }
  seen.seconds = elapsed();
  seen.rounds = servo.rounds();
  seen.timings = servo.tick().timings();
  seen.answered = servo.stop();
  return seen;
}

std::string why_not_ready(const DeviceObservation& seen, const haptics::DeviceAbilities& abilities) {
  if (seen.fault != haptics::DeviceFault::none) {
    return seen.sentence.empty() ? fmt::format("the device reported a fault: {}", haptics::text_of(seen.fault))
                                 : seen.sentence;
  }
  if (seen.rounds == 0) return "the device did not answer once; is it switched on?";
  if (!seen.answered) return "the device could not be stopped; switch it off and on again";
  if (seen.rate() < 0.9 * abilities.rate) {
    return fmt::format("{:.0f} ticks a second instead of {:.0f}; close other programs, or use a lower rate",
                       seen.rate(), abilities.rate);
  }
  const double late = seen.timings.ticks == 0
                          ? 0.0
                          : static_cast<double>(seen.timings.overruns) / static_cast<double>(seen.timings.ticks);
  if (1.0 - late < least_success) {
    return fmt::format(
        "{:.1f} % of the ticks were late; close other programs, and permit real-time priority (docs/perform.md)",
        100.0 * late);
  }
  return "";
}

}  // namespace bodkin::station
