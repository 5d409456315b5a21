#pragma once

#include <deque>

#include "tracking/pose_step.h"

#include "core/geometry.h"

namespace bodkin::tracking {

// Averages the poses of a body at rest. It restarts as soon as a pose is more than 3 standard deviations from the
// present mean, so a moving body has no lag: it gets the measured pose.
class RestFilter {
 public:
  // `covariance`: of the pose, see RefinedPose. Returns the mean over the rest, of at most 15 poses.
  Pose add(const Pose& pose, const Matrix6& covariance);
  void clear() { poses_.clear(); }
  int count() const { return static_cast<int>(poses_.size()); }

 private:
  Pose mean() const;

  std::deque<Pose> poses_;
};

}  // namespace bodkin::tracking
