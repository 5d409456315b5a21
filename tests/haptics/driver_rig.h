#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/haptics/stand_ins/board.h"

#include "haptics/device_port.h"

namespace bodkin {

// A built-in driver and the stand-in that it drives, with what its vendor's frame and units make of known poses and
// forces (design table of axes: each row is written out, not computed).
struct DriverSubject {
  std::string name;
  const bodkin_driver* driver;
  std::string library, library_without_symbol, missing_symbol;
  std::string settings;  // besides library=

  Vec3 origin_vendor = Vec3::Zero();  // the operator's origin
  Vec3 pushed_vendor, pushed;         // vendor's unit; mm
  Mat3 left_vendor;  // from the identity, in which the tool points away from the operator, a quarter to the left
  Vec3 force_vendor, force;    // N
  Vec3 torque_vendor, torque;  // vendor's unit; N mm
  std::map<stand_in::Trouble, DeviceFault> at_open, in_loop;

  std::string words() const { return "library=" + library + " " + settings; }
  stand_in::Board& board() const;
};

const std::vector<DriverSubject>& driver_subjects();

// Asks again and again until `condition` holds; false after half a minute.
bool comes_true(const std::function<bool()>& condition);

// An open device with a loop, whoever owns that: its states are kept, its command is `push`.
class DriverRig {
 public:
  explicit DriverRig(const DriverSubject& subject, std::chrono::milliseconds patience = usual_patience);
  ~DriverRig();

  DevicePort& port() { return *port_; }
  void start();
  // Ends the loop. Throws what the port's stop() throws.
  void stop();
  void close();

  void push(const Wrench& wrench) { hand_.push(wrench); }
  DeviceState last() const { return hand_.last(); }
  // The fastest velocity so far along each axis.
  Vec3 fastest() const { return hand_.fastest(); }
  // Waits for so many ticks more of the vendor's; false when they do not come.
  bool ticks(int count);
  // Waits for a fault.
  bool fault(DeviceFault fault);

 private:
  class Hand : public DeviceTick {
   public:
    Wrench tick(const DeviceState& state, double dt) noexcept override;
    void push(const Wrench& wrench);
    DeviceState last() const;
    Vec3 fastest() const;

   private:
    mutable std::mutex mutex_;
    Wrench wrench_;
    DeviceState last_;
    Vec3 fastest_ = Vec3::Zero();
  };

  const DriverSubject& subject_;
  Hand hand_;
  std::unique_ptr<DevicePort> port_;
  std::atomic<bool> ended_{false};
  std::thread servo_;
};

}  // namespace bodkin
