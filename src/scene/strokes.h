#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "scene/camera.h"
#include "scene/moving_pixels.h"

namespace bodkin::scene {

// A straight round rod between two points, or a line of a given width. Drawn from its equations, without triangles:
// smooth at any width, and each pixel knows its position on the rod.
struct Rod {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  // LPS mm
  double radius = 0.0;                          // mm
  double least_width = 2.0;                     // pixels, smallest width
  float behind = 0.35F;                         // opacity where the patient is in front
};

// The colour of a rod, 0xRRGGBB, `along` mm from its beginning and `across` it: -1 at one edge, 1 at the other.
// `opacity` is 1 and may be lowered.
using RodColour = std::function<std::uint32_t(double along, double across, float& opacity)>;

void draw_rod(const Rod& rod, const RodColour& colour, const Projection& projection, MovingPixels& pixels);

// A line of one colour through points, `width` pixels wide. `dash`: mm of dashes and gaps; 0: solid.
struct Line {
  std::uint32_t colour = 0xFFFFFF;
  double width = 1.5;
  double dash = 0.0;
  float opacity = 1.0F, behind = 0.35F;
};

void draw_line(std::span<const Vec3> points, const Line& line, const Projection& projection, MovingPixels& pixels);
// A circle about `centre`, perpendicular to `axis`.
void draw_circle(const Vec3& centre, const Vec3& axis, double radius, const Line& line, const Projection& projection,
                 MovingPixels& pixels);

}  // namespace bodkin::scene
