#pragma once

#include <array>
#include <cstdint>

#include "scene/camera.h"
#include "scene/picture.h"

namespace bodkin::scene {

enum class Stereo : std::uint8_t {
  off,
  side_by_side,  // left half for the left eye, right half for the right one
  anaglyph       // red for the left eye, cyan for the right one
};

// Cameras of the left and the right eye: both look at the focus, separated by a comfortable 1/30 of its distance.
std::array<Camera, 2> eyes(const Camera& camera);

// The red of the left image, with its own brightness for the colours that red glass cannot show, and green and blue
// of the right one (half-colour anaglyph). Images of one size.
void mix_anaglyph(const Picture& left, const Picture& right, Picture& mixed);

}  // namespace bodkin::scene
