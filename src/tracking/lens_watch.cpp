#include "tracking/lens_watch.h"

#include <algorithm>

namespace bodkin::tracking {

namespace {

constexpr std::size_t pictures = 30;  // a second of a usual camera
constexpr double share = 0.8;         // of them in which no body fits
constexpr double rest = 2.0;          // mm from one picture to the next
constexpr int of_board = 4;           // markers seen at once; of a cube three are at most
constexpr double most_focal = 0.01;   // share by which a board may say that the focal length is another

void note_picture(std::deque<bool>& disagreements, bool disagrees) {
  disagreements.push_back(disagrees);
  if (disagreements.size() > pictures) disagreements.pop_front();
}

bool lasts(const std::deque<bool>& disagreements) {
  const auto bad = std::count(disagreements.begin(), disagreements.end(), true);
  return disagreements.size() == pictures && static_cast<double>(bad) >= share * static_cast<double>(pictures);
}

}  // namespace

void LensWatch::add(const std::vector<TrackedPose>& poses) {
  boards_.resize(poses.size());
  int resting = 0, fitting = 0;
  for (std::size_t i = 0; i < poses.size() && i < before_.size(); ++i) {
    if (poses[i].status == TrackingStatus::lost || before_[i].status == TrackingStatus::lost) continue;
    const Vec3 moved = poses[i].camera_from_body.translation() - before_[i].camera_from_body.translation();
    if (moved.norm() > rest) continue;
    const bool fits = poses[i].status == TrackingStatus::ok;
    ++resting;
    fitting += fits ? 1 : 0;
    if (poses[i].markers >= of_board) note_picture(boards_[i], !fits || poses[i].misfit.focal.exceeds(most_focal));
  }
  before_ = poses;
  if (resting > 0) note_picture(all_, fitting == 0);
}

std::string LensWatch::warning() const {
  if (lasts(all_)) {
    return "no body fits the picture although all rest: the lens, its focus or the light changed since the camera "
           "was calibrated; calibrate it anew";
  }
  if (std::any_of(boards_.begin(), boards_.end(), lasts)) {
    return "a board of markers does not fit the picture although it rests: it is bent, or the lens or its focus "
           "changed since the camera was calibrated; press it flat, else calibrate the camera anew";
  }
  return {};
}

}  // namespace bodkin::tracking
