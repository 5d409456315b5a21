// Accuracy of tracking marker bodies, on rendered footage with known truth: tip error 150 mm from the body of the
// needle, in the camera's and in the mannequin's frame. Not only a benchmark of time: a row of 1000 images takes
// minutes. `tracking_accuracy --help` lists what can be varied.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "tracking/footage.h"
#include "tracking/tracker.h"

#include "core/random.h"

namespace {

using namespace bodkin;            // NOLINT: a program
using namespace bodkin::tracking;  // NOLINT: a program

struct Choice {
  int pictures = 200, width = 1280, height = 720;
  std::uint64_t seed = 1;
  double distance = 600.0, motion = 0.0, sharpening = 0.0, blur = 0.7, exponent = 0.0, contrast = 0.0;
  double assumed_blur = 0.7, assumed_exponent = -1.0, assumed_focal = 1.0, gate = 0.0, noise = 1.0, exposure = 1.0,
         occlusion = 0.0;
  bool still = false;
};

double cpu_ms() {
  return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Mat3 random_rotation(Random& random) {
  const double x = random.normal();
  const double y = random.normal();
  const double z = random.normal();
  const double w = random.normal();
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

void print_row(const char* name, std::vector<double> errors) {
  if (errors.empty()) {
    std::printf("%-34s none\n", name);
    return;
  }
  std::sort(errors.begin(), errors.end());
  double squares = 0.0;
  for (const double error : errors) squares += error * error;
  const auto at = [&](double share) {
    return errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
  };
  std::printf("%-34s n %5zu  RMS %.3f  median %.3f  p95 %.3f  max %.3f\n", name, errors.size(),
              std::sqrt(squares / static_cast<double>(errors.size())), at(0.5), at(0.95), errors.back());
}

// RMS distance of points from their mean.
double spread_of(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : points) sum += point;
  const Vec3 mean = sum / static_cast<double>(points.size());
  double squares = 0.0;
  for (const Vec3& point : points) squares += (point - mean).squaredNorm();
  return std::sqrt(squares / static_cast<double>(points.size()));
}

bool read_choice(int argc, char** argv, Choice& choice) {
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name == "--still") {
      choice.still = true;
      continue;
    }
    if (i + 1 >= argc) return false;
    const double value = std::atof(argv[++i]);
    if (name == "--pictures")
      choice.pictures = static_cast<int>(value);
    else if (name == "--width")
      choice.width = static_cast<int>(value);
    else if (name == "--height")
      choice.height = static_cast<int>(value);
    else if (name == "--seed")
      choice.seed = static_cast<std::uint64_t>(value);
    else if (name == "--distance")
      choice.distance = value;
    else if (name == "--motion")
      choice.motion = value;
    else if (name == "--sharpening")
      choice.sharpening = value;
    else if (name == "--blur")
      choice.blur = value;
    else if (name == "--exponent")
      choice.exponent = value;
    else if (name == "--contrast")
      choice.contrast = value;
    else if (name == "--assumed-blur")
      choice.assumed_blur = value;
    else if (name == "--assumed-exponent")
      choice.assumed_exponent = value;
    else if (name == "--assumed-focal")
      choice.assumed_focal = value;
    else if (name == "--gate")
      choice.gate = value;
    else if (name == "--noise")
      choice.noise = value;
    else if (name == "--exposure")
      choice.exposure = value;
    else if (name == "--occlusion")
      choice.occlusion = value;
    else
      return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  Choice choice;
  if (!read_choice(argc, argv, choice)) {
    std::puts(
        "tracking_accuracy [--pictures N] [--width PX --height PX] [--seed N] [--distance MM] [--still]\n"
        "  [--motion PX] [--sharpening S] [--blur PX] [--exponent E] [--contrast C] [--assumed-blur PX]\n"
        "  [--assumed-exponent E] [--assumed-focal SHARE] [--gate RESIDUAL] [--noise N] [--exposure E] [--occlusion "
        "SHARE]");
    return 2;
  }
  CameraModel camera = footage_camera(choice.width, choice.height);
  camera.blur = choice.blur;
  camera.tone = {choice.exponent, choice.contrast};
  CameraModel assumed = camera;
  assumed.blur = choice.assumed_blur;
  if (choice.assumed_exponent >= 0.0) assumed.tone = {choice.assumed_exponent, 0.0};
  assumed.fx *= choice.assumed_focal;
  assumed.fy *= choice.assumed_focal;
  FootageLook look;
  look.sharpening = choice.sharpening;
  look.exposure = choice.exposure;
  look.shot_noise *= choice.noise;
  look.read_noise *= choice.noise;
  look.occlusion = choice.occlusion;
  look.instants = choice.motion > 0.0 ? 8 : 1;
  if (choice.motion > 0.0) look.samples = 3;
  std::vector<MarkerBody> bodies = station_bodies();
  bodies.pop_back();
  TrackerSettings settings;
  if (choice.gate > 0.0) settings.most_residual = choice.gate;
  settings.search_every = 0.0;
  Tracker tracker(assumed, bodies, settings);

  Random random(choice.seed);
  std::vector<double> in_camera, in_mannequin, board_error, uncertain_error, residuals, ratios, overlay, tone, blur,
      focal;
  double predicted = 0.0, squares = 0.0, track_ms = 0.0, render_ms = 0.0;
  int lost = 0, uncertain = 0, wrong = 0, wrong_uncertain = 0, within_three = 0, board_bad = 0;
  std::vector<Vec3> raw_tips, filtered_tips;
  Pose needle = Pose::Identity(), board = Pose::Identity();
  for (int n = 0; n < choice.pictures; ++n) {
    if (n == 0 || !choice.still) {
      const double left = random.uniform(-0.22, -0.05), up = random.uniform(-0.12, 0.12);
      needle.translation() = Vec3(left * choice.distance, up * choice.distance, choice.distance);
      needle.linear() = random_rotation(random);
      const double tilt = random.uniform(0.2, 0.75), about = random.uniform(-0.4, 0.4);
      board.linear() = (Eigen::AngleAxisd(tilt, Vec3(1.0, about, 0.0).normalized()) *
                        Eigen::AngleAxisd(random.uniform(-0.5, 0.5), Vec3::UnitZ()))
                           .toRotationMatrix();
      board.translation() = Vec3(0.22 * choice.distance, random.uniform(-10.0, 10.0), choice.distance + 60.0);
    }
    std::vector<PlacedBody> placed = {{&bodies[0], board}, {&bodies[1], needle}};
    if (choice.motion > 0.0) {
      const double angle = random.uniform(0.0, 6.2831853);
      placed[1].shift = choice.motion * choice.distance / camera.fx * Vec3(std::cos(angle), std::sin(angle), 0.0);
    }
    double start = cpu_ms();
    const GreyImage picture =
        render_picture(camera, look, placed, choice.seed * 1000003U + static_cast<std::uint64_t>(n));
    render_ms += cpu_ms() - start;
    start = cpu_ms();
    const std::vector<TrackedPose>& poses = tracker.track(picture, n / 30.0);
    track_ms += cpu_ms() - start;
    const TrackedPose &of_board = poses[0], &of_needle = poses[1];
    if (of_board.status != TrackingStatus::ok) ++board_bad;
    if (of_board.status == TrackingStatus::ok) focal.push_back(100.0 * of_board.misfit.focal.value);
    if (of_needle.status == TrackingStatus::lost) {
      ++lost;
      continue;
    }
    const Vec3 tip = of_needle.camera_from_body * bodies[1].tip, true_tip = needle * bodies[1].tip;
    const double error = (tip - true_tip).norm();
    const double angle =
        Eigen::AngleAxisd(of_needle.camera_from_body.linear().transpose() * needle.linear()).angle() / degree;
    tone.push_back(std::abs(of_needle.misfit.tone.value));
    blur.push_back(std::abs(of_needle.misfit.blur.value));
    if (of_needle.status == TrackingStatus::uncertain) {
      ++uncertain;
      if (angle > 10.0) ++wrong_uncertain;
      uncertain_error.push_back(error);
      continue;
    }
    if (angle > 10.0) {
      ++wrong;
      std::printf("WRONG picture %d: %.1f deg, residual %.4f, markers %d\n", n, angle, of_needle.residual,
                  of_needle.markers);
      continue;
    }
    raw_tips.push_back(tip);
    filtered_tips.emplace_back(of_needle.filtered * bodies[1].tip);
    in_camera.push_back(error);
    residuals.push_back(of_needle.residual);
    ratios.push_back(of_needle.edge_ratio);
    const double sigma = std::sqrt(point_covariance(of_needle, bodies[1].tip).trace());
    predicted += sigma * sigma;
    squares += error * error;
    const Mat3 covariance = point_covariance(of_needle, bodies[1].tip);
    const Vec3 off = tip - true_tip;
    if (off.dot(covariance.inverse() * off) < 14.16) ++within_three;  // 99.73 % with three degrees of freedom
    if (of_board.status == TrackingStatus::ok) {
      in_mannequin.push_back((of_board.camera_from_body.inverse() * tip - board.inverse() * true_tip).norm());
      const Vec3 target(0.0, 0.0, 60.0);
      board_error.push_back((of_board.camera_from_body * target - board * target).norm());
      overlay.push_back(
          (assumed.project(of_board.camera_from_body * target) - camera.project(board * target)).norm());
    }
  }
  std::printf(
      "%d x %d, %d pictures at %.0f mm%s, motion %.0f px: lost %d, uncertain %d (wrong %d), wrong and ok %d, board "
      "not ok %d\n",
      choice.width, choice.height, choice.pictures, choice.distance, choice.still ? " at rest" : "", choice.motion,
      lost, uncertain, wrong_uncertain, wrong, board_bad);
  print_row("tip in the camera's frame, mm", in_camera);
  print_row("tip in the mannequin's frame, mm", in_mannequin);
  print_row("60 mm behind the board, mm", board_error);
  print_row("60 mm behind the board, px", overlay);
  print_row("tip when uncertain, mm", uncertain_error);
  if (choice.still && !raw_tips.empty()) {
    const double raw = spread_of(raw_tips), filtered = spread_of(filtered_tips);
    std::printf("noise at rest, tip against its mean: measured %.3f mm RMS, filtered %.3f, cut by %.2f\n", raw,
                filtered, raw / filtered);
  }
  print_row("residual", residuals);
  print_row("residual of edges over flat parts", ratios);
  print_row("another tone curve, share of step", tone);
  print_row("another blur, px^2", blur);
  print_row("another focal length, %", focal);
  if (!in_camera.empty()) {
    const auto count = static_cast<double>(in_camera.size());
    std::printf("predicted RMS %.3f, found %.3f; within 3 sigma %.1f %%\n", std::sqrt(predicted / count),
                std::sqrt(squares / count), 100.0 * within_three / count);
  }
  std::printf("CPU ms a picture: tracking %.1f, rendering %.1f\n", track_ms / choice.pictures,
              render_ms / choice.pictures);
  return 0;
}
