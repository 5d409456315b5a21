#include "imaging/ultrasound/ultrasound.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/app_window.h"
#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/json_values.h"
#include "cli/ultrasound_deformed.h"
#include "cli/ultrasound_options.h"
#include "cli/ultrasound_reference.h"
#include "cli/ultrasound_sweep.h"
#include "core/error.h"
#include "core/files.h"
#include "imaging/png_file.h"
#include "imaging/ultrasound_screen/scanner_image.h"
#include "io/case_folder.h"

namespace bodkin::cli {

namespace {

namespace fs = std::filesystem;

struct UltrasoundArguments {
  std::string folder, output;
  UltrasoundOptions options;
  SweepOptions sweep;
  ReferenceOptions reference;
  bool plain = false, ct = false, live = false, deformed = false;
};

constexpr const char* ultrasound_footer = R"(Examples:
  bodkin ultrasound patient                                  next to the midline, towards the planned target
  bodkin ultrasound patient --view transverse --at L3_L4 --ct                with the CT in the same plane
  bodkin ultrasound patient --at kidney_left --from left --depth 140 -o kidney.png
  bodkin ultrasound patient --probe L14-5 --view needle --needle --needle-depth 40
  bodkin ultrasound patient --view needle --needle --deformed                the tissue as the needle moves it
  bodkin ultrasound patient --face 15,92,10 --look=-0.1,-1,0 --marked 0,0,1 --press 4
  bodkin ultrasound patient --tilt=-20,20 --frames 80 -o fan.igs.mha         a tracked sequence for 3D Slicer
  bodkin ultrasound patient --sweep-to 15,92,60 --on-skin -o sweep.mp4       a video (needs ffmpeg)
  bodkin ultrasound patient --sweep poses.csv -o frames                      a folder of pictures
  bodkin ultrasound patient --probe L14-5 --beside real.mha:3 --beside-pixel 0.08   a real picture next to it
  bodkin ultrasound patient --live                                           the probe in your hand, in a window

Coordinates are LPS, mm. A value that starts with a minus sign needs an equals sign: --at=-5,95,3)";

// A case's name as the beginning of a file name.
std::string scan_file_name(const std::string& name) {
  std::string safe;
  for (const char c : name) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    safe += plain ? c : '_';
  }
  return (safe.empty() ? "case" : safe) + "-ultrasound";
}

std::string needle_words(const imaging::NeedleInUltrasound& needle, const anatomy::NeedlePath& path) {
  const double depth = path.direction().dot(needle.pose.translation() - path.entry);
  return fmt::format("{} G {:.0f} mm", needle.needle.gauge, depth);
}

// All errors of the command line are reported before a file is opened.
void check_combinations(const UltrasoundArguments& arguments) {
  const SweepOptions& sweep = arguments.sweep;
  if (arguments.live && (sweep.any() || arguments.plain || arguments.ct)) {
    throw InputError("--live opens a window; leave out --plain, --ct and the options of a sweep");
  }
  if (arguments.reference.any() && (arguments.live || sweep.any() || arguments.plain)) {
    throw InputError("--beside is for a single picture; leave out --live, --plain and the options of a sweep");
  }
  if (!arguments.reference.any() && arguments.reference.more()) {
    throw InputError(
        "--beside-pixel, --beside-crop, --beside-window and --window are for a real picture; add --beside FILE");
  }
  if (arguments.plain && arguments.ct) throw InputError("--plain writes the pixels alone; leave out --ct");
  const bool motion = !sweep.to.empty() || !sweep.tilt.empty() || !sweep.rock.empty() || !sweep.rotate.empty();
  if (!sweep.file.empty() && (motion || sweep.frames_given.given() || sweep.on_skin)) {
    throw InputError(
        "--sweep takes its poses from the file; leave out --sweep-to, --on-skin, --tilt, --rock, --rotate and "
        "--frames");
  }
  if (sweep.on_skin && sweep.to.empty())
    throw InputError("--on-skin needs the motion of --sweep-to, which is missing");
  if (!sweep.any() && (sweep.frames_given.given() || sweep.rate_given.given())) {
    throw InputError(
        "--frames and --rate belong to a sweep; describe it with --sweep-to, --tilt, --rock or --rotate");
  }
  if (arguments.deformed && !arguments.options.wanted.needle)
    throw InputError("--deformed needs a needle; add --needle");
  if (arguments.deformed && (arguments.live || sweep.any())) {
    throw InputError("--deformed is for a single picture; leave out --live and the options of a sweep");
  }
  if (arguments.deformed && arguments.options.press_given.given() && arguments.options.press > 0.0) {
    throw InputError("--deformed shows what the needle does to tissue, not the probe; leave out --press");
  }
  if (arguments.options.needle_depth_given.given() && !arguments.options.wanted.needle) {
    throw InputError("--needle-depth is the depth of a needle; add --needle");
  }
}

