#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tracking/calibration_board.h"
#include "tracking/camera_model.h"
#include "tracking/grey_picture.h"

namespace bodkin::tracking {

// What became of a picture for the calibration of a camera.
enum class PictureUse : std::uint8_t {
  kept,
  few_corners,   // fewer than 12 corners of the board were seen
  moving,        // the board, or the camera, moved since the picture before
  seen_already,  // a picture that was kept shows nearly the same
};
std::string_view name_of(PictureUse use);  // "kept", "too few corners", "moving", "seen already"

struct CalibrationOptions {
  // The pictures follow one another at a camera's rate: one is taken only when the board rested since the one before.
  bool in_motion = true;
  double rest = 0.4;  // pixels, RMS by which the corners may move from one picture to the next
  int most_pictures = 60;
};

// A camera found from pictures of the board.
struct CalibratedCamera {
  CameraModel camera;
  double residual = 0.0;          // RMS of the corners, pixels
  double focal_deviation = 0.0;   // standard deviation of fx, pixels
  double centre_deviation = 0.0;  // of the principal point, the larger of both, pixels
  double light_residual = 0.0;    // of picture against model, share of the step from black to white
  int pictures = 0;               // used
  int refused = 0;                // left out in the end: blurred by motion, or their corners do not fit
};

// Finds lens, tone curve and blur of a camera. The lens comes from the corners of the board (cv::calibrateCamera,
// Zhang 2000); tone curve and blur are those with which the rendered markers differ least from the pictures.
class CameraCalibration {
 public:
  explicit CameraCalibration(const CalibrationBoard& board, const CalibrationOptions& options = {});

  // Throws InputError when the picture has another size than the first.
  PictureUse add(const GreyPicture& picture);
  int kept() const { return static_cast<int>(views_.size()); }
  // Share of the picture, in 6 x 4 fields, in which a corner was seen.
  double coverage() const;
  // Views that look at the board from the side, by 15 degrees or more, as far as the corners tell.
  int tilted() const;
  // What would make it better, as one sentence; empty when there is enough.
  std::string advice() const;

  // Throws InputError when there are fewer than 10 pictures or they do not say what the lens is like.
  CalibratedCamera solve() const;

 private:
  struct View {
    GreyPicture picture;
    std::vector<FoundMarker> markers;
    std::vector<FoundCorner> corners;
    double tilt = 0.0;  // relative difference in size of the board's markers
  };

  // The markers of a view by which light is compared, and where the board was.
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
  std::vector<FoundCorner> before_;  // of the picture before
  int width_ = 0, height_ = 0;
};

}  // namespace bodkin::tracking
