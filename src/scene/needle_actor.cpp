#include "scene/needle_actor.h"

#include <algorithm>
#include <cmath>

#include "scene/blend.h"
#include "scene/strokes.h"

namespace bodkin::scene {

namespace {

// Sizes of a common plastic hub, mm. [D]
constexpr double hub_radius = 3.0, hub_length = 16.0, collar_radius = 3.6, collar_length = 5.0;
constexpr double ring_spacing = 10.0, ring_width = 1.2;
constexpr std::uint32_t steel_tone = 0xE9EDF2, ring_tone = 0x15181C, orange_ring_tone = 0xFF8A1E;
constexpr std::uint32_t ghost_colour = 0x4DA3FF, ghost_colour_on_bone = 0xFF5A52;

// A round rod lit from the upper left: `across` is the sine of the angle about it.
std::uint32_t lit_rod(std::uint32_t colour, double across, double gloss) {
  const double away = across + 0.35, light = std::clamp(1.08 - 0.62 * away * away, 0.25, 1.0);
  const double shine = std::clamp(gloss * (1.0 - 9.0 * away * away), 0.0, 1.0);
  return blend(blend(0x000000, colour, static_cast<float>(light)), 0xFFFFFF, static_cast<float>(shine));
}

struct HubAxis {
  Vec3 end, direction;  // of the shaft at the hub, LPS mm; unit, towards the tip
};

HubAxis hub_axis(const NeedleLook& needle) {
  const std::size_t points = needle.shaft.size();
  if (points >= 2) {
    return {needle.shaft.back(), (needle.shaft[points - 2] - needle.shaft.back()).normalized()};
  }
  const Vec3 axis = needle_axis(needle.pose);
  return {needle.pose.translation() - needle.shape.length * axis, axis};
}

void draw_piece(const Vec3& from, const Vec3& to, double before, const NeedleLook& needle,
                const Projection& projection, MovingPixels& pixels) {
  const Rod shaft{from, to, 0.5 * needle.shape.outer_diameter, 2.0};
  draw_rod(
      shaft,
      [&](double along, double across, float& opacity) {
        opacity = needle.opacity;
        const double from_tip = before + along, nearest = std::round(from_tip / ring_spacing);
        const bool marked = nearest >= 1.0 && std::abs(from_tip - nearest * ring_spacing) < 0.5 * ring_width;
        const bool fiftieth = std::fmod(nearest, 5.0) == 0.0;
        return lit_rod(marked ? (fiftieth ? orange_ring_tone : ring_tone) : steel_tone, across, marked ? 0.0 : 0.5);
      },
      projection, pixels);
}

void draw_hub(const HubAxis& axis, std::uint32_t colour, float opacity, const Projection& projection,
              MovingPixels& pixels) {
  const auto body = [&](double, double across, float& strength) {
    strength = opacity;
    return lit_rod(colour, across, 0.25);
  };
  const Vec3 middle = axis.end - (hub_length - collar_length) * axis.direction;
  draw_rod({axis.end, middle, hub_radius, 4.0}, body, projection, pixels);
  draw_rod({middle, axis.end - hub_length * axis.direction, collar_radius, 5.0}, body, projection, pixels);
}

}  // namespace

bool same_look(const NeedleLook& a, const NeedleLook& b) {
  return a.pose.matrix() == b.pose.matrix() && a.shape.outer_diameter == b.shape.outer_diameter &&
         a.shape.length == b.shape.length && a.shaft == b.shaft && a.hub_colour == b.hub_colour &&
         a.ghost == b.ghost && a.ghost_on_bone == b.ghost_on_bone && a.opacity == b.opacity;
}

void draw_needle(const NeedleLook& needle, const Projection& projection, MovingPixels& pixels) {
  const HubAxis hub = hub_axis(needle);
  if (needle.ghost != 0.0) {
    const HubAxis wanted{hub.end + needle.ghost * hub.direction, hub.direction};
    draw_hub(wanted, needle.ghost_on_bone ? ghost_colour_on_bone : ghost_colour, 0.4F, projection, pixels);
  }
  if (needle.shaft.size() >= 2) {
    double before = 0.0;
    for (std::size_t i = 0; i + 1 < needle.shaft.size(); ++i) {
      draw_piece(needle.shaft[i], needle.shaft[i + 1], before, needle, projection, pixels);
      before += (needle.shaft[i + 1] - needle.shaft[i]).norm();
    }
  } else {
    draw_piece(needle.pose.translation(), hub.end, 0.0, needle, projection, pixels);
  }
  draw_hub(hub, needle.hub_colour, needle.opacity, projection, pixels);
}

Vec3 hub_end(const NeedleLook& needle) {
  const HubAxis hub = hub_axis(needle);
  return hub.end - hub_length * hub.direction;
}

Vec3 hub_middle(const NeedleLook& needle) {
  const HubAxis hub = hub_axis(needle);
  return hub.end - 0.5 * hub_length * hub.direction;
}

}  // namespace bodkin::scene
