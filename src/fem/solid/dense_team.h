#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace bodkin {

// Threads that share out dense work while a body is prepared. They wait without spinning. What is computed does not
// depend on how many they are: the pieces are cut by whoever gives the work, and each is one thread's.
class DenseTeam {
 public:
  // `threads`: with the one that calls run(), 1 or more; 0: as many as the machine has cores.
  explicit DenseTeam(int threads);
  ~DenseTeam();
  DenseTeam(const DenseTeam&) = delete;
  DenseTeam& operator=(const DenseTeam&) = delete;

  // work(0) to work(count - 1), each once, in any order and on any thread; returns when all are done. `work` must not
  // throw.
  void run(std::size_t count, const std::function<void(std::size_t)>& work);

 private:
  void help();
  bool take(std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable given_, done_;
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::size_t count_ = 0, next_ = 0, finished_ = 0;
  bool ends_ = false;
  std::vector<std::jthread> helpers_;
};

}  // namespace bodkin
