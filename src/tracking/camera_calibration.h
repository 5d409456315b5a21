#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tracking/calibration_board.h"
#include "tracking/camera_model.h"
#include "tracking/grey_image.h"

namespace bodkin::tracking {

// How an image was used for the calibration of a camera.
enum class PictureUse : std::uint8_t {
  kept,
  few_corners,   // fewer than 12 corners of the board were seen
  moving,        // the board, or the camera, moved since the previous image
  seen_already,  // an accepted image is nearly the same
};
std::string_view name_of(PictureUse use);  // "kept", "too few corners", "moving", "seen already"

struct CalibrationOptions {
  // The images come at a camera's rate: one is accepted only when the board was at rest since the previous one.
  bool in_motion = true;
  double rest = 0.4;  // pixels, RMS by which the corners may move from one image to the next
  int most_pictures = 60;
};

// A camera calibrated from images of the board.
struct CalibratedCamera {
  CameraModel camera;
  double residual = 0.0;          // RMS of the corners, pixels
  double focal_deviation = 0.0;   // standard deviation of fx, pixels
  double centre_deviation = 0.0;  // of the principal point, the larger of both, pixels
  double light_residual = 0.0;    // of image against model, fraction of the step from black to white
  int pictures = 0;               // used
  int refused = 0;                // rejected in the end: motion blur, or their corners do not fit
};

// Determines lens, tone curve and blur of a camera. The lens comes from the corners of the board
// (cv::calibrateCamera, Zhang 2000); tone curve and blur minimise the difference of the rendered markers from the
// images.
class CameraCalibration {
 public:
  explicit CameraCalibration(const CalibrationBoard& board, const CalibrationOptions& options = {});

  // Throws InputError when the image has another size than the first.
  PictureUse add(const GreyImage& picture);
  int kept() const { return static_cast<int>(views_.size()); }
  // Fraction of the image, in 6 x 4 fields, in which a corner was seen.
  double coverage() const;
  // Number of oblique views of the board, by at least 15 degrees, as estimated from the corners.
  int tilted() const;
  // How to improve the calibration, one sentence; empty when the data suffice.
  std::string advice() const;

  // Throws InputError when there are fewer than 10 images or they do not determine the lens.
  CalibratedCamera solve() const;

 private:
  struct View {
    GreyImage picture;
    std::vector<FoundMarker> markers;
    std::vector<FoundCorner> corners;
    double tilt = 0.0;  // relative difference in size of the board's markers
  };

  // The markers of a view used for comparing light, and the pose of the board.
  struct Sheet {
    const View* view = nullptr;
    std::vector<int> ids;
    Pose pose = Pose::Identity();
  };

  void fit_lens(std::vector<const View*>& used, CalibratedCamera& made) const;
  void fit_light(const std::vector<const View*>& views, CalibratedCamera& made) const;
  Sheet sheet_of(const CameraModel& camera, const View& view) const;
  std::vector<double> light_residuals(const CameraModel& camera, const std::vector<const View*>& views) const;

  CalibrationBoard board_;
  MarkerBody body_;
  CalibrationOptions options_;
  std::vector<View> views_;
  std::vector<FoundCorner> before_;  // of the previous image
  int width_ = 0, height_ = 0;
};

}  // namespace bodkin::tracking
