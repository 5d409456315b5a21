#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tracking/camera_model.h"
#include "tracking/grey_image.h"

#include "core/geometry.h"
#include "imaging/image_rgb.h"

namespace bodkin::tracking {

// One image of a camera, a video or a folder.
struct SourcePicture {
  imaging::ImageRgb colour;
  GreyImage grey;
  double time = 0.0;  // s: for a camera the time of the exposure, else since the first image
  // Arrival from the driver, the pipe or the disk, before decoding.
  std::chrono::steady_clock::time_point arrived;
  std::vector<Pose> camera_from_body;  // truth of rendered footage, in the order of bodies(); else empty
};

// A source of images, one after the other.
class PictureSource {
 public:
  virtual ~PictureSource() = default;

  // The next image; empty at the end. A live camera waits for the newest one and has no end. Throws InputError for a
  // damaged image, SystemError when a camera or a program stops.
  virtual std::optional<SourcePicture> next() = 0;
  // Number of images; 0: a live camera.
  virtual int count() const = 0;
  // Images/s, mean.
  virtual double rate() const = 0;
  // Names of the bodies whose true poses come with the images.
  virtual std::vector<std::string> bodies() const { return {}; }
  // Remarks for the user, a sentence each, such as that the rate of a video varies.
  virtual std::vector<std::string> notes() const { return {}; }
  // The locked controls of a camera, for its calibration.
  virtual CameraControls controls() const { return {}; }

  bool live() const { return count() == 0; }
};

// Notes as one sentence; empty: there are none.
std::string sentence_of(const std::vector<std::string>& notes);

// Options for opening a source.
struct SourceOptions {
  double rate = 30.0;                   // of a folder without times, and requested from a camera; images/s
  int width = 1280, height = 720;       // requested from a camera
  std::optional<CameraControls> locks;  // of a camera's calibration; absent: its present settings
  double busy_patience = 2.0;           // s for which a camera in use by another program is tried again
};

// A folder of images (.png, .jpg), a video file, or a camera's device file (/dev/video0). Throws InputError when it
// is none of these, SystemError when a required program is missing.
std::unique_ptr<PictureSource> open_source(const std::string& name, const SourceOptions& options = {});

}  // namespace bodkin::tracking
