// The cost of the servo without tissue: commands, workspace, governor with passivity, guard, timings, snapshot. The
// hand shakes a little in a spring, so that nothing is skipped. The haptic tick on top of it is in tick_bench.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/latest_value.h"
#include "haptics/force_governor.h"
#include "haptics/servo_tick.h"

namespace {

using namespace bodkin;
using namespace bodkin::haptics;

ServoSettings settings() {
  ServoSettings made;
  DeviceAbilities touch;
  touch.peak_force = 3.3;
  touch.continuous_force = 0.88;
  touch.stiffness = 0.7;
  touch.resolution = 0.055;
  touch.workspace_low = Vec3(-80.0, -35.0, -60.0);
  touch.workspace_high = -touch.workspace_low;
  made.guard = guard_settings(touch, 1000.0);
  made.workspace.tip_offset = Vec3(0.0, 0.0, 39.0);
  return made;
}

// A spring along the needle, through the governor.
class Spring {
 public:
  Control operator()(const ControlInput& input) {
    const double depth = 39.0 - input.needle.translation().z();
    const ForceRequest request{.resistance = 0.1 * depth,
                               .axis = -Vec3::UnitZ(),
                               .velocity = (depth - last_) / 0.001,
                               .in_contact = true,
                               .constraint = Vec3(0.01 * input.needle.translation().x(), 0.0, 0.0)};
    last_ = depth;
    return {{governor_.step(request), governor_.torque()}, 0.0};
  }

 private:
  ForceGovernor governor_{GovernorSettings{}};
  double last_ = 0.0;
};

std::vector<DeviceState> motion() {
  std::vector<DeviceState> states(4096);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const double angle = 2.0 * 3.14159265358979323846 * static_cast<double>(i) / 4096.0;
    const Vec3 place(3.0 * std::sin(angle), 0.5 * std::sin(3.0 * angle), -4.0 + 4.0 * std::cos(4.0 * angle));
    states[i].hand.translation() = (place / 0.055).array().round().matrix() * 0.055;
    states[i].hand.linear() = Eigen::AngleAxisd(0.1 * std::sin(angle), Vec3::UnitX()).toRotationMatrix();
  }
  return states;
}

std::unique_ptr<ServoTick> armed() {
  auto servo = std::make_unique<ServoTick>(settings(), Spring());
  const DeviceState still;
  for (int i = 0; i < 60; ++i) servo->step(still, 0.001);
  servo->command({.kind = ServoCommand::Kind::arm});
  for (int i = 0; i < 1100; ++i) servo->step(still, 0.001);
  return servo;
}

void servo_batch(benchmark::State& state) {
  const auto servo = armed();
  const auto states = motion();
  for (auto _ : state) {
    for (const DeviceState& device : states) benchmark::DoNotOptimize(servo->step(device, 0.001));
  }
  if (servo->snapshot().state != GuardState::active) state.SkipWithError("the guard has ended the force");
  const double steps = static_cast<double>(state.iterations()) * static_cast<double>(states.size());
  state.counters["per_tick"] = benchmark::Counter(steps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// Every tick on its own, clock included (20 to 40 ns).
void servo_single_tick(benchmark::State& state) {
  const auto servo = armed();
  const auto states = motion();
  std::vector<double> times;
  times.reserve(states.size() * 200);
  for (auto _ : state) {
    for (const DeviceState& device : states) {
      const auto start = std::chrono::steady_clock::now();
      benchmark::DoNotOptimize(servo->step(device, 0.001));
      const auto end = std::chrono::steady_clock::now();
      times.push_back(std::chrono::duration<double, std::nano>(end - start).count());
    }
  }
  if (servo->snapshot().state != GuardState::active) state.SkipWithError("the guard has ended the force");
  std::sort(times.begin(), times.end());
  const auto at = [&times](double part) {
    return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))];
  };
  state.counters["median_ns"] = at(0.5);
  state.counters["p99_ns"] = at(0.99);
  state.counters["p99.9_ns"] = at(0.999);
  state.counters["max_ns"] = times.back();
}

void guard_alone(benchmark::State& state) {
  HandGuard guard(settings().guard);
  const auto states = motion();
  for (int i = 0; i < 60; ++i) guard.step(DeviceState{}, {.dt = 0.001});
  guard.arm();
  for (auto _ : state) {
    for (const DeviceState& device : states) {
      const Vec3 force(0.0, 0.0, -0.1 * device.hand.translation().z());
      benchmark::DoNotOptimize(guard.step(device, {.wanted = {force, Vec3::Zero()}, .dt = 0.001}));
    }
  }
  if (guard.state() != GuardState::active) state.SkipWithError("the guard has ended the force");
  const double steps = static_cast<double>(state.iterations()) * static_cast<double>(states.size());
  state.counters["per_tick"] = benchmark::Counter(steps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void newest_value(benchmark::State& state) {
  LatestValue<ServoSnapshot> value;
  const ServoSnapshot snapshot;
  for (auto _ : state) {
    value.write(snapshot);
    benchmark::DoNotOptimize(value.read());
  }
}

BENCHMARK(servo_batch)->Unit(benchmark::kMillisecond);
BENCHMARK(servo_single_tick)->Unit(benchmark::kMillisecond)->Iterations(200);
BENCHMARK(guard_alone)->Unit(benchmark::kMillisecond);
BENCHMARK(newest_value);

}  // namespace
