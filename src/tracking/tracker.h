#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "tracking/camera_model.h"
#include "tracking/grey_picture.h"
#include "tracking/marker_body.h"
#include "tracking/marker_search.h"
#include "tracking/photometric_refinement.h"
#include "tracking/rest_filter.h"

#include "core/geometry.h"

namespace bodkin::tracking {

enum class TrackingStatus : std::uint8_t {
  ok,         // the pose is good to what its covariance says
  uncertain,  // there is a pose, but picture and model disagree, or another pose explains the picture nearly as well
  lost        // there is none: no marker of the body was found
};
// "ok", "uncertain", "lost"
std::string_view name_of(TrackingStatus status);

// Where a body is in one picture.
struct TrackedPose {
  TrackingStatus status = TrackingStatus::lost;
  double time = 0.0;                         // of the picture, s
  Pose camera_from_body = Pose::Identity();  // as measured in this picture; meaningless when lost
  Pose filtered = Pose::Identity();          // the mean over the rest, or the same as measured while it moves
  Matrix6 covariance = Matrix6::Zero();      // of the measured one, see RefinedPose
  double residual = 1.0, edge_ratio = 1.0;   // see RefinedPose
  CameraMisfit misfit;                       // see there; of no meaning when lost
  int markers = 0;                           // found on the body
};

// Standard deviation of a point of the body, camera axes, mm^2. `point`: body frame.
Mat3 point_covariance(const TrackedPose& pose, const Vec3& point);

// The part of a picture in which the markers of a body at this pose are searched, with a margin of 12 pixels and 15 %
// of their extent around them; nothing where a part of it is less than 10 mm before the camera.
std::optional<PictureBox> search_box(const MarkerBody& body, const Pose& camera_from_body, const CameraModel& camera);

// What may be changed in tracking.
struct TrackerSettings {
  // What is left at the edges is no noise but a wrong tone curve, motion or a fault of the body (see RefinedPose): a
  // pose is uncertain when both numbers of a pair are exceeded, or when the residual is very large in any case.
  double most_residual = 0.046, most_edge_ratio = 1.9;
  double high_residual = 0.055, high_edge_ratio = 1.5;
  double any_residual = 0.165;
  // Nor does the pose of a picture count whose light is not the calibrated camera's (see CameraMisfit): with the
  // usual noise a camera's own pictures stay below half of these.
  double most_tone = 0.1;        // share of the step from black to white
  double most_blur = 0.2;        // pixels squared
  double least_contrast = 1.03;  // residual of the second-best pose over that of the best; below, it is uncertain
  int steps = 4;                 // of the refinement
  double search_every = 1.0;     // s; the whole picture is searched this often, else boxes around the last poses
};

// Follows marker bodies through the pictures of one camera. A pose never leans on the one before: that only says
// where to look first.
class Tracker {
 public:
  Tracker(const CameraModel& camera, std::vector<MarkerBody> bodies, const TrackerSettings& settings = {});

  // The bodies in a picture of the camera's size, in the order of bodies(). `time`: s, of the picture. Throws
  // InputError when the picture has another size.
  const std::vector<TrackedPose>& track(const GreyPicture& picture, double time);

  const std::vector<MarkerBody>& bodies() const { return bodies_; }
  const std::vector<TrackedPose>& poses() const { return poses_; }
  const CameraModel& camera() const { return refinement_.camera(); }
  // Markers that the last picture showed, also those of no body; none of a mirrored one (is_mirrored()), in which all
  // bodies are lost.
  const std::vector<FoundMarker>& markers() const { return found_; }

 private:
  void search(const GreyPicture& picture, double time);
  TrackedPose follow(const GreyPicture& picture, const MarkerBody& body) const;

  std::vector<MarkerBody> bodies_;
  TrackerSettings settings_;
  PhotometricRefinement refinement_;
  std::vector<RestFilter> filters_;
  std::vector<TrackedPose> poses_;
  std::vector<FoundMarker> found_;
  std::optional<double> searched_;  // when the whole picture was searched last
  std::optional<double> looked_;    // when it was last asked whether it is mirrored
  bool mirrored_ = false;           // then no marker counts as found
};

}  // namespace bodkin::tracking
