#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tracking/augmented_view.h"
#include "tracking/footage_scene.h"
#include "tracking/lens_watch.h"
#include "tracking/registration_file.h"
#include "tracking/tracker.h"
#include "tracking/video_file.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/footage_options.h"
#include "cli/tracking_commands.h"
#include "core/error.h"
#include "core/files.h"
#include "imaging/png_file.h"
#include "io/case_folder.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

struct OverlayArguments {
  std::string patient, output = "overlay.avi", registration, preset = "soft_tissue", region;
  FootageArguments footage;
  double oval_width = 300.0, oval_height = 370.0, threshold = 0.7, step = 1.0;
  bool no_needle = false, no_plan = false, no_front_view = false, no_status = false;
};

constexpr const char* overlay_footer = R"(Examples:
  bodkin case synthesize lumbar patient
  bodkin scene render footage
  bodkin overlay patient footage                           overlay.avi: the patient within the mannequin
  bodkin overlay patient footage -o pictures               the same as a folder of pictures
  bodkin overlay patient footage --registration registration.json --preset bone
  bodkin overlay patient /dev/video0 --camera camera.json --seconds 60    a minute of a live camera

Every picture is drawn with its own poses. Without --registration the entry of the planned path lies where the mannequin's
back is in rendered footage. docs/augmented-reality.md says more.)";

tracking::AugmentedLook look_of(const OverlayArguments& arguments) {
  tracking::AugmentedLook look;
  look.radii = 0.5 * Eigen::Vector2d(arguments.oval_width, arguments.oval_height);
  look.threshold = arguments.threshold;
  look.step = arguments.step;
  look.needle = !arguments.no_needle;
  look.plan = !arguments.no_plan;
  look.front_view = !arguments.no_front_view;
  look.status = !arguments.no_status;
  if (!arguments.region.empty()) look.region = parse_point(arguments.region, "--region");
  const auto preset = std::find_if(imaging::transfer_presets.begin(), imaging::transfer_presets.end(),
                                   [&](imaging::TransferPreset one) { return name_of(one) == arguments.preset; });
  if (preset == imaging::transfer_presets.end()) {
    throw InputError(fmt::format("--preset is '{}'; expected bone, soft_tissue, skin or vessels", arguments.preset));
  }
  look.preset = *preset;
  return look;
}

void run_overlay(const OverlayArguments& arguments, const CommandContext& context) {
  const tracking::AugmentedLook look = look_of(arguments);
  const fs::path output = arguments.output;
  const bool video = output.extension() == ".avi";
  std::error_code code;
  if (video) {
    require_writable(output, "--output");
  } else if (fs::exists(output, code) && (!fs::is_directory(output, code) || !fs::is_empty(output, code))) {
    throw InputError(
        fmt::format("--output is '{}'; expected a file that ends in .avi, or a new folder", arguments.output));
  }
  Console console(context);
  tracking::OpenedFootage opened = open_footage_of(arguments.footage);
  const anatomy::Case patient = io::load_case(arguments.patient, console.progress());
  const tracking::Similarity place = arguments.registration.empty()
                                         ? tracking::placed_at(patient, tracking::scene_skin())
                                         : tracking::read_registration(arguments.registration).fixed_from_moving;
  const auto index_of = [&](std::string_view name) -> std::optional<std::size_t> {
    for (std::size_t i = 0; i < opened.bodies.size(); ++i) {
      if (opened.bodies[i].name == name) return i;
    }
    return std::nullopt;
  };
  const std::optional<std::size_t> mannequin = index_of("mannequin");
  if (!mannequin) {
    throw InputError(
        fmt::format("{}: no body is called \"mannequin\", which the patient is laid into", arguments.footage.source));
  }
  tracking::Tracker tracker(opened.camera, opened.bodies);
  tracking::AugmentedView view(patient, opened.camera, place, look);
  tracking::LensWatch lens;
  std::optional<tracking::VideoWriter> writer;
  if (video) writer.emplace(output, opened.camera.width, opened.camera.height, opened.source->rate());
  int drawn = 0, pictures = 0;
  tracking::GreyPicture last;
  std::string warning;
  for_each_picture(*opened.source, arguments.footage, console, "overlay", [&](const tracking::SourcePicture& frame) {
    const auto& poses = tracker.track(frame.grey, frame.time);
    lens.add(poses);
    if (warning.empty()) warning = lens.warning();
    std::vector<tracking::ShownBody> tools;
    for (std::size_t b = 0; b < poses.size(); ++b) {
      if (b != *mannequin) tools.push_back({&opened.bodies[b], &poses[b]});
    }
    imaging::ImageRgb picture = frame.colour;
    view.draw(picture, &poses[*mannequin], tools);
    if (poses[*mannequin].status == tracking::TrackingStatus::ok) ++drawn;
    if (drawn == 0 && tracker.markers().empty()) last = frame.grey;
    if (writer) {
      writer->add(picture);
    } else {
      write_file(output / fmt::format("overlay_{:05}.png", pictures), imaging::encode_png(picture));
    }
    ++pictures;
    return true;
  });
  if (writer) writer->finish();
  if (drawn == 0 && last.width > 0) console.note(tracking::why_nothing_was_found(arguments.footage.source, last));
  if (!warning.empty()) console.note(warning);
  console.line(fmt::format("{}: {} pictures, the patient in {} of them", arguments.output, pictures, drawn));
  console.json(
      nlohmann::ordered_json{{"output", arguments.output}, {"pictures", pictures}, {"drawn", drawn}}.dump(2));
}

}  // namespace

void add_overlay_command(CLI::App& app, CommandContext& context) {
  auto arguments = std::make_shared<OverlayArguments>();
  CLI::App* command =
      add_command(app, "overlay", "The patient's CT within the mannequin, over a camera's pictures", overlay_footer);
  add_text(*command, "CASE", arguments->patient, "Folder of the case").required();
  add_footage_options(*command, arguments->footage);
  add_text(*command, "-o,--output", arguments->output, "Video (.avi) or new folder of pictures");
  add_text(*command, "--registration", arguments->registration, "Patient to mannequin, from 'bodkin register'");
  add_text(*command, "--preset", arguments->preset, "What is seen: bone, soft_tissue, skin or vessels");
  add_text(*command, "--region", arguments->region, "Middle of the oval, LPS mm: x,y,z (default: the target)");
  add_number(*command, "--oval-width", arguments->oval_width, 20.0, 4000.0, "Pixels, 20 to 4000");
  add_number(*command, "--oval-height", arguments->oval_height, 20.0, 4000.0, "Pixels, 20 to 4000");
  add_number(*command, "--threshold", arguments->threshold, 0.0, 0.99,
             "Share of the radius that is opaque, 0 to 0.99");
  add_number(*command, "--step", arguments->step, 0.25, 8.0, "Voxels between samples of a ray, 0.25 to 8");
  add_switch(*command, "--no-needle", arguments->no_needle, "Leave out the needle");
  add_switch(*command, "--no-plan", arguments->no_plan, "Leave out the planned path");
  add_switch(*command, "--no-front-view", arguments->no_front_view, "Leave out the CT from the front");
  add_switch(*command, "--no-status", arguments->no_status, "Leave out the text");
  on_run(*command, [arguments, &context] { run_overlay(*arguments, context); });
}

}  // namespace bodkin::cli
