#pragma once

#include <string>
#include <vector>

#include "tracking/camera_model.h"
#include "tracking/footage_scene.h"
#include "tracking/marker_body.h"

#include "cli/arguments.h"

namespace bodkin::cli {

// Footage, its camera and the bodies in it as the command line gives them.
struct FootageArguments {
  std::string folder, camera, bodies;
  double rate = 30.0;
};

void add_footage_options(CLI::App& command, FootageArguments& arguments);

struct OpenedFootage {
  tracking::Footage footage;
  tracking::CameraModel camera;
  std::vector<tracking::MarkerBody> bodies;
};

// camera.json and bodies.json of the footage's folder stand in for files that are not named. Throws InputError.
OpenedFootage open_footage_of(const FootageArguments& arguments);

// One sentence when a whole footage showed no marker at all: the wrong dictionary, or a picture that is mirrored.
std::string why_nothing_was_found(const tracking::Footage& footage);

}  // namespace bodkin::cli
