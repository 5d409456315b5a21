#include "cli/interruptible_wait.h"

#include <atomic>

namespace bodkin::cli {

namespace {

std::atomic<bool> waiting_ended{false};

void end_waiting(int) {
  waiting_ended.store(true);
}

}  // namespace

InterruptibleWait::InterruptibleWait() {
  waiting_ended.store(false);
  for (std::size_t i = 0; i < signals.size(); ++i) before_[i] = std::signal(signals[i], &end_waiting);
}

InterruptibleWait::~InterruptibleWait() {
  for (std::size_t i = 0; i < signals.size(); ++i) std::signal(signals[i], before_[i]);
}

bool InterruptibleWait::is_ended() noexcept {
  return waiting_ended.load();
}

}  // namespace bodkin::cli
