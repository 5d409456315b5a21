#pragma once

#include <vector>

#include "core/geometry.h"

namespace bodkin::tracking {

// A pose of a body while it is calibrated.
struct TimedPose {
  double time = 0.0;                         // s
  Pose camera_from_body = Pose::Identity();  // or from any frame that rests, such as the mannequin's
};

// Limits for poses used in a calibration.
struct PivotGate {
  double fastest = 90.0;     // degrees/s; faster ones have motion blur
  double outlier = 3.5;      // deviations, by the median of the absolute residuals
  double least_cone = 25.0;  // degrees between the two directions farthest apart
  int least_poses = 20;
};

// The point of a body about which the body was pivoted.
struct PivotCalibration {
  Vec3 tip = Vec3::Zero();    // body frame, mm
  Vec3 pivot = Vec3::Zero();  // its fixed place, camera frame, mm
  double rms = 0.0;           // of the distances of the tip from the pivot, mm
  double mean = 0.0;          // of the same distances, mm
  double deviation = 0.0;     // standard deviation of the tip's place, mm
  double cone = 0.0;          // degrees, see PivotGate
  int used = 0, too_fast = 0, outliers = 0;
};

// Least squares of R t + p = c over all poses (Yaniv 2015, "algebraic one step"). Throws InputError when there are
// too few poses or they turned too little.
PivotCalibration calibrate_pivot(const std::vector<TimedPose>& poses, const PivotGate& gate = {});

// The axis about which a body was spun, as a needle in a fixed tube.
struct SpinCalibration {
  Vec3 axis = Vec3::UnitZ();  // body frame, unit; of both directions the one nearer to +z
  double rms = 0.0;           // of the angles between the axis and its mean direction, degrees
  double mean = 0.0;          // of the same, degrees
  double turned = 0.0;        // degrees, largest between two poses
  int used = 0, too_fast = 0, outliers = 0;
};

// Throws InputError when there are too few poses or they turned by less than 60 degrees.
SpinCalibration calibrate_spin(const std::vector<TimedPose>& poses, const PivotGate& gate = {});

}  // namespace bodkin::tracking
