#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tracking/footage.h"
#include "tracking/registration.h"

#include "core/progress.h"

namespace bodkin::tracking {

// A teaching station before a camera: a mannequin with its board, a needle that goes into it and a probe.
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

// s from the beginning of such a needle's way to its end.
double length_of_way(const SceneOptions& options);

// The middle of the mannequin's skin, from the middle of its board (mannequin frame, mm).
Vec3 scene_skin();

// A picture of footage and where everything really was.
struct FootageFrame {
  std::string file;                    // within the folder
  double time = 0.0;                   // s
  std::vector<Pose> camera_from_body;  // truth, in the order of the bodies; empty for footage of a real camera
};

// Footage in a folder: pictures, and for a rendered one camera, bodies and truth.
struct Footage {
  std::filesystem::path folder;
  std::vector<FootageFrame> frames;
  std::vector<std::string> bodies;  // names, in the order of the poses
};

// Renders the scene into a folder: frame_00000.png and so on, camera.json, bodies.json and scene.json with the truth.
// Throws InputError when the folder exists and is not empty.
Footage render_scene(const std::filesystem::path& folder, const SceneOptions& options, const Progress& progress = {});

// A folder of pictures (.png, .jpg, .jpeg) as a source. With scene.json in it times and truth come from there;
// without, pictures come in the order of their names, `rate` a second. Throws InputError when there is no picture.
Footage open_footage(const std::filesystem::path& folder, double rate = 30.0);

// A picture of footage. Throws InputError naming the file.
imaging::ImageRgb read_picture(const std::filesystem::path& file);

}  // namespace bodkin::tracking
