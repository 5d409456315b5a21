#pragma once

#include <array>
#include <vector>

#include "tracking/grey_image.h"

#include "core/geometry.h"

namespace bodkin::tracking {

// A marker found in an image: upper left, upper right, lower right, lower left corner of its black square, pixels.
struct FoundMarker {
  int id = -1;
  std::array<Eigen::Vector2d, 4> corners;
};

// A part of an image, pixels.
struct PictureBox {
  int x = 0, y = 0, width = 0, height = 0;
};

// Markers in the whole image, or in these parts of it. Corners are refined to a fraction of a pixel; they still have
// the bias of the camera's tone curve, which photometric refinement removes.
std::vector<FoundMarker> search_markers(const GreyImage& picture);
std::vector<FoundMarker> search_markers(const GreyImage& picture, const std::vector<PictureBox>& boxes);

// Whether the image is mirrored left to right: more than twice as many markers are found in its mirror image. (Some
// patterns are the mirror images of others, so a few may be found in the image itself.)
bool is_mirrored(const GreyImage& picture);

}  // namespace bodkin::tracking
