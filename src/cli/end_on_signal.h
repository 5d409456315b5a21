#pragma once

#include <array>
#include <atomic>
#include <csignal>

#include "station/station.h"

namespace bodkin::cli {

// During the lifetime of this object, Ctrl-C ends the station's session as a user would. Closing the terminal or
// shutting down the machine ends it too: force to zero, devices stopped, the recording complete. Without a station
// the command must poll for the signal. One at a time.
class EndOnSignal {
 public:
  EndOnSignal();
  explicit EndOnSignal(station::Station& station);
  ~EndOnSignal();
  EndOnSignal(const EndOnSignal&) = delete;
  EndOnSignal& operator=(const EndOnSignal&) = delete;

  // 0, or the signal that a shell reports as the end of the command: all except Ctrl-C, which is a user's normal way
  // to end a session.
  static int reason() noexcept;
  // 0, or the signal received, including Ctrl-C.
  static int signal() noexcept;

 private:
  void listen();

  static constexpr std::array<int, 3> signals = {SIGINT, SIGTERM, SIGHUP};

  std::array<void (*)(int), signals.size()> before_{};
};

}  // namespace bodkin::cli
