#pragma once

#include <span>

#include "core/geometry.h"
#include "haptics/device.h"
#include "haptics/device_calibration.h"
#include "haptics/servo_tick.h"

namespace bodkin::haptics {

// Calibration of a device from its readings. All functions throw InputError, in one sentence that says what to do
// differently, when the readings do not determine the result. Poses and positions are those of DeviceState::hand.

// The box that the readings reached. Every side must be at least 20 mm.
DeviceCalibration::Reach reach_of(std::span<const Pose> readings);

// The tool's tip stayed in one place while the tool was swivelled about it: p + H o = c in every reading, solved for
// o and c by least squares. The tool must have been turned by at least 20 degrees about two axes.
struct TipFit {
  Vec3 offset = Vec3::Zero();  // mm, o
  Vec3 place = Vec3::Zero();   // mm, c
  double residual = 0.0;       // mm, root mean square distance of p + H o from c; at most 2
};
TipFit tip_of(std::span<const Pose> readings);

// The tip stayed on one point: the mean of p + H o over the readings, whatever the tool's orientation. Throws
// InputError when it moved by more than 1 mm root mean square.
struct TouchFit {
  Vec3 place = Vec3::Zero();  // mm, in the device's frame
  double spread = 0.0;        // mm, root mean square distance of the readings from it
};
TouchFit touch_of(std::span<const Pose> readings, const Vec3& tip_offset);

// The tool was held pointing straight down: the mean of the downward direction in the tool's axes. It must have been
// held still within 5 degrees.
Vec3 tool_axis_of(std::span<const Pose> readings);

// The hand moved straight away from the operator: the rotation about +Z, rad, from the reported direction of the
// motion to that direction. The stroke must be at least 40 mm long, and four times as long as wide.
double mounting_of(std::span<const Pose> readings);

// A weak spring carried the free handle until it came to rest, first from below, then from above. The weight is the
// mean of both forces (N, upwards), half their difference is friction. Both must be plausible forces of a handle.
struct WeightFit {
  double weight = 0.0;    // N
  double friction = 0.0;  // N
};
WeightFit weight_of(double from_below, double from_above);

// The same spring moved the handle along a level axis until it came to rest, first from one side, then from the
// other, over `way` mm. Returns N of friction; 0 if the handle moved by less than a fifth of the requested distance.
double level_friction(double from_one_side, double from_the_other, double way, double asked) noexcept;

// Sets the device's box to the measured reach, and its delay to the measured delay.
void apply(const DeviceCalibration& calibration, DeviceAbilities& abilities);
// Sets the middle of the workspace, the direction in which the device stands, tip, needle and weight.
// `settings.workspace` must already be placed in the patient, as for a device that stands straight.
void apply(const DeviceCalibration& calibration, ServoSettings& settings);

}  // namespace bodkin::haptics
