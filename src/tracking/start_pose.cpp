#include "tracking/start_pose.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

namespace bodkin::tracking {

namespace {

struct Corners {
  std::vector<cv::Point3d> body;
  std::vector<cv::Point2d> seen;  // x and y of the ray (x, y, 1), without the lens's distortion
};

Pose pose_of(const cv::Mat& turn, const cv::Mat& shift) {
  cv::Mat matrix;
  cv::Rodrigues(turn, matrix);
  Pose pose = Pose::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) pose.linear()(i, j) = matrix.at<double>(i, j);
    pose.translation()[i] = shift.at<double>(i);
  }
  return pose;
}

void to_vectors(const Pose& pose, cv::Mat& turn, cv::Mat& shift) {
  const Eigen::AngleAxisd rotation(pose.linear());
  const Vec3 vector = rotation.angle() * rotation.axis();
  turn = (cv::Mat_<double>(3, 1) << vector.x(), vector.y(), vector.z());
  shift = (cv::Mat_<double>(3, 1) << pose.translation().x(), pose.translation().y(), pose.translation().z());
}

double corner_error(const Corners& corners, const Pose& pose, double focal) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.body.size(); ++i) {
    const Vec3 at = pose * Vec3(corners.body[i].x, corners.body[i].y, corners.body[i].z);
    if (at.z() <= 0.0) return 1e9;
    sum += std::pow(at.x() / at.z() - corners.seen[i].x, 2) + std::pow(at.y() / at.z() - corners.seen[i].y, 2);
  }
  return focal * std::sqrt(sum / static_cast<double>(corners.body.size()));
}

}  // namespace

std::vector<StartPose> start_poses(const CameraModel& camera, const MarkerBody& body,
                                   const std::vector<FoundMarker>& found) {
  Corners corners;
  std::vector<Pose> candidates;
  const cv::Matx33d pinhole = cv::Matx33d::eye();
  std::vector<cv::Mat> turns, shifts;
  for (const FoundMarker& marker : found) {
    const MarkerFace* const face = body.face_of(marker.id);
    if (face == nullptr) continue;
    const double half = 0.5 * face->side;
    const std::vector<cv::Point3d> square = {{-half, half, 0}, {half, half, 0}, {half, -half, 0}, {-half, -half, 0}};
    std::vector<cv::Point2d> rays;
    const std::array<Vec3, 4> on_body = face->corners();
    for (std::size_t c = 0; c < 4; ++c) {
      const Vec3 ray = camera.ray(marker.corners[c]);
      rays.emplace_back(ray.x(), ray.y());
      corners.body.emplace_back(on_body[c].x(), on_body[c].y(), on_body[c].z());
      corners.seen.push_back(rays.back());
    }
    cv::solvePnPGeneric(square, rays, pinhole, cv::noArray(), turns, shifts, false, cv::SOLVEPNP_IPPE_SQUARE);
    for (std::size_t i = 0; i < turns.size(); ++i) {
      Pose place = pose_of(turns[i], shifts[i]);
      place.linear() = place.linear() * Vec3(1.0, -1.0, -1.0).asDiagonal();  // its y is up, its z out of the face
      candidates.push_back(place * face->place.inverse());
    }
  }
  if (corners.body.empty()) return {};
  if (corners.body.size() > 4) {
    cv::solvePnPGeneric(corners.body, corners.seen, pinhole, cv::noArray(), turns, shifts, false, cv::SOLVEPNP_SQPNP);
    for (std::size_t i = 0; i < turns.size(); ++i) candidates.push_back(pose_of(turns[i], shifts[i]));
  }
  const double focal = 0.5 * (camera.fx + camera.fy);
  std::vector<StartPose> rough;
  for (const Pose& candidate : candidates) {
    // The planar solutions of a degenerate square are NaN.
    const double error = corner_error(corners, candidate, focal);
    if (std::isfinite(error) && candidate.matrix().allFinite()) rough.push_back({candidate, error});
  }
  const auto better = [](const StartPose& a, const StartPose& b) { return a.error < b.error; };
  std::sort(rough.begin(), rough.end(), better);
  // Markers of a body give many equal ones: only distinct ones are refined.
  const auto keep_distinct = [](const std::vector<StartPose>& from, double angle) {
    std::vector<StartPose> kept;
    for (const StartPose& start : from) {
      const bool known = std::any_of(kept.begin(), kept.end(), [&](const StartPose& other) {
        return Eigen::AngleAxisd(start.camera_from_body.linear().transpose() * other.camera_from_body.linear())
                   .angle() < angle * degree;
      });
      if (!known) kept.push_back(start);
    }
    return kept;
  };
  std::vector<StartPose> starts = keep_distinct(rough, 8.0);
  constexpr std::size_t most = 6;
  if (starts.size() > most) starts.resize(most);
  for (StartPose& start : starts) {
    cv::Mat turn, shift;
    to_vectors(start.camera_from_body, turn, shift);
    cv::solvePnPRefineLM(corners.body, corners.seen, pinhole, cv::noArray(), turn, shift);
    const Pose refined = pose_of(turn, shift);
    const double error = corner_error(corners, refined, focal);
    if (error <= start.error) start = {refined, error};
  }
  std::sort(starts.begin(), starts.end(), better);
  return keep_distinct(starts, 3.0);
}

}  // namespace bodkin::tracking
