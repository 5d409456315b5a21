#pragma once

#include <cstdint>
#include <string>

#include "haptics/driver_library.h"

namespace bodkin::haptics {

// The functions of OpenHaptics' HD interface that the driver uses, under the vendor's names. mm, N, N mm (mN m), rad.
struct OpenHapticsLibrary {
  // An entry of the error stack that all threads and devices share.
  struct ErrorRecord {
    unsigned code;
    int internal;
    unsigned device;
  };
  using Callback = unsigned (*)(void* user);  // 1: call again at the next tick

  // `chosen`: a path from the user, or empty. Throws LibraryError.
  explicit OpenHapticsLibrary(const std::string& chosen);

  DriverLibrary library;

  unsigned (*hdInitDevice)(const char* name);
  void (*hdDisableDevice)(unsigned device);
  void (*hdMakeCurrentDevice)(unsigned device);
  void (*hdBeginFrame)(unsigned device);
  void (*hdEndFrame)(unsigned device);
  ErrorRecord (*hdGetError)();
  const char* (*hdGetErrorString)(unsigned code);
  void (*hdEnable)(unsigned capability);
  void (*hdDisable)(unsigned capability);
  void (*hdGetIntegerv)(unsigned parameter, int* values);
  void (*hdGetDoublev)(unsigned parameter, double* values);
  const char* (*hdGetString)(unsigned parameter);
  void (*hdSetDoublev)(unsigned parameter, const double* values);
  unsigned (*hdCheckCalibration)();
  void (*hdUpdateCalibration)(unsigned style);
  void (*hdStartScheduler)();
  void (*hdStopScheduler)();
  unsigned long (*hdScheduleAsynchronous)(Callback callback, void* user, unsigned short priority);
  void (*hdUnschedule)(unsigned long callback);

  // Null in old libraries.
  void (*hdGetBooleanv)(unsigned parameter, unsigned char* values);
};

namespace openhaptics {

// Parameters.
constexpr unsigned current_buttons = 0x2000, current_safety_switch = 0x2001, current_velocity = 0x2051,
                   current_transform = 0x2052, version = 0x2500, model_type = 0x2501, serial_number = 0x2504,
                   usable_workspace = 0x2551, input_freedoms = 0x2553, output_freedoms = 0x2554,
                   calibration_style = 0x2555, update_rate = 0x2600, nominal_max_stiffness = 0x2602,
                   nominal_max_force = 0x2603, nominal_max_continuous_force = 0x2604, motor_temperature = 0x2605,
                   nominal_max_damping = 0x2609, nominal_max_torque = 0x2622, current_force = 0x2700,
                   current_torque = 0x2701;
// Capabilities.
constexpr unsigned force_output = 0x4000;
// States of calibration.
constexpr unsigned calibration_ok = 0x5000, calibration_needs_update = 0x5001, calibration_needs_hand = 0x5002;
// Styles of calibration: bits of those supported by a device, one of them the requested one.
constexpr unsigned encoder_reset = 1, automatic = 2, inkwell = 4;
// Errors.
constexpr unsigned success = 0x0000, warm_motors = 0x0200, exceeded_force = 0x0201, exceeded_impulse = 0x0202,
                   exceeded_velocity = 0x0203, force_error = 0x0204, device_fault = 0x0300,
                   already_initiated = 0x0301, comm_error = 0x0302, comm_config_error = 0x0303,
                   first_scheduler_error = 0x0500, last_scheduler_error = 0x05FF;

constexpr unsigned invalid_handle = 0xFFFFFFFF;
constexpr unsigned short default_priority = 32767;

}  // namespace openhaptics

}  // namespace bodkin::haptics
