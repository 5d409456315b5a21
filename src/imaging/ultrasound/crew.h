#pragma once

#include <atomic>
#include <thread>
#include <vector>

namespace bodkin {

// Threads that share loops. The caller takes part; with one thread nobody else is there. A loop's turns are dealt out
// beforehand (turn i to thread i % threads), and no thread takes memory or a lock while it works. Not for callers on
// several threads at once.
class Crew {
 public:
  // Throws std::system_error when a thread cannot be started.
  explicit Crew(int threads);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  // work(context, i) for every i from 0 to count - 1; back when all are done.
  void share(int count, void (*work)(void* context, int turn) noexcept, void* context) noexcept;

  template <typename Work>
  void share(int count, Work& work) noexcept {
    share(
        count, [](void* context, int turn) noexcept { (*static_cast<Work*>(context))(turn); }, &work);
  }

 private:
  void help(int member) noexcept;
  void take_part(int member) noexcept;

  std::atomic<unsigned> round_{0};
  std::atomic<int> busy_{0};
  std::atomic<bool> over_{false};
  void (*work_)(void*, int) noexcept = nullptr;
  void* context_ = nullptr;
  int count_ = 0;
  int members_ = 1;
  std::vector<std::thread> helpers_;
};

}  // namespace bodkin
