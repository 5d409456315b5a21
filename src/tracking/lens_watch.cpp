#include "tracking/lens_watch.h"

#include <algorithm>
#include <cmath>

namespace bodkin::tracking {

namespace {

constexpr std::size_t pictures = 30;  // a second of a usual camera
constexpr double share = 0.8;         // of them in which no body fits
constexpr double rest = 2.0;          // mm from one picture to the next
constexpr int of_board = 4;           // markers visible at once; at most three of a cube
constexpr double most_focal = 0.005;  // share by which a board may say that the focal length is another

template <typename Of>
void note_picture(std::deque<Of>& last, const Of& now) {
  last.push_back(now);
  if (last.size() > pictures) last.pop_front();
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
    if (poses[i].markers < of_board) continue;
    note_picture(boards_[i].disagreements, !fits);
    if (fits && poses[i].misfit.focal.deviation > 0.0) note_picture(boards_[i].focal, poses[i].misfit.focal);
  }
  before_ = poses;
  if (resting > 0) note_picture(all_, fitting == 0);
}

// By the mean of the estimates, weighted by their information. Their errors come from the images' noise, which is
// independent.
bool LensWatch::has_other_focal(const Board& board) {
  if (board.focal.size() < pictures) return false;
  double weights = 0.0, sum = 0.0;
  for (const Estimate& one : board.focal) {
    const double weight = 1.0 / (one.deviation * one.deviation);
    weights += weight;
    sum += weight * one.value;
  }
  return Estimate{sum / weights, 1.0 / std::sqrt(weights)}.exceeds(most_focal);
}

std::string LensWatch::warning() const {
  if (lasts(all_)) {
    return "no body fits the picture although all rest: the lens, its focus or the light changed since the camera "
           "was calibrated; calibrate it again";
  }
  if (std::any_of(boards_.begin(), boards_.end(),
                  [](const Board& board) { return lasts(board.disagreements) || has_other_focal(board); })) {
    return "a board of markers does not fit the picture although it rests: it is bent, or the lens or its focus "
           "changed since the camera was calibrated; press it flat, or else calibrate the camera again";
  }
  return {};
}

}  // namespace bodkin::tracking
