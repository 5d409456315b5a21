#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "tracking/footage_scene.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/tracking_commands.h"
#include "core/error.h"
#include "io/case_folder.h"

namespace bodkin::cli {

namespace {

struct SceneRenderArguments {
  std::string folder, tone = "srgb";
  std::int64_t frames = 60, width = 1280, height = 720, seed = 1, quality = 85;
  double rate = 30.0, blur = 0.7, motion = 0.0, occlusion = 0.0, noise = 1.0, sharpening = 0.0;
  bool still = false;
  std::string patient;
  double aside = 0.0;
};

constexpr const char* scene_render_footer = R"(Examples:
  bodkin scene render footage                              two seconds of a needle, a probe and a mannequin
  bodkin scene render footage --frames 300 --motion 4      with motion blur of 4 pixels
  bodkin scene render footage --tone other --occlusion 0.3 another tone curve, fingers over the markers
  bodkin scene render attempt --case patient               a needle that goes along the patient's planned path
  bodkin track footage                                     how well they are tracked, compared with the true poses

The folder gets pictures, camera.json, bodies.json and scene.json, which holds the true poses of every picture.
docs/augmented-reality.md describes them.)";

tracking::ToneCurve tone_of(const std::string& name) {
  if (name == "srgb") return {};
  if (name == "linear") return {1.0, 0.0};
  if (name == "other") return {1.8, 0.3};
  throw InputError(
      fmt::format("--tone is '{}'; expected srgb, linear or other (an S-curve upon an exponent of 1/1.8)", name));
}

void run_scene_render(const SceneRenderArguments& arguments, const CommandContext& context) {
  Console console(context);
  tracking::SceneOptions options;
  options.frames = static_cast<int>(arguments.frames);
  options.rate = arguments.rate;
  options.width = static_cast<int>(arguments.width);
  options.height = static_cast<int>(arguments.height);
  options.seed = static_cast<std::uint64_t>(arguments.seed);
  options.tone = tone_of(arguments.tone);
  options.blur = arguments.blur;
  options.motion = arguments.motion;
  options.still = arguments.still;
  if (!arguments.patient.empty()) {
    const std::optional<anatomy::NeedlePath> path = io::read_case_description(arguments.patient).procedure.path;
    if (!path)
      throw InputError(
          fmt::format("{}: the case has no planned path; plan one with 'bodkin case plan'", arguments.patient));
    options.path = path->length();
    options.aside = arguments.aside;
    options.frames = static_cast<int>(std::ceil(tracking::motion_duration(options) * options.rate));
  } else if (arguments.aside != 0.0) {
    throw InputError("--aside needs a needle on a planned path; add --case CASE");
  }
  options.look.occlusion = arguments.occlusion;
  options.look.shot_noise *= arguments.noise;
  options.look.read_noise *= arguments.noise;
  options.look.sharpening = arguments.sharpening;
  options.look.jpeg_quality = static_cast<int>(arguments.quality);
  const tracking::Footage footage = tracking::render_scene(arguments.folder, options, console.progress());
  console.clear_bar();
  console.line(fmt::format("{}: {} pictures of {} x {}, with camera, bodies and truth", arguments.folder,
                           footage.frames.size(), options.width, options.height));
  console.json(nlohmann::ordered_json{{"folder", arguments.folder}, {"pictures", footage.frames.size()}}.dump(2));
}

}  // namespace

void add_scene_render_command(CLI::App& scene_group, CommandContext& context) {
  add_command(
      scene_group, "render", "Make footage of a tracked mannequin with known poses", scene_render_footer,
      [&context](CLI::App& command) {
        auto arguments = std::make_shared<SceneRenderArguments>();
        add_text(command, "DIR", arguments->folder, "New folder of the footage").required();
        add_whole_number(command, "--frames", arguments->frames, 1, 100000, "Pictures, 1 to 100000");
        add_text(command, "--case", arguments->patient,
                 "Case whose planned path the needle goes along, in as many pictures as that takes (--frames has no "
                 "effect)");
        add_number(command, "--aside", arguments->aside, -50.0, 50.0,
                   "With --case: distance of the needle from the path, towards the mannequin's x, mm, -50 to 50");
        add_number(command, "--rate", arguments->rate, 1.0, 240.0, "Pictures/s, 1 to 240");
        add_whole_number(command, "--width", arguments->width, 160, 3840, "Pixels, 160 to 3840");
        add_whole_number(command, "--height", arguments->height, 120, 2160, "Pixels, 120 to 2160");
        add_whole_number(command, "--seed", arguments->seed, 0, 1000000000, "Variation of places and noise");
        add_text(command, "--tone", arguments->tone, "Tone curve of the camera: srgb, linear or other");
        add_number(command, "--blur", arguments->blur, 0.2, 10.0,
                   "Blur of the lens, standard deviation in pixels, 0.2 to 10");
        add_number(command, "--motion", arguments->motion, 0.0, 100.0,
                   "Pixels that the needle moves in an exposure, 0 to 100");
        add_number(command, "--noise", arguments->noise, 0.0, 20.0,
                   "Noise relative to that of a usual webcam, 0 to 20");
        add_number(command, "--sharpening", arguments->sharpening, 0.0, 2.0, "Sharpening within the camera, 0 to 2");
        add_number(command, "--occlusion", arguments->occlusion, 0.0, 0.9,
                   "Share of a body that fingers hide, 0 to 0.9");
        add_whole_number(command, "--jpeg", arguments->quality, 0, 100, "Quality of the camera's JPEG, 0: none");
        add_switch(command, "--still", arguments->still, "Nothing moves");
        on_run(command, [arguments, &context] { run_scene_render(*arguments, context); });
      });
}

}  // namespace bodkin::cli
