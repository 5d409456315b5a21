#pragma once

#include <array>
#include <atomic>
#include <csignal>

#include "station/station.h"

namespace bodkin::cli {

// While this lives, Ctrl-C ends the station's session as a person would. The end of the terminal or of the machine
// ends it too: force to zero, devices stopped, the recording complete. Without a station it is for the command to ask
// whether it is to end. One at a time.
class EndOnSignal {
 public:
  EndOnSignal();
  explicit EndOnSignal(station::Station& station);
  ~EndOnSignal();
  EndOnSignal(const EndOnSignal&) = delete;
  EndOnSignal& operator=(const EndOnSignal&) = delete;

  // 0, or the signal that a shell reports as the end of the command: all but Ctrl-C, with which a person ends a
  // session.
  static int reason() noexcept;
  // 0, or the signal that came, Ctrl-C too.
  static int signal() noexcept;

 private:
  void listen();

  static constexpr std::array<int, 3> signals = {SIGINT, SIGTERM, SIGHUP};

  std::array<void (*)(int), signals.size()> before_{};
};

}  // namespace bodkin::cli
