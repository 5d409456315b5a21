#include <algorithm>
#include <memory>
#include <string>

#include "tracking/body_calibration.h"
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

struct MarkersCalibrateArguments {
  FootageArguments footage;
  std::string body, output;
};

constexpr const char* markers_calibrate_footer = R"(Examples:
  bodkin markers calibrate pictures --body needle --camera camera.json --bodies bodies.json -o calibrated.json

Hold the folded body 300 to 500 mm in front of the camera and turn it slowly, so that two faces or more are seen; 100 to 200
pictures, or 20 seconds of /dev/video0, are enough. The size of the markers is not calibrated: measure the ruler on the
print. See docs/augmented-reality.md.)";

void run_markers_calibrate(const MarkersCalibrateArguments& arguments, const CommandContext& context) {
  if (arguments.output.empty()) throw InputError("--output is missing; expected a file for the calibrated bodies");
  require_writable(arguments.output, "--output", arguments.footage.bodies);
  Console console(context);
  tracking::OpenedFootage opened = open_footage_of(arguments.footage);
  const auto body = std::find_if(opened.bodies.begin(), opened.bodies.end(),
                                 [&](const tracking::MarkerBody& one) { return one.name == arguments.body; });
  if (body == opened.bodies.end()) {
    throw InputError(fmt::format("--body is '{}'; there is no body of that name", arguments.body));
  }
  tracking::BodyCalibration calibration(opened.camera, *body);
  int pictures = 0;
  for_each_picture(*opened.source, arguments.footage, console, "pictures", [&](const tracking::SourcePicture& frame) {
    calibration.add(frame.grey);
    ++pictures;
    return true;
  });
  const tracking::CalibratedBody made = calibration.solve();
  *body = made.body;
  write_file(arguments.output, tracking::bodies_json(opened.bodies));
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  console.line(fmt::format("{} of {} pictures show two faces or more", made.pictures, pictures));
  for (const tracking::CalibratedFace& face : made.faces) {
    console.line(fmt::format("marker {:<3} {} pictures, moved by {:.2f} mm (±{:.3f}) and {:.2f} deg (±{:.3f})",
                             face.id, face.pictures, face.moved, face.deviation, face.turned, face.angle_deviation));
    json.push_back({{"id", face.id},
                    {"pictures", face.pictures},
                    {"moved_mm", face.moved},
                    {"deviation_mm", face.deviation},
                    {"turned_deg", face.turned},
                    {"deviation_deg", face.angle_deviation}});
  }
  console.json(json.dump(2));
}

}  // namespace

void add_markers_calibrate_command(CLI::App& markers_group, CommandContext& context) {
  add_command(markers_group, "calibrate", "Measure where the faces of a folded marker body are",
              markers_calibrate_footer, [&context](CLI::App& command) {
                auto arguments = std::make_shared<MarkersCalibrateArguments>();
                add_footage_options(command, arguments->footage);
                add_text(command, "--body", arguments->body, "Name of the body").required();
                add_text(command, "-o,--output", arguments->output,
                         "File for all bodies, this one calibrated (JSON)");
                on_run(command, [arguments, &context] { run_markers_calibrate(*arguments, context); });
              });
}

}  // namespace bodkin::cli
