#pragma once

#include <string>

#include "haptics/driver_library.h"

namespace bodkin::haptics {

// The functions of Force Dimension's SDK (DHD and DRD) that the driver uses, under the vendor's names. Lengths m,
// angles rad, forces N, torques N m; X towards the operator, Y right, Z up. A negative result is a failure; 1 (time
// guard) and 2 (a motor is saturated) are successes. The last argument is the identifier that opening gave.
struct ForceDimensionLibrary {
  // `chosen`: a path from the user, or empty. Throws LibraryError.
  explicit ForceDimensionLibrary(const std::string& chosen);

  DriverLibrary library;

  void (*dhdGetSDKVersion)(int* major, int* minor, int* release, int* revision);
  int (*dhdGetDeviceCount)();
  int (*dhdOpenID)(char index);
  int (*dhdClose)(char);
  int (*dhdGetSystemType)(char);
  const char* (*dhdGetSystemName)(char);
  int (*dhdGetSerialNumber)(unsigned short* serial, char);
  bool (*dhdHasWrist)(char);
  bool (*dhdHasActiveWrist)(char);
  int (*dhdGetStatus)(int status[17], char);
  int (*dhdGetPositionAndOrientationFrame)(double* x, double* y, double* z, double rotation[3][3], char);
  int (*dhdGetLinearVelocity)(double* x, double* y, double* z, char);
  int (*dhdSetForce)(double x, double y, double z, char);
  int (*dhdSetForceAndTorque)(double x, double y, double z, double rx, double ry, double rz, char);
  unsigned (*dhdGetButtonMask)(char);
  int (*dhdEnableForce)(unsigned char on, char);
  int (*dhdSetBrakes)(int on, char);
  int (*dhdStop)(char);
  int (*dhdErrorGetLast)();
  const char* (*dhdErrorGetLastStr)();

  bool has_drd() const noexcept { return drdOpenID != nullptr && drdClose != nullptr; }

  // Null in SDKs that lack them.
  int (*dhdSetMaxForce)(double limit, char);
  int (*dhdSetGravityCompensation)(int on, char);
  bool (*dhdHasActiveGripper)(char);
  int (*dhdEmulateButton)(unsigned char on, char);  // a closed gripper counts as a button
  int (*dhdEnableExpertMode)();
  int (*dhdDisableExpertMode)();
  int (*dhdSetWatchdog)(unsigned char steps_of_125_us, char);
  int (*drdOpenID)(char index);  // the functions of DRD are for devices that it opened
  int (*drdClose)(char);
  bool (*drdIsInitialized)(char);
  int (*drdAutoInit)(char);
  int (*drdStop)(bool keep_force, char);
};

namespace force_dimension {

// Indices of dhdGetStatus.
enum Status { connected = 1, needs_reset = 3, force_on = 5, force_off_cause = 14 };

enum ForceOff { no_cause, button, velocity, watchdog, software, usb, dead_man };

enum Error { error_com = 2, error_busy = 3, error_no_driver = 4, error_no_device = 5, error_device_in_use = 20 };

}  // namespace force_dimension

}  // namespace bodkin::haptics
