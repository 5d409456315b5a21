#pragma once

#include <optional>
#include <vector>

#include "anatomy/volume.h"
#include "core/geometry.h"

namespace bodkin::imaging {

// The pose of a probe at one time of a sweep.
struct SweepPose {
  double time = 0.0;  // s, never less than the previous one
  Pose pose = Pose::Identity();
};

// From an angle to another, rad.
struct SweepAngle {
  double from = 0.0, to = 0.0;
};

// A motion from a first pose. All parts run at the same time, at constant rates.
struct SweepMotion {
  std::optional<Vec3> to;  // LPS mm, end of the face's motion
  SweepAngle tilt;         // about the marked axis: the slice fans
  SweepAngle rock;         // about the axis across the slice
  SweepAngle rotate;       // about the depth axis
  bool on_skin = false;    // the face follows the skin during the motion, at its initial depth
  int frames = 60;         // 1 to 100 000
  double rate = 25.0;      // frames a second; > 0
};

// The poses of a motion. `tissues` locate the skin. Throws InputError when a number is out of range.
std::vector<SweepPose> sweep_of(const Pose& first, const SweepMotion& motion, const anatomy::TissueVolume& tissues);

}  // namespace bodkin::imaging
