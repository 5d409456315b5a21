#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "tracking/lens_watch.h"
#include "tracking/marker_watch.h"
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
  bodkin track footage                              status of every body, and errors if the true poses are known
  bodkin track footage --csv poses.csv              every pose of every picture
  bodkin track pictures --camera camera.json --bodies bodies.json
  bodkin track video.mp4 --camera camera.json       a video, each picture with its own time
  bodkin track /dev/video0 --camera camera.json     a camera, one line per second, until Ctrl-C

A pose is ok, uncertain (picture and model disagree, or two poses explain it nearly as well) or lost. The error is that of
the body's tip. docs/augmented-reality.md says how poses are found.)";

// Tracking result of one body over the footage.
struct BodySummary {
  int ok = 0, uncertain = 0, lost = 0;
  std::vector<double> errors, predicted;  // mm
};

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// Place (mm) and quaternion as seven columns.
std::string place_of(const Pose& pose) {
  const Vec3 at = pose.translation();
  const Eigen::Quaterniond turn(pose.linear());
  return fmt::format("{:.4f},{:.4f},{:.4f},{:.7f},{:.7f},{:.7f},{:.7f}", at.x(), at.y(), at.z(), turn.w(), turn.x(),
                     turn.y(), turn.z());
}

// The columns of the table; the covariance by its upper triangle, row by row.
std::string table_head() {
  std::string head =
      "time_s,body,status,x_mm,y_mm,z_mm,qw,qx,qy,qz,tip_sd_mm,residual,markers,error_mm,"
      "filtered_x_mm,filtered_y_mm,filtered_z_mm,filtered_qw,filtered_qx,filtered_qy,filtered_qz";
  constexpr const char* axes[] = {"x", "y", "z", "rx", "ry", "rz"};
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) head += fmt::format(",cov_{}_{}", axes[i], axes[j]);
  }
  return head + "\n";
}

// Counts a pose, and returns its row of the table. `truth`: null if unknown.
std::string row_of(double time, const tracking::MarkerBody& body, const tracking::TrackedPose& pose,
                   const Pose* truth, BodySummary& summary) {
  std::string row = fmt::format("{:.6f},{},{},", time, body.name, name_of(pose.status));
  if (pose.status == tracking::TrackingStatus::lost) {
    ++summary.lost;
    return row + ",,,,,,,,,0," + std::string(7 + 21, ',') + "\n";
  }
  const bool ok = pose.status == tracking::TrackingStatus::ok;
  ++(ok ? summary.ok : summary.uncertain);
  const double deviation = std::sqrt(point_covariance(pose, body.tip).trace());
  row += fmt::format("{},{:.4f},{:.4f},{},", place_of(pose.camera_from_body), deviation, pose.residual, pose.markers);
  if (truth != nullptr) {
    const double error = (pose.camera_from_body * body.tip - *truth * body.tip).norm();
    if (ok) {
      summary.errors.push_back(error);
      summary.predicted.push_back(deviation);
    }
    row += fmt::format("{:.4f}", error);
  }
  row += ',' + place_of(pose.filtered);
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) row += fmt::format(",{:.6g}", pose.covariance(i, j));
  }
  return row + "\n";
}

// The detections of a live camera, on one line.
std::string live_line(const std::vector<tracking::MarkerBody>& bodies,
                      const std::vector<tracking::TrackedPose>& poses) {
  std::string line;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    line += fmt::format("{}{} {}", b == 0 ? "" : ", ", bodies[b].name, name_of(poses[b].status));
    if (poses[b].status != tracking::TrackingStatus::ok) continue;
    const Vec3 tip = poses[b].camera_from_body * bodies[b].tip;
    line += fmt::format(" ({:.1f} {:.1f} {:.1f} ±{:.2f} mm)", tip.x(), tip.y(), tip.z(),
                        std::sqrt(point_covariance(poses[b], bodies[b].tip).trace()));
  }
  return line;
}

void run_track(const TrackArguments& arguments, const CommandContext& context) {
  if (!arguments.csv.empty()) require_writable(arguments.csv, "--csv");
  Console console(context);
  tracking::OpenedFootage opened = open_footage_of(arguments.footage);
  tracking::Tracker tracker(opened.camera, opened.bodies);
  tracking::LensWatch lens;
  std::vector<BodySummary> summaries(opened.bodies.size());
  std::string table = table_head();
  const std::vector<std::string> known = opened.source->bodies();
  tracking::MarkerWatch markers(arguments.footage.source);
  int pictures = 0;
  double last_report = -1e9;
  std::string warning;
  for_each_picture(*opened.source, arguments.footage, console, "tracking", [&](const tracking::SourcePicture& frame) {
    const std::vector<tracking::TrackedPose>& poses = tracker.track(frame.grey, frame.time);
    lens.add(poses);
    if (warning.empty()) warning = lens.warning();
    markers.add(tracker, frame.grey);
    ++pictures;
    for (std::size_t b = 0; b < poses.size(); ++b) {
      const tracking::MarkerBody& body = opened.bodies[b];
      const auto truth = std::find(known.begin(), known.end(), body.name);
      const Pose* const place =
          truth == known.end() ? nullptr : &frame.camera_from_body[static_cast<std::size_t>(truth - known.begin())];
      table += row_of(frame.time, body, poses[b], place, summaries[b]);
    }
    if (opened.source->live() && frame.time - last_report >= 1.0) {
      last_report = frame.time;
      console.line(live_line(opened.bodies, poses));
      if (!warning.empty()) console.note(warning);
      if (const std::string why = markers.warning(); !why.empty()) console.note(why);
    }
    return true;
  });
  const std::string why = markers.warning_of_all();
  if (!why.empty() && !markers.any_body()) throw InputError(why);
  if (!why.empty()) console.note(why);
  if (!warning.empty()) console.note(warning);
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  console.line(fmt::format("{} pictures of {} x {}", pictures, opened.camera.width, opened.camera.height));
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
  add_command(app, "track", "Where marker bodies are in the pictures of a camera", track_footer,
              [&context](CLI::App& command) {
                auto arguments = std::make_shared<TrackArguments>();
                add_footage_options(command, arguments->footage);
                add_text(command, "--csv", arguments->csv, "File for every pose of every picture");
                on_run(command, [arguments, &context] { run_track(*arguments, context); });
              });
}

}  // namespace bodkin::cli
