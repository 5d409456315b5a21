#include "tracking/tracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tracking/cross_matrix.h"
#include "tracking/start_pose.h"
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::tracking {

std::string_view name_of(TrackingStatus status) {
  switch (status) {
    case TrackingStatus::ok:
      return "ok";
    case TrackingStatus::uncertain:
      return "uncertain";
    case TrackingStatus::lost:
      return "lost";
  }
  return "";
}

std::optional<PictureBox> search_box(const MarkerBody& body, const Pose& camera_from_body,
                                     const CameraModel& camera) {
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const MarkerFace& face : body.faces) {
    if (face.id < 0) continue;
    for (const Vec3& corner : face.corners()) {
      const Vec3 at = camera_from_body * corner;
      if (at.z() < 10.0) return std::nullopt;
      const Eigen::Vector2d pixel = camera.project(at);
      low = low.cwiseMin(pixel);
      high = high.cwiseMax(pixel);
    }
  }
  const Eigen::Vector2d around = Eigen::Vector2d::Constant(12.0 + 0.15 * (high - low).maxCoeff());
  low = (low - around).cwiseMax(0.0);
  high = (high + around).cwiseMin(Eigen::Vector2d(camera.width, camera.height));
  return PictureBox{static_cast<int>(low.x()), static_cast<int>(low.y()), static_cast<int>(high.x() - low.x()),
                    static_cast<int>(high.y() - low.y())};
}

Mat3 point_covariance(const TrackedPose& pose, const Vec3& point) {
  Eigen::Matrix<double, 3, 6> slope;
  slope.leftCols<3>().setIdentity();
  slope.rightCols<3>() = -cross_matrix(pose.camera_from_body.linear() * point);
  return slope * pose.covariance * slope.transpose();
}

Tracker::Tracker(const CameraModel& camera, std::vector<MarkerBody> bodies, const TrackerSettings& settings)
    : bodies_(std::move(bodies)),
      settings_(settings),
      refinement_(camera),
      filters_(bodies_.size()),
      poses_(bodies_.size()) {}

void Tracker::search(const GreyImage& picture, double time) {
  const bool all_known = std::all_of(poses_.begin(), poses_.end(),
                                     [](const TrackedPose& pose) { return pose.status == TrackingStatus::ok; });
  if (all_known && searched_ && time - *searched_ < settings_.search_every && time >= *searched_) {
    std::vector<PictureBox> boxes;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const std::optional<PictureBox> box = search_box(bodies_[i], poses_[i].camera_from_body, camera());
      if (box) boxes.push_back(*box);
    }
    found_ = search_markers(picture, boxes);
    const bool all_found = std::all_of(bodies_.begin(), bodies_.end(), [&](const MarkerBody& body) {
      return std::any_of(found_.begin(), found_.end(),
                         [&](const FoundMarker& marker) { return body.face_of(marker.id) != nullptr; });
    });
    if (all_found) return;
  }
  found_ = search_markers(picture);
  searched_ = time;
  // In a mirrored image a marker can be mistaken for another, and a body found in the wrong place.
  if (!all_known && (!looked_ || time - *looked_ >= settings_.search_every || time < *looked_)) {
    mirrored_ = is_mirrored(picture);
    looked_ = time;
  }
  if (mirrored_) found_.clear();
}

TrackedPose Tracker::follow(const GreyImage& picture, const MarkerBody& body) const {
  TrackedPose tracked;
  std::vector<int> ids;
  for (const FoundMarker& marker : found_) {
    if (body.face_of(marker.id) != nullptr) ids.push_back(marker.id);
  }
  tracked.markers = static_cast<int>(ids.size());
  const std::vector<StartPose> starts = start_poses(camera(), body, found_);
  if (starts.empty()) return tracked;
  RefinedPose best, second;
  for (const StartPose& start : starts) {
    // Corners have errors of about a pixel: a start that explains them much worse than another is not the pose.
    if (start.error > 3.0 * starts.front().error + 2.0) continue;
    const RefinedPose refined = refinement_.refine(picture, body, ids, start.camera_from_body, settings_.steps);
    if (!refined.sound) continue;
    const bool same =
        best.sound &&
        Eigen::AngleAxisd(best.camera_from_body.linear().transpose() * refined.camera_from_body.linear()).angle() <
            1.0 * degree;
    if (!best.sound || refined.residual < best.residual) {
      if (best.sound && !same) second = best;
      best = refined;
    } else if (!same && (!second.sound || refined.residual < second.residual)) {
      second = refined;
    }
  }
  if (!best.sound) {
    tracked.status = TrackingStatus::uncertain;
    tracked.camera_from_body = starts.front().camera_from_body;
    tracked.covariance.diagonal() << 25.0, 25.0, 400.0, 0.01, 0.01, 0.01;  // of corners alone
    return tracked;
  }
  tracked.camera_from_body = best.camera_from_body;
  tracked.covariance = best.covariance;
  tracked.residual = best.residual;
  tracked.edge_ratio = best.edge_ratio;
  tracked.misfit = refinement_.misfit(picture, body, ids, best);
  const bool ambiguous = second.sound && second.residual < settings_.least_contrast * best.residual;
  const auto beyond = [&](double residual, double ratio) {
    return best.residual > residual && best.edge_ratio > ratio;
  };
  const bool unlike = beyond(settings_.most_residual, settings_.most_edge_ratio) ||
                      beyond(settings_.high_residual, settings_.high_edge_ratio) ||
                      best.residual > settings_.any_residual;
  const bool other_light =
      tracked.misfit.tone.exceeds(settings_.most_tone) || tracked.misfit.blur.exceeds(settings_.most_blur);
  tracked.status = unlike || ambiguous || other_light ? TrackingStatus::uncertain : TrackingStatus::ok;
  return tracked;
}

const std::vector<TrackedPose>& Tracker::track(const GreyImage& picture, double time) {
  if (picture.width != camera().width || picture.height != camera().height) {
    throw InputError(
        fmt::format("the picture has {} x {} pixels, but the camera was calibrated at {} x {}; calibrate "
                    "it at the size that is used",
                    picture.width, picture.height, camera().width, camera().height));
  }
  search(picture, time);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    poses_[i] = follow(picture, bodies_[i]);
    poses_[i].time = time;
    if (poses_[i].status == TrackingStatus::ok) {
      poses_[i].filtered = filters_[i].add(poses_[i].camera_from_body, poses_[i].covariance);
    } else {
      filters_[i].clear();
      poses_[i].filtered = poses_[i].camera_from_body;
    }
  }
  return poses_;
}

}  // namespace bodkin::tracking
