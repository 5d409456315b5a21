#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "haptics/device_port.h"

namespace bodkin {

using namespace bodkin::haptics;

// Polls until `condition` holds; false after half a minute.
bool comes_true(const std::function<bool()>& condition);

// An open device with a loop of any owner: its states are recorded, its command is `push`.
class DeviceLoop {
 public:
  explicit DeviceLoop(DevicePort port);
  ~DeviceLoop();

  DevicePort& port() { return *port_; }
  void start();
  // Ends the loop. Throws what the port's stop() throws.
  void stop();
  // Closes the device. `hangs`: our thread is inside a vendor's call and is joined at the end of the life instead.
  void close(bool hangs = false);

  void push(const Wrench& wrench) { hand_.push(wrench); }
  DeviceState last() const { return hand_.last(); }
  // The fastest velocity so far along each axis.
  Vec3 fastest() const { return hand_.fastest(); }
  // Rounds so far whose pose was not finite or whose turn was no rotation.
  int unsound() const { return hand_.unsound(); }
  // Waits for so many more rounds; false if they do not arrive.
  bool rounds(int count);

 private:
  class Hand : public DeviceTick {
   public:
    Wrench tick(const DeviceState& state, double dt) noexcept override;
    void push(const Wrench& wrench);
    DeviceState last() const;
    Vec3 fastest() const;
    int unsound() const;

   private:
    mutable std::mutex mutex_;
    Wrench wrench_;
    DeviceState last_;
    Vec3 fastest_ = Vec3::Zero();
    int unsound_ = 0;
  };

  Hand hand_;
  std::unique_ptr<DevicePort> port_;
  std::atomic<bool> ended_{false};
  std::thread servo_;
};

}  // namespace bodkin