void check_picture_name(const UltrasoundArguments& arguments) {
  if (arguments.output.empty()) return;
  const fs::path file(arguments.output);
  const bool drawing = file.extension() == ".svg" && !arguments.plain;
  if (file.extension() != ".png" && !drawing) {
    throw InputError(fmt::format("--output is '{}'; expected a picture, .png{}", arguments.output,
                                 arguments.plain ? "" : " or .svg"));
  }
  require_writable(file, "--output");
}

// Matrix from pixels of the written image to LPS mm: column, row, 0, 1.
nlohmann::json image_to_patient(const imaging::SlicePlane& plane) {
  nlohmann::json rows = nlohmann::json::array();
  const Vec3 across = plane.pixel * plane.right, down = plane.pixel * plane.down;
  const Vec3 through = plane.pixel * plane.normal();
  for (int row = 0; row < 3; ++row) rows.push_back({across[row], down[row], through[row], plane.corner[row]});
  rows.push_back({0, 0, 0, 1});
  return rows;
}

nlohmann::json json_of(const station::UltrasoundChoice& choice) {
  const imaging::UltrasoundSettings& set = choice.settings;
  return {{"probe", choice.probe.name},
          {"frequency_MHz", set.frequency > 0.0 ? set.frequency : choice.probe.frequency},
          {"depth_mm", set.depth},
          {"gain_dB", set.gain},
          {"dynamic_range_dB", set.dynamic_range},
          {"focus_mm", set.focus},
          {"tgc_dB", set.sliders},
          {"gel", set.gel},
          {"lines", choice.detail.lines},
          {"samples", choice.detail.samples},
          {"size", {choice.detail.width, choice.detail.height}},
          {"slices", choice.detail.slices}};
}

struct ScanScene {
  const anatomy::Case& patient;
  const station::UltrasoundChoice& choice;
  Pose pose;
  std::optional<imaging::NeedleInUltrasound> needle;
  std::string needle_words;
  std::optional<DeformedScan> deformed;
  std::optional<imaging::ReferenceImage> real;
};

nlohmann::json json_of(const imaging::GreyWindow& window, const imaging::GreyStatistics& greys) {
  const auto width = [](const std::optional<double>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
  };
  return {{"window_mm", {window.across, window.depth, window.width, window.height}},
          {"grey_percentiles", greys.percentiles},
          {"half_width_across_mm", width(greys.across)},
          {"half_width_along_mm", width(greys.along)}};
}

