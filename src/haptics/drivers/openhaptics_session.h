#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "haptics/drivers/openhaptics_library.h"

namespace bodkin::haptics {

// HD is one per process: one scheduler thread for all devices, one stack of errors. A session is shared by the
// devices that are open, and rations both.
//
// Outside the scheduler's thread the vendor allows calls about devices only while the scheduler stands. So opening,
// starting and stopping one device pauses the others for a moment; they see a long dt, and the vendor ramps their
// force up again.
class OpenHapticsSession {
 public:
  // The session that is running, or a new one. Throws LibraryError, and DriverFailure when another library is in use.
  static std::shared_ptr<OpenHapticsSession> join(const std::string& library);

  explicit OpenHapticsSession(const std::string& library) : hd(library), chosen_(library) {}

  OpenHapticsLibrary hd;

  // Runs `call` while the scheduler stands. It runs afterwards where a callback is scheduled; throws DriverFailure
  // when it does not start again.
  void paused(const std::function<void()>& call);

  // Within paused() alone. The callback runs at every tick of the scheduler from its next start.
  unsigned long schedule(OpenHapticsLibrary::Callback callback, void* user);
  void unschedule(unsigned long callback);

  // Takes the stack of errors apart, whosever they are. Returns the newest of `device` (0 = success); the other
  // devices find theirs when they ask. Wait-free; for whoever may call HD now.
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
