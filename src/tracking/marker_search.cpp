#include "tracking/marker_search.h"

#include <algorithm>
#include <cstdint>

#include "tracking/marker_body.h"
#include <opencv2/aruco.hpp>
#include <opencv2/core.hpp>

// OpenCV 4.7 moved ArUco into another library with another interface; only this file depends on it.
#if CV_VERSION_MAJOR != 4 || CV_VERSION_MINOR > 6
#error "bodkin::tracking is written for the ArUco module of OpenCV 4.5 and 4.6 (Debian 12)"
#endif

namespace bodkin::tracking {

namespace {

const cv::Ptr<cv::aruco::Dictionary>& dictionary() {
  static const cv::Ptr<cv::aruco::Dictionary> made = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50);
  return made;
}

// One threshold window, and a refinement window that does not reach into the neighbouring cells.
cv::Ptr<cv::aruco::DetectorParameters> search_parameters() {
  cv::Ptr<cv::aruco::DetectorParameters> parameters = cv::aruco::DetectorParameters::create();
  parameters->adaptiveThreshWinSizeMin = 13;
  parameters->adaptiveThreshWinSizeMax = 13;
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  parameters->cornerRefinementWinSize = 3;
  return parameters;
}

void append_markers(const cv::Mat& part, const Eigen::Vector2d& shift, std::vector<FoundMarker>& found) {
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(part, dictionary(), corners, ids, search_parameters());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    FoundMarker marker;
    marker.id = ids[i];
    for (std::size_t c = 0; c < 4; ++c)
      marker.corners[c] =
          Eigen::Vector2d(static_cast<double>(corners[i][c].x), static_cast<double>(corners[i][c].y)) + shift;
    const bool known = std::any_of(found.begin(), found.end(), [&](const FoundMarker& other) {
      return other.id == marker.id && (other.corners[0] - marker.corners[0]).norm() < 3.0;
    });
    if (!known) found.push_back(marker);
  }
}

cv::Mat view_of(const GreyImage& picture) {
  // OpenCV only reads it.
  return {picture.height, picture.width, CV_8UC1, const_cast<std::uint8_t*>(picture.pixels.data())};  // NOLINT
}

}  // namespace

std::array<std::array<bool, marker_cells>, marker_cells> marker_pattern(int id) {
  std::array<std::array<bool, marker_cells>, marker_cells> pattern{};
  const cv::Mat bits =
      cv::aruco::Dictionary::getBitsFromByteList(dictionary()->bytesList.rowRange(id, id + 1), marker_cells - 2);
  for (int row = 0; row < marker_cells - 2; ++row) {
    for (int column = 0; column < marker_cells - 2; ++column) {
      pattern[static_cast<std::size_t>(row) + 1][static_cast<std::size_t>(column) + 1] =
          bits.at<std::uint8_t>(row, column) != 0;
    }
  }
  return pattern;
}

std::vector<FoundMarker> search_markers(const GreyImage& picture) {
  std::vector<FoundMarker> found;
  append_markers(view_of(picture), Eigen::Vector2d::Zero(), found);
  return found;
}

std::vector<FoundMarker> search_markers(const GreyImage& picture, const std::vector<PictureBox>& boxes) {
  std::vector<FoundMarker> found;
  const cv::Mat whole = view_of(picture);
  for (const PictureBox& box : boxes) {
    const cv::Rect part =
        cv::Rect(box.x, box.y, box.width, box.height) & cv::Rect(0, 0, picture.width, picture.height);
    if (part.width < 16 || part.height < 16) continue;
    append_markers(whole(part), {part.x, part.y}, found);
  }
  return found;
}

bool is_mirrored(const GreyImage& picture) {
  const std::size_t as_it_is = search_markers(picture).size();
  cv::Mat flipped;
  cv::flip(view_of(picture), flipped, 1);
  std::vector<FoundMarker> found;
  append_markers(flipped, Eigen::Vector2d::Zero(), found);
  return found.size() > 2 * as_it_is;
}

}  // namespace bodkin::tracking
