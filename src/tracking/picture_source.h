#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tracking/camera_model.h"
#include "tracking/grey_picture.h"

#include "core/geometry.h"
#include "imaging/image_rgb.h"

namespace bodkin::tracking {

// One picture of a camera, a video or a folder.
struct SourcePicture {
  imaging::ImageRgb colour;
  GreyPicture grey;
  double time = 0.0;  // s: of a camera the moment of the exposure, else from the first picture
  // When it had come from the driver, the pipe or the disk and was still to be decoded.
  std::chrono::steady_clock::time_point arrived;
  std::vector<Pose> camera_from_body;  // truth of rendered footage, in the order of bodies(); else empty
};

// Where pictures come from, one after the other.
class PictureSource {
 public:
  virtual ~PictureSource() = default;

  // The next picture; nothing at the end. A live camera gives the newest, waits for it and has no end. Throws
  // InputError for a damaged picture, SystemError when a camera or a program stops.
  virtual std::optional<SourcePicture> next() = 0;
  // How many pictures there are; 0: a live camera.
  virtual int count() const = 0;
  // Pictures/s, in the middle of all.
  virtual double rate() const = 0;
  // Names of the bodies whose true poses the pictures carry.
  virtual std::vector<std::string> bodies() const { return {}; }
  // What a user should know, a sentence each, such as that the rate of a video varies.
  virtual std::vector<std::string> notes() const { return {}; }
  // How a camera was locked, for its calibration.
  virtual CameraControls controls() const { return {}; }

  bool live() const { return count() == 0; }
};

// Notes as one sentence; empty: there are none.
std::string sentence_of(const std::vector<std::string>& notes);

// What a source is opened with.
struct SourceOptions {
  double rate = 30.0;                   // of a folder that has no times, and asked of a camera; pictures/s
  int width = 1280, height = 720;       // asked of a camera
  std::optional<CameraControls> locks;  // of a camera's calibration; absent: what the camera has now
  double busy_patience = 2.0;           // s for which a camera that another program uses is tried again
};

// A folder of pictures (.png, .jpg), a video file, or a camera's device file (/dev/video0). Throws InputError when it
// is none of these, SystemError when what it takes is missing.
std::unique_ptr<PictureSource> open_source(const std::string& name, const SourceOptions& options = {});

}  // namespace bodkin::tracking
