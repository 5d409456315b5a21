#pragma once

#include <deque>
#include <string>
#include <vector>

#include "tracking/tracker.h"

namespace bodkin::tracking {

// Notices that the camera is no longer the one that was calibrated: its lens was turned, or its focus moved. Then
// picture and model disagree for every body at once, also at rest; motion or a bent body shows on one alone or
// passes.
class LensWatch {
 public:
  // The poses of the next picture.
  void add(const std::vector<TrackedPose>& poses);
  // One sentence while it is so; else empty.
  std::string warning() const;

 private:
  std::deque<bool> disagree_;  // of the last pictures in which bodies rested
  std::vector<TrackedPose> before_;
};

}  // namespace bodkin::tracking
