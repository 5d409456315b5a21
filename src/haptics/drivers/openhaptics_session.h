#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "haptics/drivers/openhaptics_library.h"

namespace bodkin::haptics {

// HD is a singleton per process: one scheduler thread for all devices, one stack of errors. A session is shared by
// the open devices, and divides both between them.
//
// Outside the scheduler's thread the vendor allows calls about devices only while the scheduler is stopped. So
// opening, starting and stopping one device pauses the others briefly; they see a long dt, and the vendor ramps their
// force up again.
class OpenHapticsSession {
 public:
  // The running session, or a new one. Throws LibraryError, and DriverFailure when another library is in use.
  static std::shared_ptr<OpenHapticsSession> join(const std::string& library);

  explicit OpenHapticsSession(const std::string& library) : hd(library), chosen_(library) {}

  OpenHapticsLibrary hd;

  // Runs `call` while the scheduler is stopped, and starts the scheduler if a callback is scheduled; throws
  // DriverFailure when it does not start again.
  void paused(const std::function<void()>& call);

  // Only within paused(). The callback runs at every tick of the scheduler from its next start.
  unsigned long schedule(OpenHapticsLibrary::Callback callback, void* user);
  void unschedule(unsigned long callback);

  // Empties the stack of errors of all devices. Returns the newest of `device` (0 = success); those of other devices
  // are kept for their calls. Wait-free; for a thread that may call HD now.
  unsigned newest_error(unsigned device) noexcept;

  // "error 0x0302, 'communication error'"
  std::string words(unsigned code) const;

 private:
  static constexpr std::size_t most_devices = 16;

  void resume();

  std::string chosen_;
  std::mutex mutex_;
  int scheduled_ = 0;
  bool running_ = false;
  std::array<std::atomic<unsigned>, most_devices> pending_{};  // errors by handle modulo size
};

}  // namespace bodkin::haptics
