#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/geometry.h"

namespace bodkin::imaging {

// Reasons why an image, or parts of it, is black.
enum class NoImage : std::uint8_t { none, outside_volume, no_contact, inside_body, broken_pose };

// One sentence for people, empty for `none`.
std::string_view reason(NoImage why);

// One image of an ultrasound machine. Rows run from the face into the depth, columns towards the orientation marker
// (PLUS's "MF").
struct UltrasoundFrame {
  int width = 0, height = 0;         // pixels
  double pixel = 0.0;                // mm, square
  Vec3 corner = Vec3::Zero();        // mm, centre of the top left pixel in the probe's frame; z = 0
  std::vector<std::uint8_t> pixels;  // height x width, 0 to 255; 0 outside the field of view
  NoImage why = NoImage::none;       // reason why all of it is black
  double contact = 0.0;              // fraction of the face that touches skin or gel, 0 to 1
  double press = 0.0;                // mm that the face is pushed into the patient at rest, at its middle; >= 0

  // The image's pose: a pixel (column, row, 0) in units of pixels becomes, multiplied by `pixel`, mm in the patient.
  Pose image_to_patient(const Pose& probe) const { return probe * Eigen::Translation3d(corner); }
};

}  // namespace bodkin::imaging
