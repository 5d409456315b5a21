#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <string_view>
#include <thread>
#include <vector>

#include "core/progress.h"

namespace bodkin {

// Calls work(k) for every slice k in [0, count) on all cores. Slices must not depend on each other, so that the
// result does not depend on the number of threads. Progress is reported from the calling thread.
template <typename Work>
void for_each_slice(int count, std::string_view stage, const Progress& progress, const Work& work) {
  std::atomic<int> next{0};
  const auto drain = [&](bool report) {
    const int every = std::max(count / 24, 1);
    for (int k = next++, done = 0; k < count; k = next++, ++done) {
      if (report && progress && done % every == 0) progress(stage, static_cast<double>(k) / count);
      work(k);
    }
  };
  std::exception_ptr failure;
  {
    std::vector<std::jthread> helpers;
    const unsigned cores = std::clamp(std::thread::hardware_concurrency(), 1u, 32u);
    for (unsigned i = 1; i < cores; ++i) helpers.emplace_back([&] { drain(false); });
    try {
      drain(true);
    } catch (...) {  // a progress callback that throws ends the work
      failure = std::current_exception();
      next = count;
    }
  }
  if (failure) std::rethrow_exception(failure);
  if (progress) progress(stage, 1.0);
}

}  // namespace bodkin
