#include "haptics/drivers/openhaptics_session.h"

#include <cstdio>

#include "haptics/drivers/driver_adapter.h"

namespace bodkin::haptics {

namespace {

constexpr int deepest_stack = 64;  // a stack that never empties must not delay the tick

bool is_of_scheduler(unsigned code) {
  return code >= openhaptics::first_scheduler_error && code <= openhaptics::last_scheduler_error;
}

}  // namespace

std::shared_ptr<OpenHapticsSession> OpenHapticsSession::join(const std::string& library) {
  // The vendor's library has one state per process; this is its owner.
  static std::mutex mutex;
  static std::weak_ptr<OpenHapticsSession> current;
  const std::lock_guard lock(mutex);
  std::shared_ptr<OpenHapticsSession> session = current.lock();
  if (session == nullptr) {
    session = std::make_shared<OpenHapticsSession>(library);
    current = session;
  } else if (!library.empty() && library != session->chosen_) {
    throw DriverFailure(BODKIN_BUSY, "a device is open through " + session->hd.library.path() +
                                         ": close it before another library is used");
  }
  return session;
}

void OpenHapticsSession::paused(const std::function<void()>& call) {
  const std::lock_guard lock(mutex_);
  if (running_) hd.hdStopScheduler();
  running_ = false;
  try {
    call();
  } catch (...) {
    resume();
    throw;
  }
  resume();
}

// The error of a start is read at once, as in the vendor's samples. An error of a device, which may tick already, is
// kept for it.
void OpenHapticsSession::resume() {
  if (scheduled_ == 0) return;
  hd.hdStartScheduler();
  const OpenHapticsLibrary::ErrorRecord record = hd.hdGetError();
  if (is_of_scheduler(record.code)) {
    throw DriverFailure(BODKIN_VENDOR_ERROR, "the scheduler of OpenHaptics does not start (" + words(record.code) +
                                                 "): see whether the vendor's Touch_Diagnostic works");
  }
  running_ = true;
  if (record.code == openhaptics::success) return;
  if (record.device != openhaptics::invalid_handle) {
    pending_[record.device % most_devices].store(record.code);
  } else {
    for (std::atomic<unsigned>& pending : pending_) pending.store(record.code);
  }
}

unsigned long OpenHapticsSession::schedule(OpenHapticsLibrary::Callback callback, void* user) {
  ++scheduled_;
  return hd.hdScheduleAsynchronous(callback, user, openhaptics::default_priority);
}

void OpenHapticsSession::unschedule(unsigned long callback) {
  --scheduled_;
  hd.hdUnschedule(callback);
}

unsigned OpenHapticsSession::newest_error(unsigned device) noexcept {
  unsigned newest = openhaptics::success;
  for (int depth = 0; depth < deepest_stack; ++depth) {
    const OpenHapticsLibrary::ErrorRecord record = hd.hdGetError();
    if (record.code == openhaptics::success) break;
    const bool nobodys = record.device == openhaptics::invalid_handle;
    if (record.device == device || nobodys) {
      if (newest == openhaptics::success) newest = record.code;
    } else {
      pending_[record.device % most_devices].store(record.code);
    }
  }
  const unsigned earlier = pending_[device % most_devices].exchange(openhaptics::success);
  return newest == openhaptics::success ? earlier : newest;
}

std::string OpenHapticsSession::words(unsigned code) const {
  char number[16];
  std::snprintf(number, sizeof number, "0x%04x", code);
  const char* text = hd.hdGetErrorString(code);
  return std::string("error ") + number + (text == nullptr ? "" : ", '" + std::string(text) + "'");
}

}  // namespace bodkin::haptics
