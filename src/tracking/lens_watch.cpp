#include "tracking/lens_watch.h"

#include <algorithm>

namespace bodkin::tracking {

namespace {

constexpr std::size_t pictures = 30;  // a second of a usual camera
constexpr double share = 0.8;         // of them in which no body fits
constexpr double rest = 2.0;          // mm from one picture to the next

}  // namespace

void LensWatch::add(const std::vector<TrackedPose>& poses) {
  int resting = 0, fitting = 0;
  for (std::size_t i = 0; i < poses.size() && i < before_.size(); ++i) {
    if (poses[i].status == TrackingStatus::lost || before_[i].status == TrackingStatus::lost) continue;
    const Vec3 moved = poses[i].camera_from_body.translation() - before_[i].camera_from_body.translation();
    if (moved.norm() > rest) continue;
    ++resting;
    fitting += poses[i].status == TrackingStatus::ok ? 1 : 0;
  }
  before_ = poses;
  if (resting == 0) return;
  disagree_.push_back(fitting == 0);
  if (disagree_.size() > pictures) disagree_.pop_front();
}

std::string LensWatch::warning() const {
  const auto bad = std::count(disagree_.begin(), disagree_.end(), true);
  if (disagree_.size() < pictures || static_cast<double>(bad) < share * static_cast<double>(pictures)) return {};
  return "no body fits the picture although all rest: the lens, its focus or the light changed since the camera was "
         "calibrated; calibrate it anew";
}

}  // namespace bodkin::tracking
