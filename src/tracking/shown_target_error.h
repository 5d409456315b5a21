#pragma once

#include <optional>

#include "tracking/camera_model.h"
#include "tracking/registration.h"
#include "tracking/tracker.h"

namespace bodkin::tracking {

// The length of the predicted target registration error in a camera's images, across the view.
class ShownTargetError {
 public:
  // `registration`: of the patient to the mannequin, with or without a prediction.
  ShownTargetError(const Registration& registration, const CameraModel& camera);

  // The mannequin in the next image.
  void add(const TrackedPose& mannequin);
  // mm; empty if the registration predicts none.
  const std::optional<ErrorInterval>& in_mm() const { return in_mm_; }
  // Pixels, the mean over the images that show the mannequin; empty if none does, or without a prediction.
  std::optional<ErrorInterval> in_pixels() const;

 private:
  std::optional<ErrorInterval> in_mm_;
  Vec3 place_ = Vec3::Zero();  // mm, of the target in the mannequin
  double focal_ = 0.0;         // pixels
  double scales_ = 0.0;        // pixels per mm, sum of the pictures
  int pictures_ = 0;
};

}  // namespace bodkin::tracking
