#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "tracking/augmented_view.h"
#include "tracking/footage_scene.h"
#include "tracking/lens_watch.h"
#include "tracking/marker_watch.h"
#include "tracking/registration_file.h"
#include "tracking/shown_target_error.h"
#include "tracking/stage_times.h"
#include "tracking/tracker.h"
#include "tracking/video_file.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/footage_options.h"
#include "cli/probe_insets.h"
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
  bool ultrasound = false, full_resolution = false, times = false;
};

constexpr const char* overlay_footer = R"(Examples:
  bodkin case synthesize lumbar patient
  bodkin scene render footage
  bodkin overlay patient footage                           overlay.avi: the patient within the mannequin
  bodkin overlay patient footage -o pictures               the same as a folder of pictures
  bodkin overlay patient footage --registration registration.json --preset bone
  bodkin overlay patient footage --ultrasound --times      with the probe's ultrasound, and the time of each stage
  bodkin overlay patient /dev/video0 --camera camera.json --seconds 60    a minute of a live camera

Every picture is drawn with the poses seen in it. Without --registration the entry of the planned path is placed on the
mannequin's back, as in rendered footage. See docs/augmented-reality.md.)";

tracking::AugmentedLook look_of(const OverlayArguments& arguments) {
  tracking::AugmentedLook look;
  look.radii = 0.5 * Eigen::Vector2d(arguments.oval_width, arguments.oval_height);
  look.threshold = arguments.threshold;
  look.step = arguments.step;
  look.needle = !arguments.no_needle;
  look.plan = !arguments.no_plan;
  look.front_view = !arguments.no_front_view;
  look.status = !arguments.no_status;
  look.coarse_while_moving = !arguments.full_resolution;
  if (!arguments.region.empty()) look.region = parse_point(arguments.region, "--region");
  const auto preset = std::find_if(imaging::transfer_presets.begin(), imaging::transfer_presets.end(),
                                   [&](imaging::TransferPreset one) { return name_of(one) == arguments.preset; });
  if (preset == imaging::transfer_presets.end()) {
    throw InputError(fmt::format("--preset is '{}'; expected bone, soft_tissue, skin or vessels", arguments.preset));
  }
  look.preset = *preset;
  return look;
}

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

// A tracked image.
struct TrackedPicture {
  imaging::ImageRgb colour;
  std::vector<tracking::TrackedPose> poses;
  Clock::time_point arrived;  // not decoded yet
};

// Draws and writes tracked images on a separate thread, while the next ones are being read and tracked.
class OverlayWriter {
 public:
  OverlayWriter(const OverlayArguments& arguments, const anatomy::Case& patient,
                const tracking::OpenedFootage& opened, std::size_t mannequin, const tracking::Similarity& place,
                const std::function<void(const std::string&)>& note)
      : bodies_(opened.bodies),
        mannequin_(mannequin),
        place_(place),
        view_(patient, opened.camera, place_, look_of(arguments)),
        output_(arguments.output) {
    if (arguments.ultrasound) ultrasound_.emplace(patient, arguments.patient, note);
    if (output_.extension() == ".avi")
      video_.emplace(output_, opened.camera.width, opened.camera.height, opened.source->rate());
    thread_ = std::jthread([this] { run(); });
  }
  ~OverlayWriter() { end(); }
  OverlayWriter(const OverlayWriter&) = delete;
  OverlayWriter& operator=(const OverlayWriter&) = delete;

  // Waits while two are not yet drawn; rethrows exceptions of the drawing.
  void add(TrackedPicture picture) {
    std::unique_lock guard(lock_);
    changed_.wait(guard, [this] { return waiting_.size() < most_waiting || failure_; });
    if (failure_) std::rethrow_exception(failure_);
    waiting_.push_back(std::move(picture));
    changed_.notify_all();
  }

  // Returns when all are written.
  void finish() {
    end();
    if (failure_) std::rethrow_exception(failure_);
    if (video_) video_->finish();
  }

  // Only after finish().
  const tracking::StageTimes& times() const { return times_; }
  int pictures() const { return pictures_; }

 private:
  static constexpr std::size_t most_waiting = 2;