void scan_once(const UltrasoundArguments& arguments, const ScanScene& scene, imaging::Ultrasound& machine,
               Console& console) {
  const station::UltrasoundChoice& choice = scene.choice;
  const std::optional<imaging::ScanDisplacement> moved =
      scene.deformed ? std::optional(scene.deformed->field()) : std::nullopt;
  machine.image(scene.pose, scene.needle, moved);  // the first one takes memory
  const auto begin = std::chrono::steady_clock::now();
  const imaging::UltrasoundFrame& frame = machine.image(scene.pose, scene.needle, moved);
  const double milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  if (frame.why != imaging::NoImage::none) console.note(imaging::reason(frame.why));

  const fs::path file = arguments.output.empty() ? fs::path(scan_file_name(scene.patient.description.name) + ".png")
                                                 : fs::path(arguments.output);
  imaging::ScannerImage picture;
  picture.moment = {frame, scene.pose, choice.probe, choice.settings, scene.needle_words};
  picture.mark = choice.mark;
  picture.patient = scene.patient.description.name;
  std::optional<GreyComparison> compared;
  if (scene.real) {
    compared = compare_greys(arguments.reference, imaging::grey_of(frame, choice.mark), scene.real->picture);
    picture.reference = scene.real;
    picture.window = {compared->simulated_window, statistics_words(compared->simulated)};
    picture.reference->window = {compared->real_window, statistics_words(compared->real)};
  }
  if (arguments.plain) {
    write_file(file, imaging::encode_png(imaging::grey_image(frame, choice.mark)));
  } else {
    if (arguments.ct) {
      std::vector<Vec3> needle;
      if (scene.needle) {
        needle = {scene.patient.description.procedure.path->entry, scene.needle->pose.translation()};
      }
      picture.ct = imaging::ct_panel(scene.patient, picture.moment, choice.mark, needle);
    }
    const imaging::Canvas drawn = imaging::draw_scanner_image(picture, scene.patient.library);
    write_file(file, file.extension() == ".svg" ? drawn.svg() : drawn.png(1.0));
  }

  const Vec3 face = scene.pose.translation(), look = scene.pose.linear().col(1);
  console.line(fmt::format("probe     {}, {}", choice.probe.name, choice.probe.title));
  console.line(fmt::format("face      {:.1f}, {:.1f}, {:.1f} (LPS mm), looking to {}, marked side to {}", face.x(),
                           face.y(), face.z(), imaging::direction_letters(look),
                           imaging::direction_letters(scene.pose.linear().col(0))));
  if (frame.why == imaging::NoImage::none) {
    console.line(fmt::format("contact   {:.0f} %, pressed in {:.1f} mm", 100.0 * frame.contact, frame.press));
  } else {
    console.line(fmt::format("no image  {}", imaging::reason(frame.why)));
  }
  if (scene.deformed) {
    console.line(fmt::format("tissue    moved {:.2f} mm at most in this plane, {:.2f} N on the needle",
                             scene.deformed->most, scene.deformed->force));
  }
  if (compared) {
    for (const auto& [which, greys] :
         {std::pair("simulated", &compared->simulated), std::pair("real", &compared->real)}) {
      for (const std::string& line : statistics_words(*greys)) console.line(fmt::format("{:<10}{}", which, line));
    }
  }
  console.line(fmt::format("time      {:.2f} ms a picture", milliseconds));
  console.line(fmt::format("again     --pose={}", station::pose_text(scene.pose)));
  console.line(fmt::format("\n{}", fs::absolute(file).string()));
  nlohmann::json result = json_of(choice);
  result["picture"] = fs::absolute(file).string();
  result["face_mm"] = json_point(face);
  result["pose"] = station::pose_text(scene.pose);
  result["pixel_mm"] = frame.pixel;
  result["image_to_patient"] = image_to_patient(imaging::plane_of(frame, scene.pose, choice.mark));
  result["contact"] = frame.contact;
  result["press_mm"] = frame.press;
  result["no_image"] = std::string(imaging::reason(frame.why));
  if (scene.deformed) {
    result["tissue_moved_mm"] = scene.deformed->most;
    result["needle_force_N"] = scene.deformed->force;
  }
  if (compared) {
    result["beside"] = {{"picture", scene.real->caption},
                        {"pixel_mm", scene.real->picture.pixel},
                        {"simulated", json_of(compared->simulated_window, compared->simulated)},
                        {"real", json_of(compared->real_window, compared->real)}};
  }
  result["milliseconds"] = milliseconds;
  console.json(result.dump(2));
}

void scan_sweep(const UltrasoundArguments& arguments, const ScanScene& scene, std::vector<imaging::SweepPose> poses,
                const SweepTarget& target, imaging::Ultrasound& machine, Console& console) {
  SweepScene sweep;
  sweep.patient = &scene.patient;
  sweep.choice = &scene.choice;
  if (poses.empty()) poses = imaging::sweep_of(scene.pose, motion_of(arguments.sweep), scene.patient.tissues);
  sweep.poses = std::move(poses);
  sweep.needle = scene.needle;
  sweep.needle_words = scene.needle_words;
  sweep.plain = arguments.plain;
  sweep.ct = arguments.ct;
  sweep.rate = arguments.sweep.rate;
  const SweepMade made = write_sweep(sweep, machine, target, console.progress());
  if (made.black > 0) {
    console.note(fmt::format("{} of {} frames have no picture: {}", made.black, sweep.poses.size(), made.why));
  }
  console.line(
      fmt::format("{} frames, {:.2f} s", sweep.poses.size(), sweep.poses.back().time - sweep.poses.front().time));
  const std::string first = fs::absolute(made.files.front()).string();
  console.line(made.files.size() > 1 ? fmt::format("\n{}\nto {}", first, fs::absolute(made.files.back()).string())
                                     : "\n" + first);
  nlohmann::json result = json_of(scene.choice);
  result["frames"] = sweep.poses.size();
  result["frames_without_image"] = made.black;
  result["files"] = nlohmann::json::array();
  for (const std::string& file : made.files) result["files"].push_back(fs::absolute(file).string());
  console.json(result.dump(2));
}

