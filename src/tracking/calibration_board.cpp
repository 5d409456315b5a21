#include "tracking/calibration_board.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tracking/marker_sheet.h"
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace bodkin::tracking {

namespace {

constexpr int first_marker = 22;
constexpr double share_of_square = 0.74;  // which leaves a margin of slightly more than a cell

bool is_black(int column, int row) {
  return (column + row) % 2 == 0;
}

}  // namespace

MarkerBody CalibrationBoard::body() const {
  MarkerBody made;
  made.name = "calibration board";
  int id = first_marker;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      if (is_black(column, row)) continue;
      MarkerFace face;
      face.id = id++;
      face.side = share_of_square * square;
      face.sheet = square;
      face.place.translation() = square * Vec3(column - 0.5 * (columns - 1), row - 0.5 * (rows - 1), 0.0);
      made.faces.push_back(face);
    }
  }
  return made;
}

MarkerBody CalibrationBoard::printed() const {
  MarkerBody made = body();
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      if (!is_black(column, row)) continue;
      MarkerFace face;
      face.side = face.sheet = square;
      face.reflectance = 0.035;
      face.place.translation() = square * Vec3(column - 0.5 * (columns - 1), row - 0.5 * (rows - 1), 0.0);
      made.faces.push_back(face);
    }
  }
  return made;
}

Vec3 CalibrationBoard::corner(int index) const {
  const int column = index % (columns - 1), row = index / (columns - 1);
  return square * Vec3(column + 1 - 0.5 * columns, row + 1 - 0.5 * rows, 0.0);
}

std::vector<FoundCorner> find_corners(const GreyImage& picture, const CalibrationBoard& board,
                                      const std::vector<FoundMarker>& markers) {
  const MarkerBody body = board.body();
  std::vector<FoundCorner> found;
  std::vector<cv::Point2f> at;
  double smallest = 1e9;
  for (int index = 0; index < board.corner_count(); ++index) {
    // Located from the two adjacent markers, which are so close that lens distortion is negligible.
    const Vec3 corner = board.corner(index);
    std::vector<cv::Point2d> on_board, seen;
    for (const FoundMarker& marker : markers) {
      const MarkerFace* const face = body.face_of(marker.id);
      if (face == nullptr || (face->place.translation() - corner).norm() > 0.8 * board.square) continue;
      const std::array<Vec3, 4> corners = face->corners();
      for (std::size_t c = 0; c < 4; ++c) {
        on_board.emplace_back(corners[c].x(), corners[c].y());
        seen.emplace_back(marker.corners[c].x(), marker.corners[c].y());
      }
      smallest = std::min(smallest, (marker.corners[0] - marker.corners[2]).norm());
    }
    if (on_board.size() != 8) continue;
    const cv::Mat plane = cv::findHomography(on_board, seen);
    if (plane.empty()) continue;
    std::vector<cv::Point2d> from = {{corner.x(), corner.y()}}, to;
    cv::perspectiveTransform(from, to, plane);
    if (to[0].x < 8.0 || to[0].y < 8.0 || to[0].x > picture.width - 9.0 || to[0].y > picture.height - 9.0) continue;
    found.push_back({index, Eigen::Vector2d::Zero()});
    at.emplace_back(static_cast<float>(to[0].x), static_cast<float>(to[0].y));
  }
  if (found.empty()) return found;
  // The window ends before the markers, whose black squares begin an eighth of a square away.
  const int window = std::clamp(static_cast<int>(0.09 * smallest / share_of_square), 2, 6);
  // OpenCV only reads it.
  const cv::Mat view(picture.height, picture.width, CV_8UC1,
                     const_cast<std::uint8_t*>(picture.pixels.data()));  // NOLINT
  cv::cornerSubPix(view, at, {window, window}, {-1, -1},
                   cv::TermCriteria(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 0.001));
  for (std::size_t i = 0; i < found.size(); ++i)
    found[i].at = Eigen::Vector2d(static_cast<double>(at[i].x), static_cast<double>(at[i].y));
  return found;
}

std::string calibration_board_pdf(const CalibrationBoard& board) {
  return marker_sheets_pdf({board.printed()});
}

}  // namespace bodkin::tracking
