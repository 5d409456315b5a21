#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace bodkin {

// Calls work(slice) once for every slice 0 .. count - 1, on all cores. The calls must not throw and must not write to
// the same memory.
template <typename Work>
void for_each_slice(int count, const Work& work) {
  const int threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, std::max(1, count));
  std::atomic<int> next = 0;
  const auto take = [&] {
    for (int slice = next++; slice < count; slice = next++) work(slice);
  };
  std::vector<std::jthread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(take);
  take();
}

}  // namespace bodkin
