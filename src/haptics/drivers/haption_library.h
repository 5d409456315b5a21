#pragma once

#include <string>

#include "haptics/driver_library.h"

namespace bodkin::haptics {

// The functions of Haption's Virtuose API 4 that the driver uses, under the vendor's names. m, rad, N, N m; X towards
// the operator, Y right, Z up; a pose is x y z and a quaternion x y z w, a force Fx Fy Fz Tx Ty Tz. 0 is success.
struct HaptionLibrary {
  using Context = void*;
  using Periodic = void (*)(Context, void* user);

  // `chosen`: a path from the user, or empty. Throws LibraryError.
  explicit HaptionLibrary(const std::string& chosen);

  DriverLibrary library;

  int (*virtAPIVersion)(int* major, int* minor);
  Context (*virtOpen)(const char* address);  // null: see virtGetErrorCode(null)
  int (*virtClose)(Context);
  int (*virtGetControlerVersion)(Context, int* major, int* minor);  // may be null; the vendor's spelling
  int (*virtGetDeviceID)(Context, int* type, int* serial);
  int (*virtSetIndexingMode)(Context, int mode);
  int (*virtSetForceFactor)(Context, float);
  int (*virtSetSpeedFactor)(Context, float);
  int (*virtSetTimeStep)(Context, float seconds);
  int (*virtSetBaseFrame)(Context, float pose[7]);
  int (*virtSetObservationFrame)(Context, float pose[7]);
  int (*virtSetCommandType)(Context, int type);
  int (*virtSaturateTorque)(Context, float force, float torque);
  int (*virtEnableForceFeedback)(Context, int on);  // may be null
  int (*virtSetPowerOn)(Context, int on);
  int (*virtGetPowerOn)(Context, int* on);
  int (*virtGetPosition)(Context, float pose[7]);
  int (*virtGetSpeed)(Context, float speed[6]);
  int (*virtSetForce)(Context, float force[6]);
  int (*virtGetDeadMan)(Context, int* held);
  int (*virtGetEmergencyStop)(Context, int* chain_closed);
  int (*virtGetAlarm)(Context, unsigned* bits);
  int (*virtGetButton)(Context, int number, int* pressed);
  int (*virtSetPeriodicFunction)(Context, Periodic, float* period, void* user);
  int (*virtStartLoop)(Context);
  int (*virtStopLoop)(Context);
  int (*virtGetErrorCode)(Context);
  const char* (*virtGetErrorMessage)(int code);
};

namespace haption {

constexpr int indexing_none = 2;      // we do the clutching
constexpr int command_impedance = 3;  // we send forces
constexpr unsigned alarm_overheated = 0x4000, alarm_position = 0x40000;
enum Error {
  error_communication = 2,
  error_timeout = 6,
  error_discontinuity = 12,
  error_version = 16,
  error_incompatible = 20,
  error_already_called = 22
};

}  // namespace haption

}  // namespace bodkin::haptics
