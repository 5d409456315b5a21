#include "cli/footage_options.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "tracking/marker_search.h"
#include <fmt/format.h>

#include "cli/end_on_signal.h"
#include "core/error.h"

namespace bodkin::cli {

namespace fs = std::filesystem;

void add_source_options(CLI::App& command, FootageArguments& arguments) {
  add_text(command, "FOOTAGE", arguments.source,
           "Folder of pictures (.png, .jpg), video file, or camera (/dev/video0)")
      .required();
  add_number(command, "--rate", arguments.rate, 1.0, 1000.0,
             "Pictures/s: of a folder that does not say, and asked of a camera; 1 to 1000");
  add_number(command, "--seconds", arguments.seconds, 0.0, 86400.0,
             "End after so much of the pictures, 0: at their end or Ctrl-C; 0 to 86400");
}

void add_footage_options(CLI::App& command, FootageArguments& arguments) {
  add_source_options(command, arguments);
  add_text(command, "--camera", arguments.camera, "Calibration of the camera (default: camera.json in the folder)");
  add_text(command, "--bodies", arguments.bodies,
           "Marker bodies (default: bodies.json in the folder; else those of 'bodkin markers')");
}

OpenedFootage open_footage_of(const FootageArguments& arguments) {
  OpenedFootage opened;
  std::error_code code;
  const fs::path source = arguments.source;
  const bool folder = fs::is_directory(source, code);
  tracking::SourceOptions options;
  options.rate = arguments.rate;
  if (!arguments.camera.empty()) {
    opened.camera = tracking::read_camera(arguments.camera);
    options.width = opened.camera.width;
    options.height = opened.camera.height;
    options.locks = opened.camera.controls;
  }
  if (!fs::exists(source, code) || folder || !arguments.camera.empty()) {
    opened.source = tracking::open_source(arguments.source, options);
  }
  if (arguments.camera.empty()) {
    if (!folder || !fs::exists(source / "camera.json", code)) {
      throw InputError(
          fmt::format("{}: its camera is not calibrated; calibrate it with 'bodkin camera calibrate' and "
                      "name the file with --camera",
                      arguments.source));
    }
    opened.camera = tracking::read_camera(source / "camera.json");
  }
  const fs::path in_folder = source / "bodies.json";
  opened.bodies = !arguments.bodies.empty()               ? tracking::read_bodies(arguments.bodies)
                  : folder && fs::exists(in_folder, code) ? tracking::read_bodies(in_folder)
                                                          : tracking::station_bodies();
  return opened;
}

void for_each_picture(tracking::PictureSource& source, const FootageArguments& arguments, Console& console,
                      const std::string& what, const std::function<bool(const tracking::SourcePicture&)>& take) {
  const EndOnSignal ends;
  const Progress progress = console.progress();
  std::optional<double> first;
  double span = 0.0;
  for (int n = 0; EndOnSignal::signal() == 0; ++n) {
    const double share = !source.live()            ? static_cast<double>(n) / source.count()
                         : arguments.seconds > 0.0 ? std::min(1.0, span / arguments.seconds)
                                                   : 0.0;
    if (progress) progress(what.c_str(), share);
    const std::optional<tracking::SourcePicture> picture = source.next();
    if (!picture) break;
    if (!first) first = picture->time;
    span = picture->time - *first;
    if (arguments.seconds > 0.0 && span >= arguments.seconds) break;
    if (!take(*picture)) break;
  }
  console.clear_bar();
  for (const std::string& note : source.notes()) console.note(note);
}

std::string why_nothing_was_found(const std::string& source, const tracking::GreyPicture& picture) {
  return tracking::is_mirrored(picture)
             ? fmt::format("{}: the pictures are mirrored left to right; switch mirroring off in the camera", source)
             : fmt::format(
                   "{}: no marker of the dictionary 4x4_50 is in these pictures; print the markers with "
                   "'bodkin markers --pdf' and keep them in view",
                   source);
}

}  // namespace bodkin::cli
