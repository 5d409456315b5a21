#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "tracking/pivot_calibration.h"
#include "tracking/tracker.h"
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

struct MarkersPivotArguments {
  FootageArguments footage;
  std::string body, output;
  bool spin = false;
};

constexpr const char* markers_pivot_footer = R"(Examples:
  bodkin markers pivot /dev/video0 --seconds 20 --camera camera.json --body needle -o bodies.json
  bodkin markers pivot spun --spin --camera camera.json --bodies bodies.json --body needle -o bodies.json

To find the tip, rest it in a dimple and tilt the body slowly in all directions. To find the axis, turn the body about its
own axis, like a needle in a tube, and give --spin. Camera and dimple must not move. See docs/augmented-reality.md.)";

void run_markers_pivot(const MarkersPivotArguments& arguments, const CommandContext& context) {
  require_writable(arguments.output, "--output", arguments.footage.bodies);
  Console console(context);
  tracking::OpenedFootage opened = open_footage_of(arguments.footage);
  const auto body = std::find_if(opened.bodies.begin(), opened.bodies.end(),
                                 [&](const tracking::MarkerBody& one) { return one.name == arguments.body; });
  if (body == opened.bodies.end()) {
    throw InputError(fmt::format("--body is '{}'; there is no body of that name", arguments.body));
  }
  tracking::Tracker tracker(opened.camera, {*body});
  std::vector<tracking::TimedPose> poses;
  int pictures = 0;
  for_each_picture(*opened.source, arguments.footage, console, "pictures", [&](const tracking::SourcePicture& frame) {
    const tracking::TrackedPose& pose = tracker.track(frame.grey, frame.time).front();
    if (pose.status == tracking::TrackingStatus::ok) poses.push_back({frame.time, pose.camera_from_body});
    ++pictures;
    return true;
  });
  console.line(fmt::format("{} is tracked well in {} of {} pictures", body->name, poses.size(), pictures));
  nlohmann::ordered_json json;
  if (arguments.spin) {
    const tracking::SpinCalibration made = tracking::calibrate_spin(poses);
    body->axis = made.axis;
    console.line(
        fmt::format("axis {:.4f} {:.4f} {:.4f}: residual {:.2f} deg RMS, {:.2f} deg in the mean, spun by {:.0f} "
                    "deg; {} poses, {} too fast, {} outliers",
                    made.axis.x(), made.axis.y(), made.axis.z(), made.rms, made.mean, made.turned, made.used,
                    made.too_fast, made.outliers));
    json = {{"axis", {made.axis.x(), made.axis.y(), made.axis.z()}},
            {"rms_deg", made.rms},
            {"mean_deg", made.mean},
            {"poses", made.used},
            {"too_fast", made.too_fast},
            {"outliers", made.outliers}};
  } else {
    const tracking::PivotCalibration made = tracking::calibrate_pivot(poses);
    body->tip = made.tip;
    console.line(
        fmt::format("tip {:.2f} {:.2f} {:.2f} mm (±{:.2f}): residual {:.2f} mm RMS, {:.2f} mm in the mean, tilted by "
                    "{:.0f} deg; {} poses, {} too fast, {} outliers",
                    made.tip.x(), made.tip.y(), made.tip.z(), made.deviation, made.rms, made.mean, made.cone,
                    made.used, made.too_fast, made.outliers));
    json = {{"tip_mm", {made.tip.x(), made.tip.y(), made.tip.z()}},
            {"deviation_mm", made.deviation},
            {"rms_mm", made.rms},
            {"mean_mm", made.mean},
            {"poses", made.used},
            {"too_fast", made.too_fast},
            {"outliers", made.outliers}};
  }
  write_file(arguments.output, tracking::bodies_json(opened.bodies));
  console.json(json.dump(2));
}

}  // namespace

void add_markers_pivot_command(CLI::App& markers_group, CommandContext& context) {
  add_command(markers_group, "pivot", "Measure the tip or the axis of a marker body", markers_pivot_footer,
              [&context](CLI::App& command) {
                auto arguments = std::make_shared<MarkersPivotArguments>();
                add_footage_options(command, arguments->footage);
                add_text(command, "--body", arguments->body, "Name of the body").required();
                add_switch(command, "--spin", arguments->spin, "The body was spun about its axis; measure that axis");
                add_text(command, "-o,--output", arguments->output, "File for all bodies, this one calibrated (JSON)")
                    .required();
                on_run(command, [arguments, &context] { run_markers_pivot(*arguments, context); });
              });
}

}  // namespace bodkin::cli
