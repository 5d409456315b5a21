#pragma once

#include <string>

#include "anatomy/case.h"
#include "haptics/bodkin_driver.h"
#include "haptics/device.h"
#include "haptics/device_calibration.h"

namespace bodkin::station {

// Which device to open, and how.
struct DeviceChoice {
  const bodkin_driver* driver = nullptr;  // must not be null where a device is opened
  std::string identity;                   // "": the first one that the driver finds
  std::string settings;                   // "KEY=VALUE ..." for the driver

  bool is_simulated() const;
  bool is_recorded() const;
  // The window's mouse, a hand that the window plays: no person's hand feels its force.
  bool is_mouse() const;
  // A tool of a tracker (link/tracking_driver.h) or before a camera, whose poses can be in the patient already.
  bool is_tracked() const;
  // A real needle or probe over a mannequin, before a camera (tracking/tool_driver.h).
  bool is_seen() const;
};

// The settings for a driver that performs along `path`: a simulated hand aims at it and goes to its end, unless the
// choice's own settings, which come last, say otherwise; a tracked tool is told of the patient (settings_about).
std::string settings_along(const anatomy::NeedlePath& path, const DeviceChoice& device);

// The choice's settings; before them, for a tool of a tracker, where in the patient (LPS mm) the middle of the
// workspace lies, so that a pose in the patient is the needle's, and for one before a camera the path, which says how
// the patient lies in a mannequin that was not registered.
std::string settings_about(const Vec3& middle, const anatomy::NeedlePath& path, const DeviceChoice& device);

// Completes what the device does not report with what share/bodkin/devices.csv knows of the model.
void complete_from_table(haptics::DeviceAbilities& abilities);

// What 'bodkin devices calibrate' measured of the device; empty if it was never calibrated.
haptics::DeviceCalibration calibration_of(const DeviceChoice& choice, const haptics::DeviceAbilities& device);

// Throws InputError, with the remedy, when the device cannot run at the case's `rate` (Hz): each tick of the case is
// one tick of the device.
void require_same_rate(const DeviceChoice& choice, const haptics::DeviceAbilities& device, double rate);

}  // namespace bodkin::station
