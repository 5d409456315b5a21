#pragma once

#include <vector>

#include "tracking/camera_model.h"
#include "tracking/marker_body.h"
#include "tracking/marker_search.h"

#include "core/geometry.h"

namespace bodkin::tracking {

struct StartPose {
  Pose camera_from_body = Pose::Identity();
  double error = 0.0;  // RMS of the corners, pixels
};

// Candidate poses of a body, from the corners of its markers: both planar solutions of every marker (Collins and
// Bartoli 2014) and the solution of all corners together, each refined over all corners. Those within 3 degrees of a
// better one are left out; the best comes first. Empty when no marker of the body was found.
std::vector<StartPose> start_poses(const CameraModel& camera, const MarkerBody& body,
                                   const std::vector<FoundMarker>& found);

}  // namespace bodkin::tracking
