#pragma once

#include <deque>

#include "tracking/pose_step.h"

#include "core/geometry.h"

namespace bodkin::tracking {

// Averages the poses of a body that rests. It starts again as soon as a pose leaves 3 standard deviations of the mean
// so far, so a moving body has no lag: it gets the pose as measured.
class RestFilter {
 public:
  // `covariance`: of the pose, see RefinedPose. Returns the mean over the rest, of 15 poses at most.
  Pose add(const Pose& pose, const Matrix6& covariance);
  void clear() { poses_.clear(); }
  int count() const { return static_cast<int>(poses_.size()); }

 private:
  Pose mean() const;

  std::deque<Pose> poses_;
};

}  // namespace bodkin::tracking
