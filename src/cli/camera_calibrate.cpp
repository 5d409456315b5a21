#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "tracking/calibration_texts.h"
#include "tracking/camera_calibration.h"
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/footage_options.h"
#include "cli/tracking_commands.h"
#include "core/error.h"
#include "core/files.h"

namespace bodkin::cli {

namespace {

struct CameraCalibrateArguments {
  FootageArguments footage;
  std::string output = "camera.json";
  double square = tracking::CalibrationBoard{}.square;
  std::int64_t pictures = 30, width = 1280, height = 720;
};

constexpr const char* camera_calibrate_footer = R"(Examples:
  bodkin camera board board.pdf                             print it, glue it flat, measure a square
  bodkin camera calibrate /dev/video0 -o camera.json        hold the board still at 30 places, tilted
  bodkin camera calibrate pictures -o camera.json           a folder of single pictures
  bodkin camera calibrate video.mp4 --square 25.9 -o camera.json

From a camera or a video, a picture is used only while the board rests at a place that was not seen before. Focus,
exposure, gain and white balance of a camera are locked and stored, because another focus would be another lens. See
docs/augmented-reality.md.)";

void run_camera_calibrate(const CameraCalibrateArguments& arguments, const CommandContext& context) {
  require_writable(arguments.output, "--output");
  Console console(context);
  tracking::SourceOptions of_source;
  of_source.rate = arguments.footage.rate;
  of_source.width = static_cast<int>(arguments.width);
  of_source.height = static_cast<int>(arguments.height);
  const auto source = tracking::open_source(arguments.footage.source, of_source);
  tracking::CalibrationBoard board;
  board.square = arguments.square;
  tracking::CalibrationOptions options;
  std::error_code code;
  options.in_motion = !std::filesystem::is_directory(arguments.footage.source, code);
  options.most_pictures = static_cast<int>(arguments.pictures);
  tracking::CameraCalibration calibration(board, options);
  tracking::CalibrationTexts words;
  std::map<tracking::PictureUse, int> uses;
  tracking::GreyImage last;
  bool saw_corners = false;
  for_each_picture(*source, arguments.footage, console, "pictures", [&](const tracking::SourcePicture& frame) {
    const tracking::PictureUse use = calibration.add(frame.grey);
    ++uses[use];
    saw_corners = saw_corners || use != tracking::PictureUse::few_corners;
    if (!saw_corners) last = frame.grey;
    if (source->live() && use == tracking::PictureUse::kept) {
      const std::string advice = calibration.advice();
      console.line(fmt::format("picture {} of {}: {:.0f} % of the view seen{}", calibration.kept(),
                               arguments.pictures, 100.0 * calibration.coverage(),
                               advice.empty() ? "" : "; " + advice));
    }
    if (source->live()) {
      if (const std::string why = words.of(use, frame.time); !why.empty()) console.line(why);
    }
    return !source->live() || calibration.kept() < arguments.pictures;
  });
  if (!saw_corners && last.width > 0 && tracking::is_mirrored(last))
    throw InputError(tracking::why_nothing_was_found(arguments.footage.source, last));
  if (!saw_corners) {
    throw InputError(fmt::format("{}: no picture shows the board of 'bodkin camera board' with 12 corners or more",
                                 arguments.footage.source));
  }
  tracking::CalibratedCamera made = calibration.solve();
  made.camera.controls = source->controls();
  write_file(arguments.output, tracking::camera_json(made.camera));
  const tracking::CameraModel& camera = made.camera;
  console.line(
      fmt::format("{} pictures used, {} refused because they fit badly, {} with the board moving, {} with too few "
                  "corners, {} seen already",
                  made.pictures, made.refused, uses[tracking::PictureUse::moving],
                  uses[tracking::PictureUse::few_corners], uses[tracking::PictureUse::seen_already]));
  console.line(fmt::format(
      "lens: fx {:.1f} (±{:.1f}), fy {:.1f}, centre {:.1f}, {:.1f} (±{:.1f}), residual {:.3f} px", camera.fx,
      made.focal_deviation, camera.fy, camera.cx, camera.cy, made.centre_deviation, made.residual));
  console.line(fmt::format("light: {}, blur {:.2f} px, residual {:.3f} of the step from black to white",
                           camera.tone.exponent <= 0.0 ? std::string("sRGB curve")
                                                       : fmt::format("exponent {:.2f}, contrast {:.2f}",
                                                                     camera.tone.exponent, camera.tone.contrast),
                           camera.blur, made.light_residual));
  if (const std::string advice = calibration.advice(); !advice.empty())
    console.note("the calibration would be better with more: " + advice);
  console.json(nlohmann::ordered_json{{"output", arguments.output},
                                      {"pictures", made.pictures},
                                      {"refused", made.refused},
                                      {"moving", uses[tracking::PictureUse::moving]},
                                      {"coverage", calibration.coverage()},
                                      {"residual_px", made.residual},
                                      {"fx_deviation_px", made.focal_deviation},
                                      {"light_residual", made.light_residual}}
                   .dump(2));
}

}  // namespace

void add_camera_calibrate_command(CLI::App& camera_group, CommandContext& context) {
  add_command(camera_group, "calibrate", "Find lens, tone curve and blur of a camera", camera_calibrate_footer,
              [&context](CLI::App& command) {
                auto arguments = std::make_shared<CameraCalibrateArguments>();
                add_source_options(command, arguments->footage);
                add_text(command, "-o,--output", arguments->output, "File for the camera (JSON)");
                add_number(command, "--square", arguments->square, 5.0, 200.0,
                           "Edge of a square as it was printed, mm, 5 to 200");
                add_whole_number(command, "--pictures", arguments->pictures, 10, 100, "Pictures to keep, 10 to 100");
                add_whole_number(command, "--width", arguments->width, 160, 3840,
                                 "Width to request from a camera, pixels, 160 to 3840");
                add_whole_number(command, "--height", arguments->height, 120, 2160,
                                 "Height to request from a camera, pixels, 120 to 2160");
                on_run(command, [arguments, &context] { run_camera_calibrate(*arguments, context); });
              });
}

}  // namespace bodkin::cli
