#include "cli/footage_options.h"

#include <filesystem>

#include "tracking/marker_search.h"
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::cli {

namespace fs = std::filesystem;

void add_footage_options(CLI::App& command, FootageArguments& arguments) {
  add_text(command, "FOOTAGE", arguments.folder, "Folder of pictures (.png, .jpg)").required();
  add_text(command, "--camera", arguments.camera, "Calibration of the camera (default: camera.json in the folder)");
  add_text(command, "--bodies", arguments.bodies, "Marker bodies (default: bodies.json in the folder)");
  add_number(command, "--rate", arguments.rate, 1.0, 1000.0, "Pictures/s, where the footage does not say, 1 to 1000");
}

OpenedFootage open_footage_of(const FootageArguments& arguments) {
  OpenedFootage opened;
  opened.footage = tracking::open_footage(arguments.folder, arguments.rate);
  const fs::path camera =
      arguments.camera.empty() ? fs::path(arguments.folder) / "camera.json" : fs::path(arguments.camera);
  const fs::path bodies =
      arguments.bodies.empty() ? fs::path(arguments.folder) / "bodies.json" : fs::path(arguments.bodies);
  std::error_code code;
  if (arguments.camera.empty() && !fs::exists(camera, code)) {
    throw InputError(fmt::format(
        "{}: the camera of this footage is not calibrated; name its calibration with --camera", arguments.folder));
  }
  opened.camera = tracking::read_camera(camera);
  opened.bodies = tracking::read_bodies(bodies);
  return opened;
}

std::string why_nothing_was_found(const tracking::Footage& footage) {
  const auto picture = tracking::grey_of(tracking::read_picture(footage.folder / footage.frames.front().file));
  return tracking::is_mirrored(picture)
             ? fmt::format("{}: the pictures are mirrored left to right; switch mirroring off in the camera",
                           footage.folder.string())
             : fmt::format(
                   "{}: no marker of the dictionary 4x4_50 is in these pictures; print the markers with "
                   "'bodkin markers --pdf' and keep them in view",
                   footage.folder.string());
}

}  // namespace bodkin::cli