  void end() {
    {
      const std::lock_guard guard(lock_);
      ended_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
  }

  void run() {
    try {
      while (std::optional<TrackedPicture> picture = take()) write(*picture);
    } catch (...) {
      const std::lock_guard guard(lock_);
      failure_ = std::current_exception();
      changed_.notify_all();
    }
  }

  std::optional<TrackedPicture> take() {
    std::unique_lock guard(lock_);
    changed_.wait(guard, [this] { return !waiting_.empty() || ended_; });
    if (waiting_.empty()) return std::nullopt;
    TrackedPicture picture = std::move(waiting_.front());
    waiting_.pop_front();
    changed_.notify_all();
    return picture;
  }

  void write(TrackedPicture& picture) {
    const Clock::time_point begin = Clock::now();
    const tracking::TrackedPose& mannequin = picture.poses[mannequin_];
    std::vector<tracking::ShownBody> tools;
    std::optional<Pose> probe, needle;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (b == mannequin_) continue;
      const tracking::TrackedPose& pose = picture.poses[b];
      tools.push_back({&bodies_[b], &pose});
      if (pose.status != tracking::TrackingStatus::ok || mannequin.status != tracking::TrackingStatus::ok) continue;
      const Pose tool =
          tracking::tool_in_patient(bodies_[b], pose.camera_from_body, mannequin.camera_from_body, place_);
      if (bodies_[b].name == "probe") probe = tool;
      if (bodies_[b].name == "needle") needle = tool;
    }
    std::shared_ptr<const imaging::TissueDisplacement> moved;
    if (ultrasound_) moved = ultrasound_->press(probe, mannequin.time);
    const Clock::time_point pressed = Clock::now();
    view_.draw(picture.colour, &mannequin, tools, moved.get());
    const Clock::time_point drawn = Clock::now();
    times_.add("ray cast", view_.cast_seconds());
    times_.add("blend and draw", seconds_between(pressed, drawn) - view_.cast_seconds());
    Clock::time_point shown = drawn;
    if (ultrasound_) {
      ultrasound_->draw(picture.colour, needle);
      shown = Clock::now();
      times_.add("ultrasound", seconds_between(begin, pressed) + seconds_between(drawn, shown));
    }
    times_.add("arrival to drawn", seconds_between(picture.arrived, shown));
    if (video_) {
      video_->add(picture.colour);
    } else {
      write_file(output_ / fmt::format("overlay_{:05}.png", pictures_), imaging::encode_png(picture.colour));
    }
    times_.add("write", seconds_between(shown, Clock::now()));
    ++pictures_;
  }

  const std::vector<tracking::MarkerBody>& bodies_;
  std::size_t mannequin_;
  tracking::Similarity place_;
  tracking::AugmentedView view_;
  std::optional<ProbeInsets> ultrasound_;
  fs::path output_;
  std::optional<tracking::VideoWriter> video_;
  tracking::StageTimes times_;
  int pictures_ = 0;
  std::mutex lock_;  // guards the four below
  std::condition_variable changed_;
  std::deque<TrackedPicture> waiting_;
  bool ended_ = false;
  std::exception_ptr failure_;
  std::jthread thread_;  // the last member: it uses the others
};

// The patient's place in the mannequin.
tracking::Registration registration_of(const OverlayArguments& arguments, const anatomy::Case& patient) {
  if (!arguments.registration.empty()) return tracking::read_registration(arguments.registration);
  tracking::Registration placed;
  placed.fixed_from_moving = tracking::placed_at(patient, tracking::scene_skin());
  return placed;
}

void print_target_error(Console& console, const tracking::ShownTargetError& error, nlohmann::ordered_json& json) {
  const std::optional<tracking::ErrorInterval> pixels = error.in_pixels();
  if (!pixels) return;
  const tracking::ErrorInterval& mm = *error.in_mm();
  console.line(
      fmt::format("TRE at the target: {:.2f} mm RMS, {:.2f} px across the view; its RMS lies between {:.2f} and "
                  "{:.2f} mm, {:.2f} and {:.2f} px, in 9 of 10 registrations",
                  mm.estimate, pixels->estimate, mm.low, mm.high, pixels->low, pixels->high));
  json["tre_mm"] = {{"low", mm.low}, {"estimate", mm.estimate}, {"high", mm.high}};
  json["tre_px"] = {{"low", pixels->low}, {"estimate", pixels->estimate}, {"high", pixels->high}};
}

void print_times(Console& console, const tracking::StageTimes& tracked, const tracking::StageTimes& drawn,
                 double rate) {
  for (const tracking::StageTimes* times : {&tracked, &drawn}) {
    for (const tracking::StageTimes::Row& row : times->rows()) {
      console.line(fmt::format("{:<17}{:6.1f} ms median, {:6.1f} ms at 95 %", row.stage, row.median, row.late));
    }
  }
  console.line(fmt::format("{:.1f} pictures/s", rate));
}

