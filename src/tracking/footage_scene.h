#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tracking/footage.h"
#include "tracking/registration.h"

#include "core/progress.h"

namespace bodkin::tracking {

// A teaching station in front of a camera: a mannequin with its board, a needle that is inserted into it and a probe.
struct SceneOptions {
  int frames = 60;     // 1 to 100000
  double rate = 30.0;  // pictures/s
  int width = 1280, height = 720;
  std::uint64_t seed = 1;
  ToneCurve tone;       // of the camera
  double blur = 0.7;    // pixels
  double motion = 0.0;  // of the needle during an exposure, pixels
  bool still = false;   // nothing moves
  // mm of a path that begins at scene_skin() and goes straight into the mannequin (placed_along): the needle comes
  // from 40 mm above the skin, goes along it to its end at 15 mm/s, rests there for 1.5 s, and is withdrawn; `aside`
  // mm by which the needle's line is shifted towards the mannequin's x. 0: it goes in and out at an angle.
  double path = 0.0, aside = 0.0;
  FootageLook look;
};

// s from the start to the end of such a needle's motion.
double motion_duration(const SceneOptions& options);

// The middle of the mannequin's skin, from the middle of its board (mannequin frame, mm).
Vec3 scene_skin();

// An image of footage with the true poses.
struct FootageFrame {
  std::string file;                    // within the folder
  double time = 0.0;                   // s
  std::vector<Pose> camera_from_body;  // truth, in the order of the bodies; empty for footage of a real camera
};

// Footage in a folder: images, and for rendered footage camera, bodies and true poses.
struct Footage {
  std::filesystem::path folder;
  std::vector<FootageFrame> frames;
  std::vector<std::string> bodies;  // names, in the order of the poses
};

// Renders the scene into a folder: frame_00000.png and so on, camera.json, bodies.json and scene.json with the truth.
// Throws InputError when the folder exists and is not empty.
Footage render_scene(const std::filesystem::path& folder, const SceneOptions& options, const Progress& progress = {});

// A folder of images (.png, .jpg, .jpeg) as a source. With scene.json in it times and true poses come from there;
// without, images come in the order of their names, `rate` per second. Throws InputError when there is no image.
Footage open_footage(const std::filesystem::path& folder, double rate = 30.0);

// An image of footage. Throws InputError naming the file.
imaging::ImageRgb read_picture(const std::filesystem::path& file);

}  // namespace bodkin::tracking
