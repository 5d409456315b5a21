#pragma once

#include <atomic>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "tests/haptics/device_loop.h"
#include "tests/haptics/mocks/board.h"

#include "haptics/device_port.h"

namespace bodkin {

using namespace bodkin::haptics;

// A built-in driver and the mock that it drives, a library or a service, with what its vendor's frame and units
// make of known poses and forces (design table of axes: each row is written out, not computed).
struct DriverSubject {
  std::string name;
  const bodkin_driver* driver;
  std::string library;             // empty for a service
  std::string settings;            // besides library=
  mock::Board* service = nullptr;  // of a mock that runs in this program
  // Settings for missing or incompatible vendor software, and the required message.
  std::string absent, unfit;
  std::vector<std::string> absent_message, unfit_message;

  Vec3 origin_vendor = Vec3::Zero();  // the operator's origin
  Vec3 pushed_vendor, pushed;         // vendor's unit; mm
  Mat3 left_vendor;  // from the identity, in which the tool points away from the operator, a quarter to the left
  Vec3 force_vendor, force;    // N
  Vec3 torque_vendor, torque;  // vendor's unit; N mm
  std::map<mock::Trouble, DeviceFault> at_open, in_loop;
  bool reports_freeze = false;  // its rounds go on and say so; else the count of ticks stands still

  std::string words() const { return library.empty() ? settings : "library=" + library + " " + settings; }
  mock::Board& board() const;
};

// Found by GoogleTest through the type's namespace; otherwise a failure shows bytes.
void PrintTo(const DriverSubject& subject, std::ostream* to);

const std::vector<DriverSubject>& driver_subjects();
// Throws std::out_of_range.
const DriverSubject& driver_subject(const std::string& name);

// A tick that pushes with 1 N along the first axis.
struct Push : DeviceTick {
  Wrench tick(const DeviceState& state, double) noexcept override {
    fault = state.fault;
    ++ticks;
    return {Vec3(1, 0, 0), Vec3::Zero()};
  }
  std::atomic<DeviceFault> fault{DeviceFault::none};
  std::atomic<int> ticks{0};
};

// One of them with its loop, and the settings of its mock.
class DriverRig : public DeviceLoop {
 public:
  explicit DriverRig(const DriverSubject& subject, std::chrono::milliseconds patience = usual_patience);
  ~DriverRig();

  void close();
  // Waits for so many more ticks of the vendor's; false if they do not arrive.
  bool ticks(int count);
  // Waits for a fault.
  bool fault(DeviceFault fault);

 private:
  const DriverSubject& subject_;
};

}  // namespace bodkin
