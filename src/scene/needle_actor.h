#pragma once

#include <cstdint>
#include <vector>

#include "scene/camera.h"
#include "scene/moving_pixels.h"

#include "anatomy/needle.h"

namespace bodkin::scene {

// A needle for display.
struct NeedleLook {
  Pose pose = Pose::Identity();  // of the tip, LPS mm; the third axis runs from hub to tip
  anatomy::Needle shape;
  std::vector<Vec3> shaft;  // LPS mm, from the tip to the hub, of a needle that bends; empty: straight
  std::uint32_t hub_colour = 0x2B323B;
  // Commanded position of the hub, mm ahead of the hub along the axis, while tissue holds the needle back; 0: no
  // offset.
  double ghost = 0.0;
  bool ghost_on_bone = false;  // drawn red
  float opacity = 1.0F;        // lower for a needle left in the body
};

// Whether they look alike.
bool same_look(const NeedleLook& a, const NeedleLook& b);

// Draws the needle in its true gauge, but at least 2 pixels wide: steel, with a black ring at every 10 mm from the
// tip and an orange one at 50 and 100, and a hub of 6 mm. Parts hidden by the patient show through faintly.
void draw_needle(const NeedleLook& needle, const Projection& projection, MovingPixels& pixels);

// The end of the hub, LPS mm: the needle's farthest point, where it is dragged.
Vec3 hub_end(const NeedleLook& needle);
// Middle of the hub, LPS mm.
Vec3 hub_middle(const NeedleLook& needle);

}  // namespace bodkin::scene
