#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "tracking/camera_model.h"
#include "tracking/grey_image.h"
#include "tracking/marker_body.h"
#include "tracking/marker_search.h"
#include "tracking/photometric_refinement.h"
#include "tracking/rest_filter.h"

#include "core/geometry.h"

namespace bodkin::tracking {

enum class TrackingStatus : std::uint8_t {
  ok,         // the pose is as accurate as its covariance says
  uncertain,  // there is a pose, but image and model disagree, or another pose explains the image nearly as well
  lost        // there is no pose: no marker of the body was found
};
// "ok", "uncertain", "lost"
std::string_view name_of(TrackingStatus status);

// A body in one image.
struct TrackedPose {
  TrackingStatus status = TrackingStatus::lost;
  double time = 0.0;                         // of the image, s
  Pose camera_from_body = Pose::Identity();  // as measured in this image; meaningless when lost
  Pose filtered = Pose::Identity();          // the mean over the rest, or the measured one while it moves
  Matrix6 covariance = Matrix6::Zero();      // of the measured one, see RefinedPose
  double residual = 1.0, edge_ratio = 1.0;   // see RefinedPose
  CameraMisfit misfit;                       // meaningless when lost
  int markers = 0;                           // found on the body
};

// Covariance of a point of the body, camera axes, mm^2. `point`: body frame.
Mat3 point_covariance(const TrackedPose& pose, const Vec3& point);

// The part of an image in which the markers of a body at this pose are searched, with a margin of 12 pixels and 15 %
// of their extent around them; empty if a part of it is less than 10 mm in front of the camera.
std::optional<PictureBox> search_box(const MarkerBody& body, const Pose& camera_from_body, const CameraModel& camera);

// Settings of tracking.
struct TrackerSettings {
  // Large residuals at the edges are not noise but a wrong tone curve, motion or a defect of the body (see
  // RefinedPose): a pose is uncertain when both limits of a pair are exceeded, or when the residual is very large in
  // any case.
  double most_residual = 0.046, most_edge_ratio = 1.9;
  double high_residual = 0.055, high_edge_ratio = 1.5;
  double any_residual = 0.165;
  // A pose is also rejected when the image's light is not that of the calibrated camera (see CameraMisfit): with the
  // usual noise a camera's own images stay below half of these limits.
  double most_tone = 0.1;        // fraction of the step from black to white
  double most_blur = 0.2;        // pixels squared
  double least_contrast = 1.03;  // residual of the second-best pose over the best; below it the pose is uncertain
  int steps = 4;                 // of the refinement
  double search_every = 1.0;     // s; the whole image is searched this often, else boxes around the last poses
};

// Tracks marker bodies through the images of one camera. A pose does not depend on the previous one, which only
// determines where to search first.
class Tracker {
 public:
  Tracker(const CameraModel& camera, std::vector<MarkerBody> bodies, const TrackerSettings& settings = {});

  // The bodies in an image of the camera's size, in the order of bodies(). `time`: s, of the image. Throws InputError
  // when the image has another size.
  const std::vector<TrackedPose>& track(const GreyImage& picture, double time);

  const std::vector<MarkerBody>& bodies() const { return bodies_; }
  const std::vector<TrackedPose>& poses() const { return poses_; }
  const CameraModel& camera() const { return refinement_.camera(); }
  // Markers in the last image, including those of no body; none of a mirrored one (is_mirrored()), in which all
  // bodies are lost.
  const std::vector<FoundMarker>& markers() const { return found_; }

 private:
  void search(const GreyImage& picture, double time);
  TrackedPose follow(const GreyImage& picture, const MarkerBody& body) const;

  std::vector<MarkerBody> bodies_;
  TrackerSettings settings_;
  PhotometricRefinement refinement_;
  std::vector<RestFilter> filters_;
  std::vector<TrackedPose> poses_;
  std::vector<FoundMarker> found_;
  std::optional<double> searched_;  // time of the last search of the whole image
  std::optional<double> looked_;    // time of the last check for mirroring
  bool mirrored_ = false;           // in which case no marker counts as found
};

}  // namespace bodkin::tracking