// In the window of bodkin-app. A folder without a case is refused here, in one sentence.
[[noreturn]] void show_live(const UltrasoundArguments& arguments, const station::UltrasoundRequest& request) {
  require_window();
  io::read_case_description(arguments.folder);
  const std::string base = fs::path(arguments.output).replace_extension().string();
  std::vector<std::string> words = {"--scan", station::to_json(request)};
  if (!base.empty()) words.insert(words.end(), {"--output", fs::absolute(base).string()});
  words.insert(words.end(), {"--", arguments.folder});
  exec_app(words);
}

void run_ultrasound(const UltrasoundArguments& arguments, const CommandContext& context) {
  Console console(context);
  check_combinations(arguments);
  const station::UltrasoundRequest request = request_of(arguments.options);
  station::UltrasoundChoice choice = station::choose_ultrasound(request);
  if (arguments.deformed) choice.press = std::min(choice.press, 0.0);  // the needle's work alone
  const bool sweeping = arguments.sweep.any();
  std::optional<SweepTarget> target;
  std::vector<imaging::SweepPose> poses;
  if (sweeping) {
    motion_of(arguments.sweep);  // refuses what it cannot read before the case is loaded
    target = sweep_target(arguments.output.empty() ? "sweep.igs.mha" : arguments.output);
    if (arguments.ct && target->kind == SweepKind::sequence) {
      throw InputError(
          fmt::format("--ct is for pictures and videos, but {} is a sequence with the ultrasound alone; give -o "
                      "NAME.mp4 or a folder",
                      target->file));
    }
    if (!arguments.sweep.file.empty()) poses = read_sweep(arguments.sweep.file);
  } else {
    check_picture_name(arguments);
  }
  if (arguments.live) show_live(arguments, request);
  std::optional<imaging::ReferenceImage> real;
  if (arguments.reference.any()) {
    real = read_reference_image(arguments.reference, choice.probe, choice.mark);
    match_reference_image(arguments.options, *real, choice);
  }

  const anatomy::Case patient = io::load_case(arguments.folder, console.progress());
  std::optional<imaging::NeedleInUltrasound> needle = station::needle_of(request, patient);
  // A file of poses needs no start position, which a crop of a CT may lack.
  const imaging::ProbeOnSkin hand =
      poses.empty() ? station::hold_probe(choice, patient) : imaging::ProbeOnSkin(poses.front().pose);
  const std::string needle_text = needle ? needle_words(*needle, *patient.description.procedure.path) : "";
  imaging::Ultrasound machine(imaging::acoustic_volume(patient, console.progress()), choice.probe, choice.settings,
                              choice.detail);
  console.clear_bar();
  std::optional<DeformedScan> deformed;
  if (arguments.deformed) {
    const imaging::UltrasoundFrame& frame = machine.image(hand.pose());
    deformed = deform_scan(patient, arguments.folder, needle->pose.translation(), frame, hand.pose(), console);
    needle = deformed->needle;
    console.clear_bar();
  }
  const ScanScene scene{patient, choice, hand.pose(), needle, needle_text, std::move(deformed), std::move(real)};
  if (sweeping) {
    scan_sweep(arguments, scene, std::move(poses), *target, machine, console);
  } else {
    scan_once(arguments, scene, machine, console);
  }
}

}  // namespace

void add_ultrasound_command(CLI::App& app, CommandContext& context) {
  add_command(
      app, "ultrasound", "What an ultrasound probe shows of a patient", ultrasound_footer,
      [&context](CLI::App& command) {
        auto arguments = std::make_shared<UltrasoundArguments>();
        add_text(command, "CASE", arguments->folder, "Folder of the case").required();
        add_ultrasound_options(command, arguments->options);
        add_text(command, "-o,--output", arguments->output,
                 "The picture, .png or .svg (default: NAME-ultrasound.png); of a sweep .mha, a video or a folder");
        add_switch(command, "--deformed", arguments->deformed,
                   "With --needle and a case with a mesh: show the tissue as the needle has moved it");
        add_switch(command, "--plain", arguments->plain,
                   "Write the ultrasound pixels alone, without scales and texts");
        add_switch(command, "--ct", arguments->ct, "Show the same plane of the CT next to it");
        add_reference_options(command, arguments->reference);
        add_sweep_options(command, arguments->sweep);
        add_switch(command, "--live", arguments->live, "The probe in your hand: a window for mouse and keyboard");
        on_run(command, [arguments, &context] { run_ultrasound(*arguments, context); });
      });
}

}  // namespace bodkin::cli
