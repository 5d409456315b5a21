#include "tracking/camera_calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "tracking/photometric_refinement.h"
#include "tracking/start_pose.h"
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

#include "core/error.h"

namespace bodkin::tracking {

namespace {

constexpr int least_corners = 12, least_pictures = 10;
constexpr int fields_across = 6, fields_down = 4;
constexpr double nearly_same = 0.012;  // of the picture's width, RMS of the corners
constexpr double wanted_coverage = 0.75;
constexpr std::size_t most_light_views = 5, most_light_markers = 6;
constexpr double most_light_ratio = 1.6;  // of an image's residual over that of the middle one

// RMS motion of the corners visible in both; negative if there are too few.
double shift_between(const std::vector<FoundCorner>& a, const std::vector<FoundCorner>& b) {
  double sum = 0.0;
  int count = 0;
  for (const FoundCorner& one : a) {
    const auto other =
        std::find_if(b.begin(), b.end(), [&](const FoundCorner& corner) { return corner.index == one.index; });
    if (other == b.end()) continue;
    sum += (one.at - other->at).squaredNorm();
    ++count;
  }
  return count < least_corners / 2 ? -1.0 : std::sqrt(sum / count);
}

// The place of the minimum in [low, high], to a thirtieth of it.
template <typename Function>
double least_of(double low, double high, const Function& value) {
  constexpr double golden = 0.381966;
  double a = low + golden * (high - low), b = high - golden * (high - low);
  double at_a = value(a), at_b = value(b);
  for (int i = 0; i < 7; ++i) {
    if (at_a < at_b) {
      high = std::exchange(b, a);
      at_b = at_a;
      a = low + golden * (high - low);
      at_a = value(a);
    } else {
      low = std::exchange(a, b);
      at_a = at_b;
      b = high - golden * (high - low);
      at_b = value(b);
    }
  }
  return at_a < at_b ? a : b;
}

}  // namespace

std::string_view name_of(PictureUse use) {
  switch (use) {
    case PictureUse::kept:
      return "kept";
    case PictureUse::few_corners:
      return "too few corners";
    case PictureUse::moving:
      return "moving";
    case PictureUse::seen_already:
      return "seen already";
  }
  return "";
}

CameraCalibration::CameraCalibration(const CalibrationBoard& board, const CalibrationOptions& options)
    : board_(board), body_(board.body()), options_(options) {}

PictureUse CameraCalibration::add(const GreyImage& picture) {
  if (width_ == 0) {
    width_ = picture.width;
    height_ = picture.height;
  }
  if (picture.width != width_ || picture.height != height_) {
    throw InputError(
        fmt::format("a picture has {} x {} pixels, but the first one has {} x {}; a camera is calibrated "
                    "at one size",
                    picture.width, picture.height, width_, height_));
  }
  View view;
  view.markers = search_markers(picture);
  view.corners = find_corners(picture, board_, view.markers);
  const std::vector<FoundCorner> before = std::exchange(before_, view.corners);
  if (static_cast<int>(view.corners.size()) < least_corners) return PictureUse::few_corners;
  if (options_.in_motion) {
    const double moved = shift_between(view.corners, before);
    if (moved < 0.0 || moved > options_.rest) return PictureUse::moving;
  }
  for (const View& other : views_) {
    const double moved = shift_between(view.corners, other.corners);
    if (moved >= 0.0 && moved < nearly_same * width_) return PictureUse::seen_already;
  }
  if (kept() >= options_.most_pictures) return PictureUse::seen_already;
  double least = 1e9, most = 0.0;
  for (const FoundMarker& marker : view.markers) {
    if (body_.face_of(marker.id) == nullptr) continue;
    const Eigen::Vector2d across = marker.corners[2] - marker.corners[0],
                          down = marker.corners[3] - marker.corners[1];
    const double size = std::sqrt(std::abs(across.x() * down.y() - across.y() * down.x()));
    least = std::min(least, size);
    most = std::max(most, size);
  }
  view.tilt = most > 0.0 ? (most - least) / most : 0.0;
  view.picture = picture;
  views_.push_back(std::move(view));
  return PictureUse::kept;
}

double CameraCalibration::coverage() const {
  std::array<bool, static_cast<std::size_t>(fields_across) * fields_down> seen{};
  for (const View& view : views_) {
    for (const FoundCorner& corner : view.corners) {
      const int column = std::clamp(static_cast<int>(corner.at.x() * fields_across / width_), 0, fields_across - 1);
      const int row = std::clamp(static_cast<int>(corner.at.y() * fields_down / height_), 0, fields_down - 1);
      seen[static_cast<std::size_t>(row) * fields_across + static_cast<std::size_t>(column)] = true;
    }
  }
  return static_cast<double>(std::count(seen.begin(), seen.end(), true)) / static_cast<double>(seen.size());
}

int CameraCalibration::tilted() const {
  return static_cast<int>(
      std::count_if(views_.begin(), views_.end(), [](const View& view) { return view.tilt > 0.1; }));
}

std::string CameraCalibration::advice() const {
  if (coverage() < wanted_coverage) return "bring the board to the edges and corners of the picture";
  if (3 * tilted() < kept()) return "tilt the board, up to 45 degrees, in all directions";
  if (kept() < least_pictures) return "hold the board still at more places";
  return "";
}

CalibratedCamera CameraCalibration::solve() const {
  if (kept() < least_pictures) {
    throw InputError(fmt::format(
        "{} pictures show the board at rest; at least {} are needed, with the board at other places and tilted",
        kept(), least_pictures));
  }
  if (tilted() < 3) {
    throw InputError(
        "the board faces the camera in nearly all pictures, so focal length and distance are undetermined; tilt it "
        "by 20 to 45 degrees in all directions");
  }
  std::vector<const View*> used;
  for (const View& view : views_) used.push_back(&view);
  CalibratedCamera made;
  for (int turn = 0; turn < 2; ++turn) {
    fit_lens(used, made);
    fit_light(used, made);
    // An image blurred by motion differs from its model, although its corners may fit.
    const std::vector<double> residuals = light_residuals(made.camera, used);
    std::vector<double> sorted = residuals;
    std::sort(sorted.begin(), sorted.end());
    const double most = most_light_ratio * sorted[sorted.size() / 2];
    std::vector<const View*> sharp;
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (residuals[i] <= most) sharp.push_back(used[i]);
    }
    if (sharp.size() == used.size() || static_cast<int>(sharp.size()) < least_pictures) break;
    used = std::move(sharp);
    if (turn == 1) fit_lens(used, made);
  }
  made.pictures = static_cast<int>(used.size());
  made.refused = kept() - made.pictures;
  if (made.residual > 1.5) {
    throw InputError(
        fmt::format("the corners of the board fit no lens: the residual is {:.2f} pixels, where 0.1 to 0.5 are "
                    "usual; is the print flat, and the focus fixed?",
                    made.residual));
  }
  return made;
}

