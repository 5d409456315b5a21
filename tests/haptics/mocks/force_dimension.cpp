// A mock of libdrd.so with one sigma.7-like device. Every sent force advances the mechanism by one tick. The
// controller brakes until forces are enabled, and when its watchdog, its velocity guard or its cable trips.
#include <chrono>
#include <cmath>
#include <cstring>
#include <thread>

#include "tests/haptics/mocks/mechanism.h"

#define EXPORT extern "C" __attribute__((visibility("default")))

namespace {

using mock::board;
using mock::Trouble;

constexpr char the_id = 3;  // not the index, so that a driver that mixes them up is found
constexpr int falcon = 60;
constexpr double peak = 12.0;

mock::Mechanism mechanism(1.0, peak, 1e-5);
bool gripper_is_button = false;  // of the devices that have one
bool open_now = false, opened_by_drd = false, brakes = true, expert = false, calibrated_by_itself = false;
int off_cause = 0;
int moved = 0;  // forces that were sent while the hand moved it
int watchdog_steps = 0;
thread_local int last_error = 0;

int failed(int error) {
  last_error = error;
  return -1;
}

// Every call about the device must name it by the identifier that opening gave.
bool is_ours(char id) {
  if (open_now && id == the_id) return true;
  board().violation("a device was named that is not open");
  last_error = 15;
  return false;
}

void trip(int cause) {
  board().motors_on = false;
  off_cause = cause;
  brakes = true;
  for (auto& component : board().force) component = 0.0;
}

bool gone() {
  if (!board().troubled_by(Trouble::unplug)) return false;
  trip(5);
  last_error = 2;
  return true;
}

int send(double x, double y, double z, double a, double b, double c, char id) {
  board().wait_while(Trouble::freeze);
  if (board().troubled_by(Trouble::late)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  if (!is_ours(id) || gone()) return -1;
  // A Falcon finds its position while it is moved and receives forces.
  if (board().type == falcon && board().habit == mock::Hand::wander && ++moved > 50) calibrated_by_itself = true;
  if (board().troubled_by(Trouble::unknown_code)) return failed(4711);
  if (board().troubled_by(Trouble::emergency_stop)) trip(1);
  if (board().troubled_by(Trouble::too_fast)) trip(2);
  if (board().troubled_by(Trouble::hand_off)) trip(6);
  const bool on = board().motors_on.load() && !brakes;
  mechanism.step(board(), {on ? x : 0, on ? y : 0, on ? z : 0}, {on ? a : 0, on ? b : 0, on ? c : 0});
  return std::abs(x) > peak || std::abs(y) > peak || std::abs(z) > peak ? 2 : 0;
}

int open_device(char index, bool by_drd) {
  board().wait_while(Trouble::open_blocks);
  if (index != 0) return failed(15);
  if (open_now || board().troubled_by(Trouble::busy)) return failed(20);
  open_now = brakes = true;
  gripper_is_button = false;
  opened_by_drd = by_drd;
  off_cause = 0;
  watchdog_steps = 0;
  board().opened();
  return the_id;
}

int close_device(char id, bool by_drd) {
  if (!is_ours(id)) return -1;
  if (by_drd != opened_by_drd) board().violation("closed by another part of the SDK than opened it");
  if (board().motors_on) board().violation("closed while forces were enabled");
  board().motors_on = false;
  open_now = calibrated_by_itself = false;
  moved = 0;
  --board().open_devices;
  return 0;
}

// DRD knows only what it has opened.
[[maybe_unused]] bool is_drds(char id) {
  if (is_ours(id) && opened_by_drd) return true;
  board().violation("DRD was asked for a device that it has not opened");
  return false;
}

}  // namespace

EXPORT void dhdGetSDKVersion(int* major, int* minor, int* release, int* revision) {
  *major = 3;
  *minor = board().troubled_by(Trouble::wrong_version) ? 8 : 17;
  *release = *revision = 0;
}
EXPORT int dhdGetDeviceCount() {
  return board().troubled_by(Trouble::no_device) ? 0 : 1;
}
EXPORT int dhdOpenID(char index) {
  return open_device(index, false);
}
EXPORT int dhdClose(char id) {
  return close_device(id, false);
}
EXPORT int dhdGetSystemType(char id) {
  if (!is_ours(id)) return -1;
  return board().type == 0 ? 104 : board().type.load();
}
EXPORT const char* dhdGetSystemName(char id) {
  switch (dhdGetSystemType(id)) {
    case 33:
      return "omega.3";
    case 34:
      return "omega.6";
    case 35:
      return "omega.7";
    case 60:
      return "Falcon";
    case 63:
      return "delta.3";
    case 64:
      return "delta.6";
    case 104:
      return "sigma.7";
    case 106:
      return "sigma.6+";
    case 108:
      return "lambda.7";
    default:
      return nullptr;
  }
}
EXPORT int dhdGetSerialNumber(unsigned short* serial, char id) {
  *serial = 10204;
  return is_ours(id) ? 0 : -1;
}
EXPORT bool dhdHasWrist(char id) {
  return is_ours(id);
}
EXPORT bool dhdHasActiveWrist(char id) {
  return is_ours(id);
}
EXPORT int dhdGetStatus(int* status, char id) {
  if (!is_ours(id)) return -1;
  std::memset(status, 0, 17 * sizeof(int));
  status[0] = status[2] = status[8] = status[12] = 1;
  status[1] = board().troubled_by(Trouble::unplug) ? 0 : 1;
  status[3] = board().troubled_by(Trouble::uncalibrated) && !calibrated_by_itself ? 1 : 0;
  status[5] = board().motors_on ? 1 : 0;
  status[6] = brakes ? 1 : 0;
  status[14] = off_cause;
  return 0;
}
EXPORT int dhdGetPositionAndOrientationFrame(double* x, double* y, double* z, double rotation[3][3], char id) {
  if (!is_ours(id) || gone()) return -1;
  const auto& at = mechanism.position();
  *x = at[0];
  *y = at[1];
  *z = at[2];
  for (std::size_t i = 0; i < 9; ++i) rotation[i / 3][i % 3] = board().turn[i];
  return 1;  // the time guard: fresh enough
}
EXPORT int dhdGetLinearVelocity(double* x, double* y, double* z, char id) {
  if (!is_ours(id) || gone()) return -1;
  const auto& velocity = mechanism.velocity();
  *x = velocity[0];
  *y = velocity[1];
  *z = velocity[2];
  return 0;
}
EXPORT int dhdSetForceAndTorque(double x, double y, double z, double a, double b, double c, char id) {
  return send(x, y, z, a, b, c, id);
}
EXPORT int dhdSetForce(double x, double y, double z, char id) {
  return send(x, y, z, 0.0, 0.0, 0.0, id);
}
EXPORT bool dhdHasActiveGripper(char id) {
  const int type = dhdGetSystemType(id);
  return type == 35 || type == 37 || (type >= 104 && type <= 109);
}
EXPORT int dhdEmulateButton(unsigned char on, char id) {
  if (!is_ours(id)) return -1;
  if (!dhdHasActiveGripper(id)) return failed(6);
  gripper_is_button = on != 0;
  return 0;
}
EXPORT unsigned dhdGetButtonMask(char id) {
  if (!is_ours(id)) return 0;
  return dhdHasActiveGripper(id) && !gripper_is_button ? 0 : board().buttons.load();
}
#ifndef BROKEN_SDK
EXPORT int dhdEnableForce(unsigned char on, char id) {
  board().wait_while(Trouble::start_blocks);
  if (!is_ours(id) || gone()) return -1;
  if (on != 0 && watchdog_steps == 0) board().violation("forces enabled without a watchdog");
  if (on != 0 && board().troubled_by(Trouble::uncalibrated)) board().violation("forces enabled without calibration");
  board().motors_on = on != 0;
  brakes = on == 0;
  off_cause = on == 0 ? 4 : 0;
  return 0;
}
#endif
EXPORT int dhdSetBrakes(int on, char id) {
  if (!is_ours(id)) return -1;
  brakes = on != 0;
  return 0;
}
EXPORT int dhdStop(char id) {
  static int calls = 0;
  board().wait_while(Trouble::stop_blocks);
  if (!is_ours(id)) return -1;
  if (++calls % 2 == 1) return failed(7);  // a timeout now and then: drivers must try again
  board().motors_on = false;
  brakes = true;
  off_cause = 4;
  mechanism.step(board(), {0, 0, 0}, {0, 0, 0});
  return 0;
}
EXPORT int dhdErrorGetLast() {
  return last_error;
}
EXPORT const char* dhdErrorGetLastStr() {
  return "words of the vendor";
}
#ifndef OLD_SDK
EXPORT int dhdSetMaxForce(double limit, char id) {
  return is_ours(id) && limit > 0.0 ? 0 : -1;
}
#endif
EXPORT int dhdSetGravityCompensation(int, char id) {
  return is_ours(id) ? 0 : -1;
}
EXPORT int dhdEnableExpertMode() {
  expert = true;
  return 0;
}
EXPORT int dhdDisableExpertMode() {
  expert = false;
  return 0;
}
EXPORT int dhdSetWatchdog(unsigned char steps, char id) {
  if (!is_ours(id)) return -1;
  if (!expert) return failed(9);
  if (steps == 0) board().violation("the watchdog was switched off");
  watchdog_steps = steps;
  return 0;
}
#ifndef OLD_SDK
EXPORT int drdOpenID(char index) {
  return open_device(index, true);
}
EXPORT int drdClose(char id) {
  return close_device(id, true);
}
EXPORT bool drdIsInitialized(char id) {
  return is_drds(id) && (calibrated_by_itself || !board().troubled_by(Trouble::uncalibrated));
}
EXPORT int drdAutoInit(char id) {
  if (board().type == falcon) board().violation("a Falcon was told to calibrate itself");
  calibrated_by_itself = is_drds(id);
  return calibrated_by_itself ? 0 : -1;
}
EXPORT int drdStop(bool, char id) {
  return is_drds(id) ? 0 : -1;
}
#endif
