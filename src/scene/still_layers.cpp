#include "scene/still_layers.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scene/blend.h"

namespace bodkin::scene {

namespace {

constexpr float soft_from = 0.72F;  // of the oval's radius: inside, the skin is gone

// Behind the patient, at the top of the picture and at its bottom, 0xRRGGBB.
constexpr std::uint32_t sky_top = 0x0E1218, sky_bottom = 0x28323E;

// Mean of samples.
class Mean {
 public:
  void add(std::uint32_t colour) {
    red_blue_ += colour & 0xFF00FFU;
    green_ += colour & 0x00FF00U;
    ++count_;
  }
  std::uint32_t pixel() const {
    if (count_ == 1) return 0xFF000000U | static_cast<std::uint32_t>(red_blue_ | green_);
    const std::uint32_t red = static_cast<std::uint32_t>(red_blue_ >> 16U) / count_;
    const std::uint32_t blue = static_cast<std::uint32_t>(red_blue_ & 0xFFFFU) / count_;
    const std::uint32_t green = static_cast<std::uint32_t>(green_ >> 8U) / count_;
    return 0xFF000000U | (red << 16U) | (green << 8U) | blue;
  }

 private:
  std::uint64_t red_blue_ = 0, green_ = 0;  // room for 256 samples
  std::uint32_t count_ = 0;
};

// Of a colour 0xAARRGGBB, 0 to 1.
float opacity_of(std::uint32_t colour) {
  return static_cast<float>(colour >> 24U) * (1.0F / 255.0F);
}

// The section that contains a place.
template <typename Number>
PixelBox sample_box(Number right, Number down) {
  const auto limit = static_cast<Number>(1e6);
  const int x = static_cast<int>(std::floor(std::clamp(right, -limit, limit)));
  const int y = static_cast<int>(std::floor(std::clamp(down, -limit, limit)));
  return {x, y, x + 1, y + 1};
}

// Bounding box in samples of a patch's points.
PixelBox box_of(const InnerPatch& inner, const Projection& projection) {
  PixelBox box;
  for (const InnerPatch::Part& part : inner.parts()) {
    for (const Eigen::Vector3f& point : part.mesh.points) {
      if (const std::optional<Place> place = projection.place(point.cast<double>()))
        box = box.join(sample_box(place->x, place->y));
    }
  }
  return box;
}

// `box` lies within both.
void copy(const Layer& from, const PixelBox& box, Layer& to) {
  for (int y = box.top; y < box.bottom; ++y) {
    std::copy(from.colours(y) + box.left, from.colours(y) + box.right, to.colours(y) + box.left);
    std::copy(from.nearness(y) + box.left, from.nearness(y) + box.right, to.nearness(y) + box.left);
  }
}

}  // namespace

Material material_of(const PatientSurface& part, std::uint32_t colour) {
  Material material{.colour = colour};
  switch (part.kind) {
    case SurfaceKind::skin:
      material.gloss = 0.04F;
      break;
    case SurfaceKind::bone:
      material.gloss = 0.10F;
      break;
    case SurfaceKind::tissue:
      material.gloss = 0.16F;
      break;
    case SurfaceKind::forbidden:
      material.gloss = 0.16F;
      material.rim = 0.75F;
      break;
  }
  return material;
}

StillLayers::StillLayers(int width, int height, int detail)
    : width_(width),
      height_(height),
      detail_(detail),
      opaque_(box().times(detail)),
      skin_(box().times(detail)),
      sky_rows_(static_cast<std::size_t>(height), 0U) {
  for (int y = 0; y < height_; ++y) {
    const float down = height_ > 1 ? static_cast<float>(y) / static_cast<float>(height_ - 1) : 0.0F;
    sky_rows_[static_cast<std::size_t>(y)] = blend(sky_top, sky_bottom, down);
  }
}

// The sections of a surface that are opaque, or those that are not. `mesh`: the surface or a piece of it; `sections`
// divide `triangles`.
void StillLayers::draw_sections(const PatientSurface& part, const SceneMesh& mesh,
                                std::span<const SurfaceSection> sections,
                                std::span<const std::array<std::int32_t, 3>> triangles, const Look& look,
                                const Projection& projection, bool opaque) {
  std::optional<std::uint32_t> shaded;
  for (const SurfaceSection& section : sections) {
    const Appearance now = appearance(look, part, section.name);
    if (!now.drawn() || (now.opacity >= 1.0F) != opaque) continue;
    if (shaded != now.colour) shade(mesh, material_of(part, now.colour), projection, points_);
    shaded = now.colour;
    const auto shown = triangles.subspan(section.first, section.count);
    if (opaque) {
      draw_triangles(points_, shown, true, opaque_);
    } else {
      scratch_.resize(opaque_.box());
      scratch_.clear();
      draw_triangles(points_, shown, true, scratch_);
      add_to_veil(now.opacity);
    }
  }
}

// `moving`: the part that draw_inner() draws if it is opaque; null: none.
void StillLayers::draw_inside(const PatientSurface& part, const InnerPatch::Part* moving, const Look& look,
                              const Projection& projection, bool opaque) {
  if (moving != nullptr && opaque) {
    draw_sections(part, part.mesh, moving->around, moving->still_triangles, look, projection, opaque);
    return;
  }
  const SurfaceSection whole{part.name, 0, part.mesh.triangles.size()};
  const std::span<const SurfaceSection> sections =
      part.sections.empty() ? std::span<const SurfaceSection>(&whole, 1) : std::span(part.sections);
  draw_sections(part, part.mesh, sections, part.mesh.triangles, look, projection, opaque);
}

// The surface in `scratch_`, where no opaque one covers it. Of two translucent surfaces the nearer is drawn over the
// farther.
void StillLayers::add_to_veil(float opacity) {
  if (veil_.empty()) {
    veil_.resize(opaque_.box());
    veil_.clear();
  }
  const PixelBox all = veil_.box();
  for (int y = all.top; y < all.bottom; ++y) {
    const float *near = scratch_.nearness(y), *near_opaque = opaque_.nearness(y);
    const std::uint32_t* colours = scratch_.colours(y);
    float* near_veil = veil_.nearness(y);
    std::uint32_t* veil = veil_.colours(y);
    for (int x = all.left; x < all.right; ++x) {
      if (near[x] <= near_opaque[x] || near[x] <= 0.0F) continue;
      const bool first = near_veil[x] <= 0.0F, over = near[x] > near_veil[x];
      const float before = first ? 0.0F : opacity_of(veil[x]);
      const float upper = over ? opacity : before, lower = over ? before : opacity;
      const float together = upper + lower * (1.0F - upper);
      const std::uint32_t upper_colour = (over ? colours[x] : veil[x]) & 0xFFFFFFU;
      const std::uint32_t lower_colour = (over ? veil[x] : colours[x]) & 0xFFFFFFU;
      const std::uint32_t colour = first ? upper_colour : blend(lower_colour, upper_colour, upper / together);
      veil[x] = colour | (static_cast<std::uint32_t>(together * 255.0F + 0.5F) << 24U);
      near_veil[x] = std::max(near[x], near_veil[x]);
    }
  }
}

void StillLayers::draw(const PatientSurfaces& surfaces, std::span<const std::array<std::int32_t, 3>> skin_triangles,
                       const InnerPatch& inner, const Camera& camera, const Look& look,
                       std::span<const std::uint32_t> skin_tint) {
  const Projection projection = samples(camera);
  opaque_.clear();
  skin_.clear();
  veil_ = Layer();
  const bool closed = skin_is_closed(look, surfaces);
  for (const bool opaque : {true, false}) {
    for (std::size_t i = 0; i < surfaces.parts.size(); ++i) {
      const PatientSurface& part = surfaces.parts[i];
      if (part.kind != SurfaceKind::skin && !closed) draw_inside(part, inner.part_of(i), look, projection, opaque);
    }
  }
  scratch_ = Layer();
  const PatientSurface& skin = surfaces.parts.front();
  const Appearance outside = appearance(look, skin);
  if (outside.drawn()) {
    shade(skin.mesh, material_of(skin, outside.colour), projection, points_, skin_tint);
    draw_triangles(points_, skin_triangles, true, skin_);
  }
  under_patch_.resize({});
  under_inner_.resize({});
}

PixelBox StillLayers::draw_inner(const PatientSurfaces& surfaces, const InnerPatch& inner, const Camera& camera,
                                 const Look& look) {
  PixelBox changed = under_inner_.box();
  copy(under_inner_, under_inner_.box(), opaque_);
  under_inner_.resize({});
  const Projection projection = samples(camera);
  const PixelBox covered =
      skin_is_closed(look, surfaces) ? PixelBox{} : box_of(inner, projection).meet(opaque_.box());
  if (!covered.empty()) {
    under_inner_.resize(covered);
    copy(opaque_, covered, under_inner_);
    changed = changed.join(covered);
    for (const InnerPatch::Part& part : inner.parts()) {
      draw_sections(surfaces.parts[part.surface], part.mesh, part.sections, part.mesh.triangles, look, projection,
                    true);
    }
  }
  return changed.over(detail_).meet(box());
}

PixelBox StillLayers::draw_patch(std::span<const ScreenPoint> points,
                                 std::span<const std::array<std::int32_t, 3>> triangles) {
  PixelBox covered;
  for (const ScreenPoint& point : points) {
    if (point.nearness <= 0.0F) continue;
    covered = covered.join(sample_box(point.x, point.y));
  }
  covered = covered.meet(skin_.box());
  if (covered.empty()) covered = {};
  const PixelBox changed = covered.join(under_patch_.box());
  copy(under_patch_, under_patch_.box(), skin_);
  under_patch_.resize(covered);
  copy(skin_, covered, under_patch_);
  draw_triangles(points, triangles, true, skin_);
  return changed.over(detail_).meet(box());
}

void StillLayers::set_look(const Camera& camera, Preset preset, const Appearance& skin, const Opening& opening) {
  opacity_ = skin.shown ? skin.opacity : 0.0F;
  cut_ = false;
  if (preset != Preset::cut_away) return;
  const Projection projection(camera, width_, height_);
  const std::optional<Place> centre = projection.place(opening.centre);
  if (!centre) return;
  cut_ = true;
  const double scale = projection.pixels_per_mm(opening.centre);
  oval_centre_ = centre->pixel().cast<float>();
  per_radius_ =
      Eigen::Vector2d(1.0 / (scale * opening.half_width), 1.0 / (scale * opening.half_height)).cast<float>();
}

float StillLayers::skin_at(int x, int y) const {
  if (!cut_) return opacity_;
  const Eigen::Vector2f from =
      (Eigen::Vector2f(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F) - oval_centre_)
          .cwiseProduct(per_radius_);
  const float square = from.squaredNorm();
  if (square >= 1.0F) return opacity_;
  if (square <= soft_from * soft_from) return 0.0F;
  const float t = (std::sqrt(square) - soft_from) / (1.0F - soft_from);
  return opacity_ * t * t * (3.0F - 2.0F * t);
}

void StillLayers::compose(const PixelBox& wanted, Picture& picture) const {
  const PixelBox pixels = wanted.meet(box());
  for (int y = pixels.top; y < pixels.bottom; ++y) {
    const std::uint32_t sky = sky_at(y);
    std::uint32_t* row = picture.row(y);
    for (int x = pixels.left; x < pixels.right; ++x) {
      const float skin = skin_at(x, y);
      Mean mean;
      for (int sample_y = y * detail_; sample_y < (y + 1) * detail_; ++sample_y) {
        const float* near = opaque_.nearness(sample_y);
        const float* near_skin = skin_.nearness(sample_y);
        const float* near_veil = veil_.empty() ? nullptr : veil_.nearness(sample_y);
        for (int sample = x * detail_; sample < (x + 1) * detail_; ++sample) {
          std::uint32_t colour = near[sample] > 0.0F ? opaque_.colours(sample_y)[sample] : sky;
          if (near_veil != nullptr && near_veil[sample] > near[sample]) {
            const std::uint32_t veil = veil_.colours(sample_y)[sample];
            colour = blend(colour, veil & 0xFFFFFFU, opacity_of(veil));
          }
          if (skin > 0.0F && near_skin[sample] > near[sample]) {
            colour = blend(colour, skin_.colours(sample_y)[sample], skin);
          }
          mean.add(colour);
        }
      }
      row[x] = mean.pixel();
    }
  }
}

std::uint32_t StillLayers::mix(int x, int y, float nearness, std::uint32_t colour, float opacity,
                               float behind) const {
  const float skin = skin_at(x, y);
  const std::uint32_t sky = sky_at(y);
  Mean mean;
  for (int sample_y = y * detail_; sample_y < (y + 1) * detail_; ++sample_y) {
    for (int sample = x * detail_; sample < (x + 1) * detail_; ++sample) {
      const float near = opaque_.nearness(sample_y)[sample], near_skin = skin_.nearness(sample_y)[sample];
      const float near_veil = veil_.empty() ? 0.0F : veil_.nearness(sample_y)[sample];
      const float seen = nearness >= near ? opacity : opacity * behind;
      std::uint32_t result = near > 0.0F ? opaque_.colours(sample_y)[sample] : sky;
      const bool skin_before_opaque = near_skin > near, skin_before_it = near_skin > nearness;
      const bool veil_before_opaque = near_veil > near, veil_before_it = near_veil > nearness;
      const std::uint32_t skin_colour = skin_.colours(sample_y)[sample];
      const std::uint32_t veil = veil_before_opaque ? veil_.colours(sample_y)[sample] : 0U;
      if (veil_before_opaque && !veil_before_it) result = blend(result, veil & 0xFFFFFFU, opacity_of(veil));
      if (skin_before_opaque && !skin_before_it) result = blend(result, skin_colour, skin);
      result = blend(result, colour, seen);
      if (veil_before_opaque && veil_before_it) result = blend(result, veil & 0xFFFFFFU, opacity_of(veil));
      if (skin_before_opaque && skin_before_it) result = blend(result, skin_colour, skin);
      mean.add(result);
    }
  }
  return mean.pixel();
}

float StillLayers::nearness_at(int x, int y) const {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return 0.0F;
  const int column = x * detail_ + detail_ / 2, row = y * detail_ + detail_ / 2;
  float near = opaque_.nearness(row)[column];
  if (!veil_.empty()) near = std::max(near, veil_.nearness(row)[column]);
  return skin_at(x, y) > 0.0F ? std::max(near, skin_.nearness(row)[column]) : near;
}

}  // namespace bodkin::scene
