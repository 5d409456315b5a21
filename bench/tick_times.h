#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

namespace bodkin {

// Processor time of this thread, us: other jobs' time is not counted, but their effect on the caches is, and so are
// the machine's own interrupts. Reading it takes about 0.3 us.
inline double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

// The quantile `part`, 0 to 1, of sorted values.
inline double quantile(const std::vector<double>& sorted, double part) {
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

// Reports times, us: least, median and high quantiles of all. A motion of `period` ticks that is gone through again
// and again gives `tick_p99.9_us` as well: of each of its ticks the median of all times that it was done, and of
// those the quantile. An interrupt, which meets one tick in some hundreds, is not in it; what the tick itself does
// is.
inline void report_times(benchmark::State& state, std::vector<double> times, std::size_t period = 0) {
  if (period > 0 && times.size() >= 3 * period) {
    std::vector<double> ticks;
    for (std::size_t tick = 0; tick < period; ++tick) {
      std::vector<double> again;
      for (std::size_t i = tick; i < times.size(); i += period) again.push_back(times[i]);
      std::sort(again.begin(), again.end());
      ticks.push_back(quantile(again, 0.5));
    }
    std::sort(ticks.begin(), ticks.end());
    state.counters["tick_p99.9_us"] = quantile(ticks, 0.999);
  }
  std::sort(times.begin(), times.end());
  state.counters["min_us"] = times.front();
  state.counters["median_us"] = quantile(times, 0.5);
  state.counters["p99_us"] = quantile(times, 0.99);
  state.counters["p99.9_us"] = quantile(times, 0.999);
}

// Times every call of `tick`, which is given its number, after a period of it (200 without one) that is not timed.
template <typename Tick>
void time_every_tick(benchmark::State& state, std::size_t period, Tick&& tick) {
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(state.max_iterations));
  for (int warm = 0; warm < (period > 0 ? static_cast<int>(period) : 200); ++warm) tick(warm);
  int number = 0;
  for (auto _ : state) {
    const double start = processor_time();
    tick(number++);
    times.push_back(processor_time() - start);
  }
  report_times(state, std::move(times), period);
}

// The machine's own contribution: a sum in registers of about 6 us, always the same work.
inline void machine_itself(benchmark::State& state) {
  time_every_tick(state, 0, [](int tick) {
    double sum = tick;
    for (int i = 0; i < 3300; ++i) sum = sum * 0.999 + 1.0;
    benchmark::DoNotOptimize(sum);
  });
}

}  // namespace bodkin
