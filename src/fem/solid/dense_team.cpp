#include "fem/solid/dense_team.h"

#include <system_error>

namespace bodkin {

DenseTeam::DenseTeam(int threads) {
  if (threads == 0) threads = static_cast<int>(std::thread::hardware_concurrency());
  try {
    for (int i = 1; i < threads; ++i) helpers_.emplace_back([this] { help(); });
  } catch (const std::system_error&) {  // the machine gives no more: so many do it too
  }
}

DenseTeam::~DenseTeam() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  given_.notify_all();
}

// Does one piece, if one is left; the lock is not held meanwhile.
bool DenseTeam::take(std::unique_lock<std::mutex>& lock) {
  if (next_ == count_) return false;
  const std::size_t piece = next_++;
  const auto& work = *work_;
  lock.unlock();
  work(piece);
  lock.lock();
  if (++finished_ == count_) done_.notify_all();
  return true;
}

void DenseTeam::help() {
  std::unique_lock lock(mutex_);
  while (true) {
    given_.wait(lock, [this] { return ends_ || next_ < count_; });
    if (ends_) return;
    take(lock);
  }
}

void DenseTeam::run(std::size_t count, const std::function<void(std::size_t)>& work) {
  if (helpers_.empty() || count < 2) {
    for (std::size_t piece = 0; piece < count; ++piece) work(piece);
    return;
  }
  std::unique_lock lock(mutex_);
  work_ = &work;
  next_ = finished_ = 0;
  count_ = count;
  given_.notify_all();
  while (take(lock)) {
  }
  done_.wait(lock, [this] { return finished_ == count_; });
  count_ = next_ = 0;
}

}  // namespace bodkin
