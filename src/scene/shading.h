#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/camera.h"
#include "scene/mesh.h"
#include "scene/raster.h"

namespace bodkin::scene {

// Optical properties of a surface.
struct Material {
  std::uint32_t colour = 0x808080;  // 0xRRGGBB
  float gloss = 0.1F;               // strength of the highlight, 0 to 1
  float rim = 0.0F;                 // strength of `rim_colour` where the surface turns away from the viewer, 0 to 1
  std::uint32_t rim_colour = 0xFF5A52;
};

// The points of a mesh in the image, lit: by the visible part of the sky (openness), by a lamp at the viewer's upper
// left and by a weaker one at the right. The lamps turn with the camera. `tint`: 0xAARRGGBB of each point, blended
// over the material's colour by its alpha; empty: none.
void shade(const SceneMesh& mesh, const Material& material, const Projection& projection,
           std::vector<ScreenPoint>& points, std::span<const std::uint32_t> tint = {});

}  // namespace bodkin::scene
