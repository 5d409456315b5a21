#pragma once

#include <QSocketNotifier>
#include <array>
#include <csignal>
#include <memory>

namespace bodkin::app {

// During its lifetime, the end of the terminal or of the machine (SIGHUP, SIGTERM) and Ctrl-C close the application's
// windows like a person: running work is saved, and the force is ramped to zero. QApplication::exec() then returns
// the exit code that a shell expects of a signal, 128 plus its number; 0 after Ctrl-C. One at a time, with a
// QApplication.
class CloseOnSignal {
 public:
  // Throws SystemError when the system has no pipe left.
  CloseOnSignal();
  ~CloseOnSignal();
  CloseOnSignal(const CloseOnSignal&) = delete;
  CloseOnSignal& operator=(const CloseOnSignal&) = delete;

 private:
  static constexpr std::array<int, 3> ending_signals = {SIGINT, SIGTERM, SIGHUP};

  void close_windows();

  std::array<int, 2> pipe_ = {-1, -1};  // the signal's number is written to [1]; a handler may do no more than write
  std::unique_ptr<QSocketNotifier> notifier_;
  std::array<struct sigaction, ending_signals.size()> before_{};
};

}  // namespace bodkin::app
