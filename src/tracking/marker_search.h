#pragma once

#include <array>
#include <vector>

#include "tracking/grey_picture.h"

#include "core/geometry.h"

namespace bodkin::tracking {

// A marker found in a picture: upper left, upper right, lower right, lower left corner of its black square, pixels.
struct FoundMarker {
  int id = -1;
  std::array<Eigen::Vector2d, 4> corners;
};

// A part of a picture, pixels.
struct PictureBox {
  int x = 0, y = 0, width = 0, height = 0;
};

// Markers in the whole picture, or in these parts of it. Corners are refined to a part of a pixel; they still carry
// the bias of the camera's tone curve, which photometric refinement removes.
std::vector<FoundMarker> search_markers(const GreyPicture& picture);
std::vector<FoundMarker> search_markers(const GreyPicture& picture, const std::vector<PictureBox>& boxes);

// The picture is mirrored left to right: more than twice as many markers are found in its mirror image. (Some
// patterns are the mirror images of others, so a few may be found as it is.)
bool is_mirrored(const GreyPicture& picture);

}  // namespace bodkin::tracking