// Views whose corners fit badly are removed from `used`.
void CameraCalibration::fit_lens(std::vector<const View*>& used, CalibratedCamera& made) const {
  for (int turn = 0; turn < 3; ++turn) {
    std::vector<std::vector<cv::Point3f>> on_board;
    std::vector<std::vector<cv::Point2f>> seen;
    for (const View* view : used) {
      on_board.emplace_back();
      seen.emplace_back();
      for (const FoundCorner& corner : view->corners) {
        const Vec3 at = board_.corner(corner.index);
        on_board.back().emplace_back(static_cast<float>(at.x()), static_cast<float>(at.y()), 0.0F);
        seen.back().emplace_back(static_cast<float>(corner.at.x()), static_cast<float>(corner.at.y()));
      }
    }
    cv::Mat matrix = (cv::Mat_<double>(3, 3) << width_, 0, 0.5 * width_, 0, width_, 0.5 * height_, 0, 0, 1);
    cv::Mat lens, deviations, outer_deviations, errors;
    std::vector<cv::Mat> turns, shifts;
    made.residual = cv::calibrateCamera(on_board, seen, {width_, height_}, matrix, lens, turns, shifts, deviations,
                                        outer_deviations, errors, cv::CALIB_USE_INTRINSIC_GUESS | cv::CALIB_FIX_K3);
    CameraModel& camera = made.camera;
    camera.width = width_;
    camera.height = height_;
    camera.fx = matrix.at<double>(0, 0);
    camera.fy = matrix.at<double>(1, 1);
    camera.cx = matrix.at<double>(0, 2);
    camera.cy = matrix.at<double>(1, 2);
    camera.k1 = lens.at<double>(0);
    camera.k2 = lens.at<double>(1);
    camera.p1 = lens.at<double>(2);
    camera.p2 = lens.at<double>(3);
    camera.residual = made.residual;
    made.focal_deviation = deviations.at<double>(0);
    made.centre_deviation = std::max(deviations.at<double>(2), deviations.at<double>(3));
    std::vector<double> sorted;
    for (int i = 0; i < errors.rows; ++i) sorted.push_back(errors.at<double>(i));
    std::sort(sorted.begin(), sorted.end());
    const double most = std::max(3.0 * sorted[sorted.size() / 2], 0.15);
    std::vector<const View*> sound;
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (errors.at<double>(static_cast<int>(i)) <= most) sound.push_back(used[i]);
    }
    if (sound.size() == used.size() || static_cast<int>(sound.size()) < least_pictures) return;
    used = std::move(sound);
  }
}