void run_overlay(const OverlayArguments& arguments, const CommandContext& context) {
  look_of(arguments);  // refuses impossible options before anything is read
  const fs::path output = arguments.output;
  std::error_code code;
  if (output.extension() == ".avi") {
    require_writable(output, "--output");
  } else if (fs::exists(output, code) && (!fs::is_directory(output, code) || !fs::is_empty(output, code))) {
    throw InputError(
        fmt::format("--output is '{}'; expected a file that ends in .avi, or a new folder", arguments.output));
  }
  Console console(context);
  tracking::OpenedFootage opened = open_footage_of(arguments.footage);
  const anatomy::Case patient = io::load_case(arguments.patient, console.progress());
  const auto found = std::find_if(opened.bodies.begin(), opened.bodies.end(),
                                  [](const tracking::MarkerBody& body) { return body.name == "mannequin"; });
  if (found == opened.bodies.end()) {
    throw InputError(
        fmt::format("{}: no body is called \"mannequin\", in which the patient is placed", arguments.footage.source));
  }
  const auto mannequin = static_cast<std::size_t>(found - opened.bodies.begin());
  tracking::Tracker tracker(opened.camera, opened.bodies);
  const tracking::Registration registration = registration_of(arguments, patient);
  tracking::ShownTargetError target_error(registration, opened.camera);
  OverlayWriter writer(arguments, patient, opened, mannequin, registration.fixed_from_moving,
                       [&console](const std::string& sentence) { console.note(sentence); });
  tracking::LensWatch lens;
  tracking::StageTimes tracked;
  int drawn = 0;
  tracking::MarkerWatch markers(arguments.footage.source);
  std::string warning;
  const Clock::time_point start = Clock::now();
  Clock::time_point before = start;
  for_each_picture(*opened.source, arguments.footage, console, "overlay", [&](tracking::SourcePicture& frame) {
    const Clock::time_point decoded = Clock::now();
    tracked.add("read and decode", seconds_between(before, decoded));
    const auto& poses = tracker.track(frame.grey, frame.time);
    tracked.add("track", seconds_between(decoded, Clock::now()));
    lens.add(poses);
    target_error.add(poses[mannequin]);
    if (warning.empty()) warning = lens.warning();
    if (poses[mannequin].status == tracking::TrackingStatus::ok) ++drawn;
    markers.add(tracker, frame.grey);
    writer.add({std::move(frame.colour), poses, frame.arrived});
    before = Clock::now();
    return true;
  });
  writer.finish();
  const double seconds = seconds_between(start, Clock::now());
  const int pictures = writer.pictures();
  if (const std::string why = markers.warning_of_all(); !why.empty()) console.note(why);
  if (!warning.empty()) console.note(warning);
  console.line(fmt::format("{}: {} pictures, the patient in {} of them", arguments.output, pictures, drawn));
  nlohmann::ordered_json json{{"output", arguments.output}, {"pictures", pictures}, {"drawn", drawn}};
  print_target_error(console, target_error, json);
  if (arguments.times) {
    print_times(console, tracked, writer.times(), pictures / seconds);
    json["pictures_per_second"] = pictures / seconds;
    for (const tracking::StageTimes* times : {&std::as_const(tracked), &writer.times()}) {
      for (const tracking::StageTimes::Row& row : times->rows())
        json["times"][row.stage] = {{"median_ms", row.median}, {"p95_ms", row.late}};
    }
  }
  console.json(json.dump(2));
}

}  // namespace

void add_overlay_command(CLI::App& app, CommandContext& context) {
  add_command(
      app, "overlay", "Draw the patient's CT inside the mannequin, over a camera's pictures", overlay_footer,
      [&context](CLI::App& command) {
        auto arguments = std::make_shared<OverlayArguments>();
        add_text(command, "CASE", arguments->patient, "Folder of the case").required();
        add_footage_options(command, arguments->footage);
        add_text(command, "-o,--output", arguments->output, "Video (.avi) or new folder of pictures");
        add_text(command, "--registration", arguments->registration, "Patient to mannequin, from 'bodkin register'");
        add_text(command, "--preset", arguments->preset, "What is seen: bone, soft_tissue, skin or vessels");
        add_text(command, "--region", arguments->region, "Middle of the oval, LPS mm: x,y,z (default: the target)");
        add_number(command, "--oval-width", arguments->oval_width, 20.0, 4000.0, "Pixels, 20 to 4000");
        add_number(command, "--oval-height", arguments->oval_height, 20.0, 4000.0, "Pixels, 20 to 4000");
        add_number(command, "--threshold", arguments->threshold, 0.0, 0.99,
                   "Share of the radius that is opaque, 0 to 0.99");
        add_number(command, "--step", arguments->step, 0.25, 8.0, "Voxels between samples of a ray, 0.25 to 8");
        add_switch(command, "--no-needle", arguments->no_needle, "Leave out the needle");
        add_switch(command, "--no-plan", arguments->no_plan, "Leave out the planned path");
        add_switch(command, "--no-front-view", arguments->no_front_view, "Leave out the CT from the front");
        add_switch(command, "--no-status", arguments->no_status, "Leave out the text");
        add_switch(command, "--ultrasound", arguments->ultrasound, "Add the ultrasound of where the probe points");
        add_switch(command, "--full-resolution", arguments->full_resolution,
                   "Cast rays as finely during motion of the mannequin or the camera as at rest");
        add_switch(command, "--times", arguments->times, "Print how long each stage of a picture takes");
        on_run(command, [arguments, &context] { run_overlay(*arguments, context); });
      });
}

}  // namespace bodkin::cli
