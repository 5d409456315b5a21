#pragma once

#include <array>
#include <csignal>

namespace bodkin::cli {

// While this lives and no session runs, Ctrl-C, the end of the terminal or of the machine ends the waiting. One at a
// time; EndOnSignal inside it has the signals while a session runs.
class WaitForOrder {
 public:
  WaitForOrder();
  ~WaitForOrder();
  WaitForOrder(const WaitForOrder&) = delete;
  WaitForOrder& operator=(const WaitForOrder&) = delete;

  static bool is_ended() noexcept;

 private:
  static constexpr std::array<int, 3> signals = {SIGINT, SIGTERM, SIGHUP};

  std::array<void (*)(int), signals.size()> before_{};
};

}  // namespace bodkin::cli
