#include "cli/wait_for_order.h"

#include <atomic>

namespace bodkin::cli {

namespace {

std::atomic<bool> waiting_ended{false};

void end_waiting(int) {
  waiting_ended.store(true);
}

}  // namespace

WaitForOrder::WaitForOrder() {
  waiting_ended.store(false);
  for (std::size_t i = 0; i < signals.size(); ++i) before_[i] = std::signal(signals[i], &end_waiting);
}

WaitForOrder::~WaitForOrder() {
  for (std::size_t i = 0; i < signals.size(); ++i) std::signal(signals[i], before_[i]);
}

bool WaitForOrder::is_ended() noexcept {
  return waiting_ended.load();
}

}  // namespace bodkin::cli
