// What a needle in a deformable body costs: a corridor of 1000 nodes, k of which the needle holds. The motion is
// recorded beforehand and the state is warm.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "fem/contact_factor.h"
#include "tests/fem/dense_body.h"
#include <benchmark/benchmark.h>

namespace {

using namespace bodkin;

const CondensedBody& corridor() {
  static const CondensedBody body = checks::kelvin_body(5, 40, 2.0);  // 1000 nodes
  return body;
}

// Median and high quantiles of times, us.
void report(benchmark::State& state, std::vector<double>& times) {
  std::sort(times.begin(), times.end());
  const auto at = [&times](double part) {
    return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))];
  };
  state.counters["median_us"] = at(0.5);
  state.counters["p99_us"] = at(0.99);
  state.counters["p99.9_us"] = at(0.999);
  state.counters["max_us"] = times.back();
}

template <typename Tick>
void every_tick_on_its_own(benchmark::State& state, Tick&& tick) {
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(state.max_iterations));
  for (int warm = 0; warm < 2000; ++warm) tick(warm);
  int number = 0;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    tick(number++);
    const auto end = std::chrono::steady_clock::now();
    times.push_back(std::chrono::duration<double, std::micro>(end - start).count());
  }
  report(state, times);
}

// The factor alone: a solve every tick; every 20 ticks a node comes or goes at the end, as at a needle's tip, or
// (second argument 1) one leaves from anywhere.
void factor_tick(benchmark::State& state) {
  const auto nodes = static_cast<std::size_t>(state.range(0));
  const bool anywhere = state.range(1) != 0;
  ContactFactor factor(corridor().compliance, 170);
  Random random(1);
  const auto grow = [&] {
    while (!factor.append(static_cast<std::uint32_t>(random.next() % corridor().nodes.size()), Mat3::Identity())) {
    }
  };
  while (factor.constraints() < nodes) grow();
  std::vector<double> values(3 * 170);
  bool more = true;
  every_tick_on_its_own(state, [&](int tick) {
    if (tick % 20 == 0) {
      if (more) {
        grow();
      } else if (anywhere) {
        factor.remove(random.next() % factor.constraints());
      } else {
        factor.remove_last();
      }
      more = factor.constraints() <= nodes;
    }
    for (std::size_t i = 0; i < factor.rows(); ++i)
      values[i] = std::sin(0.001 * tick) + 0.01 * static_cast<double>(i);
    factor.solve(values);
    benchmark::DoNotOptimize(values.data());
  });
}

BENCHMARK(factor_tick)->ArgNames({"k", "anywhere"})->ArgsProduct({{1, 10, 50, 150}, {0, 1}})->Iterations(50000);

}  // namespace
