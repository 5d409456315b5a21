#pragma once

#include <array>
#include <csignal>

namespace bodkin::cli {

// During its lifetime, if no session is running, Ctrl-C, closing the terminal or shutting down the machine ends the
// waiting. One at a time; a nested EndOnSignal handles the signals during a session.
class InterruptibleWait {
 public:
  InterruptibleWait();
  ~InterruptibleWait();
  InterruptibleWait(const InterruptibleWait&) = delete;
  InterruptibleWait& operator=(const InterruptibleWait&) = delete;

  static bool is_ended() noexcept;

 private:
  static constexpr std::array<int, 3> signals = {SIGINT, SIGTERM, SIGHUP};

  std::array<void (*)(int), signals.size()> before_{};
};

}  // namespace bodkin::cli
