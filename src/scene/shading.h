#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/camera.h"
#include "scene/mesh.h"
#include "scene/raster.h"

namespace bodkin::scene {

// How a surface throws back light.
struct Material {
  std::uint32_t colour = 0x808080;  // 0xRRGGBB
  float gloss = 0.1F;               // share of the highlight, 0 to 1
  float rim = 0.0F;                 // share of `rim_colour` where the surface turns away from the viewer, 0 to 1
  std::uint32_t rim_colour = 0xFF5A52;
};

// The points of a mesh in the picture, lit: by the sky, as far as it can be seen from the point (its openness), by a
// lamp at the viewer's upper left and by a weaker one at his right. The lamps turn with the camera. `tint`:
// 0xAARRGGBB of each point, laid over the material's colour by its first part; empty: none.
void shade(const SceneMesh& mesh, const Material& material, const Projection& projection,
           std::vector<ScreenPoint>& points, std::span<const std::uint32_t> tint = {});

}  // namespace bodkin::scene
