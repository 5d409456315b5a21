#pragma once

#include <algorithm>
#include <concepts>
#include <string_view>
#include <thread>
#include <type_traits>

#include "core/progress.h"
#include "core/thread_pool.h"

namespace bodkin {

// ThreadPool::run() for a single long loop: starts and ends its threads here, by default one per core.
template <std::integral Index, typename Work>
void parallel_for(Index count, const Work& work) {
  const auto cores = static_cast<Index>(std::max(std::thread::hardware_concurrency(), 1U));
  ThreadPool(static_cast<int>(std::clamp(count, Index{1}, cores))).run(count, work);
}

// As above, with a report from the calling thread of the fraction done, as `stage`, after every 24th part of the loop
// and at its end. An exception from `progress` ends the loop and is thrown from here. `threads`: as for ThreadPool.
template <std::integral Index, typename Work>
void parallel_for(Index count, std::string_view stage, const Progress& progress, const Work& work, int threads = 0) {
  const Index every = std::max(static_cast<Index>(count / 24), Index{1});
  Index next_report = 0;  // only the calling thread uses it
  ThreadPool(threads).run(count, [&](Index index, int thread) {
    if (thread == 0 && progress && index >= next_report) {
      progress(stage, static_cast<double>(index) / static_cast<double>(count));
      next_report = index + every;
    }
    if constexpr (std::is_invocable_v<const Work&, Index, int>) {
      work(index, thread);
    } else {
      work(index);
    }
  });
  if (progress) progress(stage, 1.0);
}

}  // namespace bodkin
