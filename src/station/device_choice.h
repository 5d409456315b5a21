#pragma once

#include <string>

#include "anatomy/case.h"
#include "haptics/bodkin_driver.h"
#include "haptics/device.h"
#include "haptics/device_calibration.h"

namespace bodkin::station {

// Which device to open, and how.
struct DeviceChoice {
  const bodkin_driver* driver = nullptr;  // must not be null when a device is opened
  std::string identity;                   // "": the first one that the driver finds
  std::string settings;                   // "KEY=VALUE ..." for the driver

  bool is_simulated() const;
  bool is_recorded() const;
  // Whether it is the window's mouse, a hand simulated by the window: no person's hand feels its force.
  bool is_mouse() const;
  // Whether it is a tool of a tracker (link/tracking_driver.h) or before a camera, whose poses may already be in the
  // patient.
  bool is_tracked() const;
  // Whether it is a real needle or probe over a mannequin, before a camera (tracking/tool_driver.h).
  bool is_seen() const;
};

// The settings for a driver that performs along `path`: a simulated hand aims at it and moves to its end, unless the
// choice's own settings, which come last, say otherwise; a tracked tool gets the patient's placement
// (settings_about).
std::string settings_along(const anatomy::NeedlePath& path, const DeviceChoice& device);

// The choice's settings, preceded, for a tool of a tracker, by the place in the patient (LPS mm) of the middle of the
// workspace, so that a pose in the patient is the needle's, and, for a tool before a camera, by the path, which
// determines the placement of the patient in a mannequin that was not registered.
std::string settings_about(const Vec3& middle, const anatomy::NeedlePath& path, const DeviceChoice& device);

// Fills in values that the device does not report from the model's entry in share/bodkin/devices.csv.
void complete_from_table(haptics::DeviceAbilities& abilities);

// The measurements of 'bodkin devices calibrate' for the device; empty if it was never calibrated.
haptics::DeviceCalibration calibration_of(const DeviceChoice& choice, const haptics::DeviceAbilities& device);

// Throws InputError, with the remedy, when the device cannot run at the case's `rate` (Hz): each tick of the case is
// one tick of the device.
void require_same_rate(const DeviceChoice& choice, const haptics::DeviceAbilities& device, double rate);

}  // namespace bodkin::station
