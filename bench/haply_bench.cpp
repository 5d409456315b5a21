// The cost of a round of Haply's driver without system calls: the JSON of the state in, of the command out. out.
#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "haptics/drivers/haply_messages.h"

namespace {

using namespace bodkin;
using namespace bodkin::haptics;

// As long as what an Inverse3 with a grip sends, some 1300 bytes.
const std::string message =
    R"({"inverse3":[{"device_id":"04BA","state":{"angular_position":{"a0":12.537841796875,"a1":-30.127685546875,)"
    R"("a2":75.25634765625},"angular_velocity":{"a0":0.12451171875,"a1":-0.3515625,"a2":0.87890625},)"
    R"("body_orientation":{"w":0.99987,"x":0.0012,"y":-0.0034,"z":0.0154},"control_domain":"cartesian",)"
    R"("control_mode":"force","current_cursor_force":{"x":0.123456789,"y":-1.23456789,"z":0.0123456789},)"
    R"("cursor_position":{"x":0.012345678901234567,"y":-0.14987654321098765,"z":0.20123456789012345},)"
    R"("cursor_velocity":{"x":0.0012345678901234567,"y":-0.0987654321098765,"z":0.00123456789012345},)"
    R"("transform":{"position":{"x":0.0,"y":0.0,"z":0.0},"rotation":{"w":1.0,"x":0.0,"y":0.0,"z":0.0},)"
    R"("scale":{"x":1.0,"y":1.0,"z":1.0}}},"status":{"calibrated":true,"in_use":true,"power_supply":true,)"
    R"("ready":true,"started":true}}],"session_id":7,"verse_grip":[],"wireless_verse_grip":[{"device_id":"61576",)"
    R"("state":{"battery_level":0.75,"buttons":{"a":false,"b":false,"c":true},"orientation":{)"
    R"("w":0.7071067811865476,"x":0.0,"y":0.0,"z":-0.7071067811865475},"transform":{"position":{"x":0.0,"y":0.0,)"
    R"("z":0.0},"rotation":{"w":1.0,"x":0.0,"y":0.0,"z":0.0},"scale":{"x":1.0,"y":1.0,"z":1.0}}},"status":{)"
    R"("awake":true,"connected":true,"ready":true}}]})";

void json_of_one_round(benchmark::State& state) {
  HaplyStateReader reader("04BA", "61576");
  HaplyCommandWriter writer("04BA", HaplyForceKey::vector);
  HaplyReading reading;
  std::vector<double> times;
  times.reserve(200'000);
  double force = 0.1;
  for (auto _ : state) {
    std::copy(message.begin(), message.end(), reader.buffer().begin());  // as the socket puts it there
    const auto start = std::chrono::steady_clock::now();
    if (!reader.read(message.size(), reading) || !reading.has_position) state.SkipWithError("it was not read");
    benchmark::DoNotOptimize(writer.force(reading.position * force));
    const auto end = std::chrono::steady_clock::now();
    force += 1e-7;
    times.push_back(std::chrono::duration<double, std::micro>(end - start).count());
  }
  std::sort(times.begin(), times.end());
  const auto at = [&times](double part) {
    return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))];
  };
  state.counters["bytes"] = static_cast<double>(message.size());
  state.counters["median_us"] = at(0.5);
  state.counters["p99_us"] = at(0.99);
  state.counters["max_us"] = times.back();
}

BENCHMARK(json_of_one_round)->Unit(benchmark::kMicrosecond)->Iterations(200'000);

}  // namespace
