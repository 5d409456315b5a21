#include "tracking/shown_target_error.h"

namespace bodkin::tracking {

ShownTargetError::ShownTargetError(const Registration& registration, const CameraModel& camera)
    : focal_(0.5 * (camera.fx + camera.fy)) {
  if (!registration.at_target) return;
  in_mm_ = registration.at_target->tre;
  place_ = registration.fixed_from_moving * registration.at_target->target;
}

void ShownTargetError::add(const TrackedPose& mannequin) {
  if (mannequin.status == TrackingStatus::lost) return;
  const double depth = (mannequin.camera_from_body * place_).z();
  if (depth <= 0.0) return;
  scales_ += focal_ / depth;
  ++pictures_;
}

std::optional<ErrorInterval> ShownTargetError::in_pixels() const {
  if (!in_mm_ || pictures_ == 0) return std::nullopt;
  const double scale = scales_ / pictures_;
  return ErrorInterval{
      .low = scale * in_mm_->low, .estimate = scale * in_mm_->estimate, .high = scale * in_mm_->high};
}

}  // namespace bodkin::tracking
