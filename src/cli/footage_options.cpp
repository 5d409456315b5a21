#include "cli/footage_options.h"

#include <algorithm>
#include <optional>

#include "cli/end_on_signal.h"

namespace bodkin::cli {

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

tracking::OpenedFootage open_footage_of(const FootageArguments& arguments) {
  return tracking::open_footage_files({arguments.source, arguments.camera, arguments.bodies, arguments.rate});
}

void for_each_picture(tracking::PictureSource& source, const FootageArguments& arguments, Console& console,
                      const std::string& what, const std::function<bool(tracking::SourcePicture&)>& take) {
  const EndOnSignal ends;
  const Progress progress = console.progress();
  std::optional<double> first;
  double span = 0.0;
  for (int n = 0; EndOnSignal::signal() == 0; ++n) {
    const double share = !source.live()            ? static_cast<double>(n) / source.count()
                         : arguments.seconds > 0.0 ? std::min(1.0, span / arguments.seconds)
                                                   : 0.0;
    if (progress) progress(what.c_str(), share);
    std::optional<tracking::SourcePicture> picture = source.next();
    if (!picture) break;
    if (!first) first = picture->time;
    span = picture->time - *first;
    if (arguments.seconds > 0.0 && span >= arguments.seconds) break;
    if (!take(*picture)) break;
  }
  console.clear_bar();
  for (const std::string& note : source.notes()) console.note(note);
}

}  // namespace bodkin::cli
