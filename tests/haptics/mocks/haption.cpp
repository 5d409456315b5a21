// A mock of libVirtuoseAPI.so with one 6D Desktop. Its loop is a thread that calls the periodic function as fast
// as it likes, one simulated millisecond each. It enforces the order of the settings, impedance mode before forces,
// power and force feedback before the loop and a closed emergency stop. The motors have power while the hand is on
// the handle and the user's switch is on, and it drops a connection that gets no force for two seconds of its own
// time.
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <thread>

#include "tests/haptics/mocks/mechanism.h"
#include <Eigen/Geometry>

#define EXPORT extern "C" __attribute__((visibility("default")))

namespace {

using mock::board;
using mock::Trouble;
using Context = void*;

constexpr double peak = 10.0;

struct Device {
  mock::Mechanism mechanism{1.0, peak};
  bool factor = false, step = false, base = false;
  int command = 0;
  bool limits = false;
  bool feedback = false;
  std::atomic<bool> power{false};  // asked for
  std::atomic<bool> looping{false};
  std::thread loop;
  void (*periodic)(Context, void*) = nullptr;
  float* period = nullptr;
  void* user = nullptr;
  double force[3] = {}, torque[3] = {};
  int silent = 0;  // ms without a force
  std::atomic<int> error{0};
};

Device the_device;
std::atomic<bool> open_now{false};
std::atomic<int> opening_error{0};

int failed(int error) {
  the_device.error = error;
  return -1;
}

// 0 if a call about the device is permitted.
int about(Context context) {
  if (context != &the_device || !open_now) {
    board().violation("a context that is not open");
    return failed(3);
  }
  if (board().troubled_by(Trouble::unplug)) {
    for (auto* triple : {&board().force, &board().torque}) {
      for (auto& component : *triple) component = 0.0;
    }
    return failed(2);
  }
  if (board().troubled_by(Trouble::unknown_code)) return failed(4711);
  return 0;
}

int rule(Context context, bool kept, int error, const char* what) {
  if (const int wrong = about(context)) return wrong;
  if (kept) return 0;
  board().violation(what);
  return failed(error);
}

bool motors_have_power() {
  const mock::Board& b = board();
  return the_device.power && !b.troubled_by(Trouble::emergency_stop) && !b.troubled_by(Trouble::no_power) &&
         !b.troubled_by(Trouble::hand_off);
}

void tick() {
  Device& d = the_device;
  if (board().troubled_by(Trouble::late)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ++d.silent;
  if (auto before = board().before_callback.load()) before();
  d.periodic(&d, d.user);
  if (auto after = board().after_callback.load()) after();
  if (d.silent > 2000) board().violation("no force for two seconds");
  const bool on = motors_have_power() && !board().troubled_by(Trouble::unplug);
  if (!on) std::memset(d.force, 0, sizeof d.force);
  if (!on) std::memset(d.torque, 0, sizeof d.torque);
  d.mechanism.step(board(), d.force, d.torque);
}

}  // namespace

EXPORT int virtAPIVersion(int* major, int* minor) {
  *major = board().troubled_by(Trouble::wrong_version) ? 3 : 4;
  *minor = 1;
  return 0;
}
EXPORT Context virtOpen(const char* address) {
  board().wait_while(Trouble::open_blocks);
  opening_error = 0;
  if (*address == '\0' || board().troubled_by(Trouble::no_device)) opening_error = 2;
  if (open_now || board().troubled_by(Trouble::busy)) opening_error = 22;
  if (board().troubled_by(Trouble::other_controller)) opening_error = 20;
  if (opening_error != 0) return nullptr;
  the_device.mechanism = mock::Mechanism{1.0, peak};
  the_device.feedback = false;
  the_device.factor = the_device.step = the_device.base = the_device.limits = false;
  the_device.command = 0;
  the_device.periodic = nullptr;
  the_device.error = 0;
  open_now = true;
  board().opened();
  return &the_device;
}
EXPORT int virtClose(Context context) {
  if (context != &the_device || !open_now) board().violation("closed what was not open");
  if (the_device.looping) board().violation("closed while the loop ran");
  if (the_device.power) board().violation("closed while the motors were on");
  open_now = false;
  --board().open_devices;
  return 0;
}
EXPORT int virtGetControlerVersion(Context context, int* major, int* minor) {
  *major = 3;
  *minor = 98;
  return about(context);
}
EXPORT int virtGetDeviceID(Context context, int* type, int* serial) {
  *type = board().type == 0 ? 4 : board().type.load();
  *serial = 77;
  return about(context);
}
EXPORT int virtSetIndexingMode(Context context, int mode) {
  return rule(context, mode == 2, 9, "the device clutches");
}
EXPORT int virtSetForceFactor(Context context, float factor) {
  the_device.factor = true;
  return rule(context, factor == 1.0F && the_device.command == 0, 19, "force factor after the command type");
}
EXPORT int virtSetSpeedFactor(Context context, float factor) {
  return rule(context, factor == 1.0F, 9, "the device scales motion");
}
EXPORT int virtSetTimeStep(Context context, float seconds) {
  the_device.step = true;
  return rule(context, seconds == 0.001F && the_device.command == 0, 19, "time step after the command type");
}
EXPORT int virtSetBaseFrame(Context context, float* pose) {
  the_device.base = true;
  return rule(context, pose[6] == 1.0F, 9, "a quaternion in another order");
}
EXPORT int virtSetObservationFrame(Context context, float* pose) {
  return rule(context, pose[6] == 1.0F, 9, "a quaternion in another order");
}
EXPORT int virtSetCommandType(Context context, int type) {
  the_device.command = type;
  return rule(context, type == 3 && the_device.factor && the_device.step, 19, "command type before its settings");
}
EXPORT int virtSaturateTorque(Context context, float force, float torque) {
  the_device.limits = true;
  return rule(context, force > 0.0F && force <= 15.0F && torque > 0.0F && torque <= 1.0F, 9, "limits in other units");
}
EXPORT int virtEnableForceFeedback(Context context, int on) {
  the_device.feedback = on != 0;
  return rule(context, !the_device.looping, 14, "force feedback enabled while the loop ran");
}
EXPORT int virtSetPowerOn(Context context, int on) {
  if (on != 0) board().wait_while(Trouble::start_blocks);
  if (on != 0 && the_device.looping) board().violation("power after the loop has begun");
  if (on != 0 && !the_device.feedback) board().violation("power without force feedback");
  if (on != 0 && !the_device.limits) board().violation("power without limits");
  if (on == 0 || about(context) == 0) {
    the_device.power = on != 0;
    board().motors_on = on != 0;
  }
  if (on == 0) the_device.mechanism.step(board(), {0, 0, 0}, {0, 0, 0});
  return about(context);
}
EXPORT int virtGetPowerOn(Context context, int* on) {
  *on = motors_have_power() ? 1 : 0;
  return about(context);
}
EXPORT int virtGetPosition(Context context, float* pose) {
  Eigen::Matrix3d rotation;
  for (int i = 0; i < 9; ++i) rotation(i / 3, i % 3) = board().turn[static_cast<std::size_t>(i)];
  const Eigen::Quaterniond turn(rotation);
  for (std::size_t i = 0; i < 3; ++i) pose[i] = static_cast<float>(the_device.mechanism.position()[i]);
  pose[3] = static_cast<float>(turn.x());
  pose[4] = static_cast<float>(turn.y());
  pose[5] = static_cast<float>(turn.z());
  pose[6] = static_cast<float>(turn.w());
  return about(context);
}
EXPORT int virtGetSpeed(Context context, float* speed) {
  for (std::size_t i = 0; i < 3; ++i) speed[i] = static_cast<float>(the_device.mechanism.velocity()[i]);
  speed[3] = speed[4] = speed[5] = 0.0F;
  return about(context);
}
EXPORT int virtSetForce(Context context, float* force) {
  for (int i = 0; i < 3; ++i) {
    the_device.force[i] = static_cast<double>(force[i]);
    the_device.torque[i] = static_cast<double>(force[i + 3]);
  }
  the_device.silent = 0;
  return rule(context, the_device.command == 3, 17, "a force without impedance mode");
}
EXPORT int virtGetDeadMan(Context context, int* held) {
  *held = board().troubled_by(Trouble::hand_off) ? 0 : 1;
  return about(context);
}
EXPORT int virtGetEmergencyStop(Context context, int* closed) {
  *closed = board().troubled_by(Trouble::emergency_stop) ? 0 : 1;
  return about(context);
}
EXPORT int virtGetAlarm(Context context, unsigned* bits) {
  *bits = board().troubled_by(Trouble::hot) ? 0x4000 : 0;
  return about(context);
}
EXPORT int virtGetButton(Context context, int number, int* pressed) {
  *pressed = (board().buttons & 1U << (number - 1)) != 0 ? 1 : 0;
  return about(context);
}
EXPORT int virtSetPeriodicFunction(Context context, void (*function)(Context, void*), float* period, void* user) {
  the_device.periodic = function;
  the_device.period = period;
  the_device.user = user;
  return rule(context, !the_device.looping, 14, "a periodic function while the loop runs");
}
EXPORT int virtStartLoop(Context context) {
  if (const int wrong = rule(context, the_device.periodic != nullptr && !the_device.looping, 14, "no loop to start"))
    return wrong;
  if (!the_device.power) board().violation("a loop without power");
  the_device.looping = true;
  the_device.loop = std::thread([] {
    while (the_device.looping) {
      if (!board().troubled_by(Trouble::freeze)) tick();
      const float period = *the_device.period;  // must stay valid
      std::this_thread::sleep_for(std::chrono::duration<float>(period / 20.0F));
    }
  });
  return 0;
}
#ifndef BROKEN_SDK
EXPORT int virtStopLoop(Context context) {
  board().wait_while(Trouble::stop_blocks);
  if (!the_device.looping.exchange(false)) board().violation("no loop to stop");
  if (the_device.loop.joinable()) the_device.loop.join();
  return about(context);
}
#endif
EXPORT int virtGetErrorCode(Context context) {
  return context == nullptr ? opening_error.load() : the_device.error.load();
}
EXPORT const char* virtGetErrorMessage(int) {
  return "words of the vendor";
}