CameraCalibration::Sheet CameraCalibration::sheet_of(const CameraModel& camera, const View& view) const {
  Sheet sheet;
  sheet.view = &view;
  const std::vector<StartPose> starts = start_poses(camera, body_, view.markers);
  if (starts.empty()) return sheet;
  sheet.pose = starts.front().camera_from_body;
  std::vector<int> ids;
  for (const FoundMarker& marker : view.markers) {
    if (body_.face_of(marker.id) != nullptr) ids.push_back(marker.id);
  }
  const std::size_t step = std::max<std::size_t>(1, ids.size() / most_light_markers);
  for (std::size_t k = 0; k < ids.size() && sheet.ids.size() < most_light_markers; k += step)
    sheet.ids.push_back(ids[k]);
  return sheet;
}

std::vector<double> CameraCalibration::light_residuals(const CameraModel& camera,
                                                       const std::vector<const View*>& views) const {
  const PhotometricRefinement refinement(camera);
  std::vector<double> residuals;
  for (const View* view : views) {
    const Sheet sheet = sheet_of(camera, *view);
    const RefinedPose refined = refinement.refine(view->picture, body_, sheet.ids, sheet.pose, 4);
    residuals.push_back(refined.sound ? refined.residual : 1.0);
  }
  return residuals;
}

void CameraCalibration::fit_light(const std::vector<const View*>& views, CalibratedCamera& made) const {
  PhotometricRefinement refinement(made.camera);
  std::vector<Sheet> sheets;
  const std::size_t every = std::max<std::size_t>(1, views.size() / most_light_views);
  for (std::size_t i = 0; i < views.size() && sheets.size() < most_light_views; i += every) {
    Sheet sheet = sheet_of(made.camera, *views[i]);
    if (!sheet.ids.empty()) sheets.push_back(std::move(sheet));
  }
  // The worse half of the images may be blurred by motion: the median counts. Poses are fitted with the light.
  const auto left_over = [&](double exponent, double contrast, double blur) {
    refinement.set_light({exponent, contrast}, blur);
    std::vector<double> residuals;
    for (Sheet& sheet : sheets) {
      const RefinedPose refined = refinement.refine(sheet.view->picture, body_, sheet.ids, sheet.pose, 3);
      residuals.push_back(refined.sound ? refined.residual : 0.5);
      if (refined.sound) sheet.pose = refined.camera_from_body;
    }
    std::sort(residuals.begin(), residuals.end());
    double sum = 0.0;
    const std::size_t half = (residuals.size() + 1) / 2;
    for (std::size_t i = 0; i < half; ++i) sum += residuals[i];
    return half == 0 ? 1.0 : sum / static_cast<double>(half);
  };
  double exponent = 2.0, contrast = 0.0, blur = 0.9;
  left_over(exponent, contrast, blur);
  for (int turn = 0; turn < 3; ++turn) {
    blur = least_of(0.3, 3.0, [&](double value) { return left_over(exponent, contrast, value); });
    exponent = least_of(1.0, 3.0, [&](double value) { return left_over(value, contrast, blur); });
    contrast = least_of(0.0, 0.8, [&](double value) { return left_over(exponent, value, blur); });
  }
  double residual = left_over(exponent, contrast, blur);
  // The standard's own curve, if it explains the images equally well.
  const double blur_of_standard = least_of(0.3, 3.0, [&](double value) { return left_over(0.0, 0.0, value); });
  const double standard = left_over(0.0, 0.0, blur_of_standard);
  if (standard < 1.02 * residual) {
    exponent = contrast = 0.0;
    blur = blur_of_standard;
    residual = standard;
  }
  made.camera.tone = {exponent, contrast};
  made.camera.blur = blur;
  made.light_residual = residual;
}

}  // namespace bodkin::tracking
