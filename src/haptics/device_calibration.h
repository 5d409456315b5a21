#pragma once

#include <optional>
#include <string>

#include "core/geometry.h"

namespace bodkin::haptics {

// The measurements of one device in its place, found and stored by `bodkin devices calibrate`. Missing ones are
// empty. Frames as in haptics/device.h.
struct DeviceCalibration {
  std::string driver;       // "force_dimension"
  std::string model;        // "omega.3"
  std::string serial;       // empty if the device has none
  std::string measured_at;  // ISO 8601, UTC

  // The box that the hand reached, mm, as the device reports positions.
  struct Reach {
    Vec3 low = Vec3::Zero();
    Vec3 high = Vec3::Zero();
  };
  std::optional<Reach> reach;
  // rad about +Z from the device's direction "away from the operator" to the true one.
  std::optional<double> mounting;
  // mm from the point that the device reports to the tool's tip, in the tool's axes; with the mean distance of the
  // readings from the fixed position of the tip.
  std::optional<Vec3> tip_offset;
  double tip_residual = 0.0;  // mm
  // Unit, hub to tip, in the tool's axes.
  std::optional<Vec3> tool_axis;
  // N of the handle that the device's own controller does not carry, and N of dry friction along each axis of the
  // operator's frame, found by the same measurement; 0 = not found.
  std::optional<double> weight;
  Vec3 friction = Vec3::Zero();
  // s from sending a force until the handle moved, excluding our own loop.
  std::optional<double> delay;

  bool empty() const { return !reach && !mounting && !tip_offset && !tool_axis && !weight && !delay; }
};

}  // namespace bodkin::haptics
