#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tracking/camera_model.h"
#include "tracking/grey_image.h"
#include "tracking/marker_body.h"
#include "tracking/picture_source.h"
#include "tracking/registration.h"

#include "anatomy/needle_path.h"
#include "core/geometry.h"

namespace bodkin::tracking {

// The images of a teaching station and the files needed to interpret them.
struct FootageFiles {
  std::string source;            // folder of pictures, video file or camera (/dev/video0)
  std::filesystem::path camera;  // its calibration; empty: camera.json in the folder
  std::filesystem::path bodies;  // empty: bodies.json in the folder, else station_bodies()
  double rate = 30.0;            // images/s of a folder without times, and requested from a camera
};

struct OpenedFootage {
  std::unique_ptr<PictureSource> source;
  CameraModel camera;
  std::vector<MarkerBody> bodies;
};

// Whether a calibration is given or is in the folder.
bool has_calibration(const FootageFiles& files);
// Throws InputError for missing, damaged or uncalibrated input, SystemError as open_source() does.
OpenedFootage open_footage_files(const FootageFiles& files);

// One sentence when footage showed no marker at all: the wrong dictionary, or mirrored images. `picture`: one of
// them.
std::string why_nothing_was_found(const std::string& source, const GreyImage& picture);

// The pose of a tool in the patient, LPS mm: origin at the body's tip, third axis along the body's axis, first axis
// as close as possible to the body's. All poses are of one image.
Pose tool_in_patient(const MarkerBody& body, const Pose& camera_from_body, const Pose& camera_from_mannequin,
                     const Similarity& mannequin_from_patient);

// The placement of a patient before there is a registration: the entry of `path` lies at `at` (mannequin frame, mm),
// the path points into the mannequin, and the patient's feet point down the board.
Similarity placed_along(const anatomy::NeedlePath& path, const Vec3& at);

}  // namespace bodkin::tracking
