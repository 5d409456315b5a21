#include "station/device_protocol.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include <fmt/format.h>

namespace bodkin::station {

namespace {

constexpr std::chrono::milliseconds look_interval{2};
constexpr double least_travel = 20.0;     // mm that a hand moves in a direction
constexpr double least_share = 0.7;       // of its way, in that direction
constexpr double least_downwards = 0.8;   // cosine of the tool's angle to straight down
constexpr double least_release = 0.3;     // s without a hand
constexpr double steady_spread = 2.0;     // mm of a handle that is left at rest
constexpr std::size_t most_faults = 100;  // kept of a step

constexpr std::string_view step_let_go = "let_go", step_buttons = "buttons", step_pointing = "pointing",
                           step_rest = "rest";

struct Reading {
  Vec3 place, axis;
};

Vec3 mean_of(const std::vector<Reading>& readings, std::size_t begin, std::size_t end) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = begin; i < end; ++i) sum += readings[i].place;
  return sum / static_cast<double>(end - begin);
}

void summarise(const std::vector<Reading>& readings, ProtocolFinding& found) {
  if (readings.empty()) return;
  const std::size_t tenth = std::max<std::size_t>(1, readings.size() / 10);
  found.from = mean_of(readings, 0, tenth);
  found.to = mean_of(readings, readings.size() - tenth, readings.size());
  found.axis_from = readings.front().axis;
  found.axis_to = readings.back().axis;
  found.low = found.high = readings.front().place;
  const Vec3 mean = mean_of(readings, 0, readings.size());
  Vec3 squares = Vec3::Zero(), smallest = Vec3::Constant(std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const Vec3& place = readings[i].place;
    found.low = found.low.cwiseMin(place);
    found.high = found.high.cwiseMax(place);
    squares += (place - mean).cwiseAbs2();
    for (Eigen::Index axis = 0; axis < 3 && i > 0; ++axis) {
      const double change = std::abs(place[axis] - readings[i - 1].place[axis]);
      if (change > 0.0) smallest[axis] = std::min(smallest[axis], change);
    }
  }
  found.spread = (squares / static_cast<double>(readings.size())).cwiseSqrt();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (std::isfinite(smallest[axis])) found.smallest[axis] = smallest[axis];
  }
}

std::string speaks_against(const ProtocolStep& step, const haptics::DeviceAbilities& device,
                           const ProtocolFinding& found) {
  if (found.rounds == 0) return "the loop did not run";
  const Vec3 way = found.to - found.from;
  const double along = way.dot(step.towards);
  if (!step.towards.isZero() && (along < least_travel || along < least_share * way.norm())) {
    return fmt::format("the hand moved by {:.0f} {:.0f} {:.0f} mm (right, away, up)", way.x(), way.y(), way.z());
  }
  if (step.name == step_pointing && found.axis_to.z() > -least_downwards) {
    return fmt::format("the tool's axis was {:.2f} {:.2f} {:.2f} (right, away, up)", found.axis_to.x(),
                       found.axis_to.y(), found.axis_to.z());
  }
  if (step.name == step_rest && found.spread.maxCoeff() > steady_spread) return "the readings were not steady";
  if (step.name == step_buttons && found.buttons == 0) return "no button was seen";
  if (step.name == step_let_go && device.has_dead_man && found.released < least_release) {
    return "the device did not report that it was let go";
  }
  return "";
}

}  // namespace

std::vector<ProtocolStep> protocol_steps(const haptics::DeviceAbilities& device) {
  std::vector<ProtocolStep> steps = {
      {step_rest, "Leave the handle alone, or hold it as still as you can."},
      {"right", "Move the handle 5 cm or more to your right, and keep it there.", Vec3::UnitX()},
      {"away", "Move it 5 cm or more straight away from you, and keep it there.", Vec3::UnitY()},
      {"up", "Move it 5 cm or more straight up, and keep it there.", Vec3::UnitZ()},
      {"corners", "Move it to every corner of its workspace."}};
  if (device.measures_rotation) {
    steps.push_back({step_pointing, "Point the tool straight down, and keep it so."});
    steps.push_back({"turning", "Turn the tool about its own axis, clockwise as you look along it."});
  }
  steps.push_back({step_buttons, "Press every button of the device, one after the other."});
  if (device.has_dead_man)
    steps.push_back({step_let_go, "Let go of the handle for two seconds, then hold it again."});
  steps.push_back({last_protocol_step,
                   "If the device has an emergency stop, press it and release it; else unplug its cable, and "
                   "plug it in again."});
  return steps;
}

ProtocolFinding observe_step(haptics::DeviceServo& servo, const haptics::DeviceAbilities& device,
                             const ProtocolStep& step, double seconds,
                             const std::function<bool(double elapsed)>& watch) {
  using Clock = std::chrono::steady_clock;
  ProtocolFinding found;
  found.name = step.name;
  const std::uint64_t rounds = servo.rounds();
  const auto begin = Clock::now();
  std::vector<Reading> readings;
  readings.reserve(static_cast<std::size_t>(seconds * 500.0) + 1);
  haptics::DeviceFault before = haptics::DeviceFault::none;
  std::uint64_t last_tick = 0;
  for (;;) {
    std::this_thread::sleep_for(look_interval);
    found.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    if (found.seconds >= seconds || !watch(found.seconds)) break;
    if (servo.rounds() == rounds) continue;
    const haptics::ServoSnapshot& now = servo.tick().snapshot();
    if (now.device.fault != before && now.device.fault != haptics::DeviceFault::none &&
        found.faults.size() < most_faults) {
      found.faults.push_back({found.seconds, now.device.fault, servo.explain()});
    }
    before = now.device.fault;
    if (before != haptics::DeviceFault::none || now.tick == last_tick) continue;
    last_tick = now.tick;
    readings.push_back({now.device.hand.translation(), now.device.hand.linear().col(2)});
    found.buttons |= now.device.buttons;
    found.hottest = std::max(found.hottest, now.device.temperature);
    found.strongest = std::max(found.strongest, now.applied.force.norm());
    if (!now.device.held) found.released += std::chrono::duration<double>(look_interval).count();
    if (now.device.ended()) break;
  }
  found.rounds = servo.rounds() - rounds;
  summarise(readings, found);
  found.against = speaks_against(step, device, found);
  return found;
}

}  // namespace bodkin::station
