#pragma once

#include <span>

#include "core/geometry.h"
#include "haptics/device.h"
#include "haptics/device_calibration.h"
#include "haptics/servo_tick.h"

namespace bodkin::haptics {

// Calibration of a device from its readings. All throw InputError, in one sentence that says what to do differently,
// when the readings do not determine what is asked for. Poses and positions are those of DeviceState::hand.

// The box that was reached. Every side must be 20 mm at least.
DeviceCalibration::Reach reach_of(std::span<const Pose> readings);

// The tool's tip stood in one place while the tool was swivelled about it: p + H o = c in every reading, solved for o
// and c by least squares. The tool must have been turned by 20 degrees at least about two axes.
struct TipFit {
  Vec3 offset = Vec3::Zero();  // mm, o
  Vec3 place = Vec3::Zero();   // mm, c
  double residual = 0.0;       // mm, root mean square distance of p + H o from c; 2 at most
};
TipFit tip_of(std::span<const Pose> readings);

// The tip stood on one point: the mean of p + H o over the readings, however the tool was turned meanwhile. Throws
// InputError when it moved by more than 1 mm root mean square.
struct TouchFit {
  Vec3 place = Vec3::Zero();  // mm, in the device's frame
  double spread = 0.0;        // mm, root mean square distance of the readings from it
};
TouchFit touch_of(std::span<const Pose> readings, const Vec3& tip_offset);

// The tool was held so that it points straight down: the mean of the downward direction in the tool's axes. It must
// have been held still within 5 degrees.
Vec3 tool_axis_of(std::span<const Pose> readings);

// The hand went straight away from the operator: the turn about +Z, rad, from where the device says it went to away.
// The stroke must be at least 40 mm long, and four times as long as it is wide.
double mounting_of(std::span<const Pose> readings);

// A weak spring carried the handle alone and came to rest, first from below, then from above. The weight is the mean
// of both forces (N, upwards), half their difference is friction. Both must be forces that a handle can weigh.
struct WeightFit {
  double weight = 0.0;    // N
  double friction = 0.0;  // N
};
WeightFit weight_of(double from_below, double from_above);

// The same spring drew the handle along a level axis and came to rest, first from one side, then from the other; it
// went `way` mm. N of friction; 0 where the handle did not follow by a fifth of what was asked.
double level_friction(double from_one_side, double from_the_other, double way, double asked) noexcept;

// The box of the device becomes what was reached, its delay what was measured.
void apply(const DeviceCalibration& calibration, DeviceAbilities& abilities);
// The middle of the workspace, the direction in which the device stands, tip, needle and weight. `settings.workspace`
// already lies in the patient as for a device that stands straight.
void apply(const DeviceCalibration& calibration, ServoSettings& settings);

}  // namespace bodkin::haptics
