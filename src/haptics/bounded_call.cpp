#include "haptics/bounded_call.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace bodkin::haptics {

bool returns_within(std::chrono::milliseconds limit, std::function<void()> call, std::function<void()> late) {
  struct Meeting {
    std::mutex mutex;
    std::condition_variable changed;
    bool returned = false;
    bool abandoned = false;
  };
  const auto meeting = std::make_shared<Meeting>();
  std::thread caller([meeting, call = std::move(call), late = std::move(late)]() mutable {
    call();
    call = nullptr;  // destroys its resources before the caller reads the result
    bool abandoned = false;
    {
      const std::lock_guard lock(meeting->mutex);
      meeting->returned = true;
      abandoned = meeting->abandoned;
      meeting->changed.notify_all();
    }
    if (abandoned && late) late();
  });

  std::unique_lock lock(meeting->mutex);
  if (meeting->changed.wait_for(lock, limit, [&] { return meeting->returned; })) {
    lock.unlock();
    caller.join();  // which has no work left
    return true;
  }
  meeting->abandoned = true;
  caller.detach();
  return false;
}

}  // namespace bodkin::haptics
