#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "tracking/tracker.h"
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

struct TrackArguments {
  FootageArguments footage;
  std::string csv;
};

constexpr const char* track_footer = R"(Examples:
  bodkin track footage                              status of every body, and errors where the truth is known
  bodkin track footage --csv poses.csv              every pose of every picture
  bodkin track pictures --camera camera.json --bodies bodies.json

A pose is ok, uncertain (picture and model disagree, or two poses explain it nearly as well) or lost. The error is that of
the body's tip. docs/augmented-reality.md says how poses are found.)";

// What became of one body over the footage.
struct BodySummary {
  int ok = 0, uncertain = 0, lost = 0;
  std::vector<double> errors, predicted;  // mm
};

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

void run_track(const TrackArguments& arguments, const CommandContext& context) {
  if (!arguments.csv.empty()) require_writable(arguments.csv, "--csv");
  Console console(context);
  const OpenedFootage opened = open_footage_of(arguments.footage);
  tracking::Tracker tracker(opened.camera, opened.bodies);
  std::vector<BodySummary> summaries(opened.bodies.size());
  std::string table = "time_s,body,status,x_mm,y_mm,z_mm,qw,qx,qy,qz,tip_sd_mm,residual,markers,error_mm\n";
  const tracking::Footage& footage = opened.footage;
  const Progress progress = console.progress();
  std::size_t markers = 0;
  for (std::size_t n = 0; n < footage.frames.size(); ++n) {
    if (progress) progress("tracking", static_cast<double>(n) / static_cast<double>(footage.frames.size()));
    const tracking::FootageFrame& frame = footage.frames[n];
    const auto picture = tracking::grey_of(tracking::read_picture(footage.folder / frame.file));
    const std::vector<tracking::TrackedPose>& poses = tracker.track(picture, frame.time);
    markers += tracker.markers().size();
    for (std::size_t b = 0; b < poses.size(); ++b) {
      const tracking::TrackedPose& pose = poses[b];
      const tracking::MarkerBody& body = opened.bodies[b];
      BodySummary& summary = summaries[b];
      ++(pose.status == tracking::TrackingStatus::ok          ? summary.ok
         : pose.status == tracking::TrackingStatus::uncertain ? summary.uncertain
                                                              : summary.lost);
      double error = NAN;
      const auto truth = std::find(footage.bodies.begin(), footage.bodies.end(), body.name);
      const double deviation = std::sqrt(point_covariance(pose, body.tip).trace());
      if (truth != footage.bodies.end() && pose.status != tracking::TrackingStatus::lost) {
        const Pose& place = frame.camera_from_body[static_cast<std::size_t>(truth - footage.bodies.begin())];
        error = (pose.camera_from_body * body.tip - place * body.tip).norm();
        if (pose.status == tracking::TrackingStatus::ok) {
          summary.errors.push_back(error);
          summary.predicted.push_back(deviation);
        }
      }
      const Vec3 at = pose.camera_from_body.translation();
      const Eigen::Quaterniond turn(pose.camera_from_body.linear());
      table += fmt::format("{:.6f},{},{},", frame.time, body.name, name_of(pose.status));
      if (pose.status == tracking::TrackingStatus::lost) {
        table += ",,,,,,,,,0,\n";
        continue;
      }
      table += fmt::format("{:.4f},{:.4f},{:.4f},{:.7f},{:.7f},{:.7f},{:.7f},{:.4f},{:.4f},{},", at.x(), at.y(),
                           at.z(), turn.w(), turn.x(), turn.y(), turn.z(), deviation, pose.residual, pose.markers);
      table += std::isnan(error) ? "\n" : fmt::format("{:.4f}\n", error);
    }
  }
  console.clear_bar();
  if (markers == 0) throw InputError(why_nothing_was_found(footage));
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  console.line(
      fmt::format("{} pictures of {} x {}", footage.frames.size(), opened.camera.width, opened.camera.height));
  for (std::size_t b = 0; b < summaries.size(); ++b) {
    const BodySummary& summary = summaries[b];
    std::string line = fmt::format("{:<12} ok {}, uncertain {}, lost {}", opened.bodies[b].name, summary.ok,
                                   summary.uncertain, summary.lost);
    nlohmann::ordered_json entry = {{"body", opened.bodies[b].name},
                                    {"ok", summary.ok},
                                    {"uncertain", summary.uncertain},
                                    {"lost", summary.lost}};
    if (!summary.errors.empty()) {
      const double most = *std::max_element(summary.errors.begin(), summary.errors.end());
      line += fmt::format("; tip error RMS {:.3f} mm, most {:.3f} mm, predicted {:.3f} mm", rms(summary.errors), most,
                          rms(summary.predicted));
      entry["tip_error_rms_mm"] = rms(summary.errors);
      entry["tip_error_most_mm"] = most;
      entry["tip_predicted_rms_mm"] = rms(summary.predicted);
    }
    console.line(line);
    json.push_back(entry);
  }
  if (!arguments.csv.empty()) write_file(arguments.csv, table);
  console.json(json.dump(2));
}

}  // namespace

void add_track_command(CLI::App& app, CommandContext& context) {
  auto arguments = std::make_shared<TrackArguments>();
  CLI::App* command = add_command(app, "track", "Where marker bodies are in the pictures of a camera", track_footer);
  add_footage_options(*command, arguments->footage);
  add_text(*command, "--csv", arguments->csv, "File for every pose of every picture");
  on_run(*command, [arguments, &context] { run_track(*arguments, context); });
}

}  // namespace bodkin::cli
