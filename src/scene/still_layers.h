#pragma once

#include <cstdint>
#include <vector>

#include "scene/camera.h"
#include "scene/inner_patch.h"
#include "scene/look.h"
#include "scene/picture.h"
#include "scene/raster.h"
#include "scene/shading.h"
#include "scene/surfaces.h"

namespace bodkin::scene {

// The opening of a cut-away: a soft-edged oval about a point in the image.
struct Opening {
  Vec3 centre = Vec3::Zero();  // LPS mm
  double half_width = 95.0;    // mm
  double half_height = 80.0;   // mm
};

// The lighting of a part in this colour; forbidden parts have a bright rim.
Material material_of(const PatientSurface& part, std::uint32_t colour);

// The patient as seen by the camera, stored in layers while camera and body stand still: opaque parts, a veil of all
// translucent parts, and the skin, each with colours and depths, `detail` x `detail` samples per pixel. Moving
// objects (needles, marks) are blended between them by depth, so that a frame costs only the pixels that change. The
// veil has the depth of the nearest translucent surface: a needle between two of them is drawn as behind both.
class StillLayers {
 public:
  StillLayers(int width, int height, int detail);

  int detail() const { return detail_; }
  // Pixels of the image.
  PixelBox box() const { return {0, 0, width_, height_}; }
  // The camera with all samples for pixels.
  Projection samples(const Camera& camera) const { return {camera, width_ * detail_, height_ * detail_}; }

  // Draws everything shown by `look` except the skin, and the triangles of the skin in `skin_triangles`; `skin_tint`
  // as for shade(). Opaque parts of `inner` are left to draw_inner().
  void draw(const PatientSurfaces& surfaces, std::span<const std::array<std::int32_t, 3>> skin_triangles,
            const InnerPatch& inner, const Camera& camera, const Look& look,
            std::span<const std::uint32_t> skin_tint = {});
  // Draws the opaque parts of `inner` at present, replacing the last call. Returns the pixels that may have changed.
  // Translucent surfaces stay as drawn by draw().
  PixelBox draw_inner(const PatientSurfaces& surfaces, const InnerPatch& inner, const Camera& camera,
                      const Look& look);
  // Draws the replacement of the skin's other triangles at present; `points` in samples. Replaces the last call.
  // Returns the pixels that may have changed.
  PixelBox draw_patch(std::span<const ScreenPoint> points, std::span<const std::array<std::int32_t, 3>> triangles);

  // Sets the opacity of the skin, and the opening. Call compose() afterwards.
  void set_look(const Camera& camera, Preset preset, const Appearance& skin, const Opening& opening);
  // Writes these pixels of the image.
  void compose(const PixelBox& box, Picture& picture) const;

  // Blends a sample of something thin over pixel (x, y) of compose(): `opacity` 0 to 1 where it is in front of all
  // opaque parts, `behind` times that otherwise; the skin covers it as far as the skin is nearer.
  std::uint32_t mix(int x, int y, float nearness, std::uint32_t colour, float opacity, float behind) const;

  // Of the nearest visible object at a pixel, skin or not; 0: the sky.
  float nearness_at(int x, int y) const;

 private:
  void draw_sections(const PatientSurface& part, const SceneMesh& mesh, std::span<const SurfaceSection> sections,
                     std::span<const std::array<std::int32_t, 3>> triangles, const Look& look,
                     const Projection& projection, bool opaque);
  void draw_inside(const PatientSurface& part, const InnerPatch::Part* moving, const Look& look,
                   const Projection& projection, bool opaque);
  void add_to_veil(float opacity);
  float skin_at(int x, int y) const;
  std::uint32_t sky_at(int y) const { return sky_rows_[static_cast<std::size_t>(y)]; }

  int width_, height_, detail_;
  Layer opaque_;       // samples
  Layer veil_;         // samples, colours 0xAARRGGBB; empty: nothing is translucent
  Layer scratch_;      // samples, one translucent surface
  Layer skin_;         // samples, with the patch
  Layer under_patch_;  // samples, what the patch covers
  Layer under_inner_;  // samples, what draw_inner() covers
  std::vector<ScreenPoint> points_;
  std::vector<std::uint32_t> sky_rows_;  // of pixels
  float opacity_ = 1.0F;
  bool cut_ = false;
  Eigen::Vector2f oval_centre_ = Eigen::Vector2f::Zero();  // pixels
  Eigen::Vector2f per_radius_ = Eigen::Vector2f::Zero();   // 1 / pixels
};

}  // namespace bodkin::scene
