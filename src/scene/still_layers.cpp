#include "scene/still_layers.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scene/blend.h"

namespace bodkin::scene {

namespace {

constexpr float soft_from = 0.72F;  // of the oval's radius: inside, the skin is gone

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

// `box` lies within both.
void copy(const Layer& from, const PixelBox& box, Layer& to) {
  for (int y = box.top; y < box.bottom; ++y) {
    std::copy(from.colours(y) + box.left, from.colours(y) + box.right, to.colours(y) + box.left);
    std::copy(from.nearness(y) + box.left, from.nearness(y) + box.right, to.nearness(y) + box.left);
  }
}

}  // namespace

Material material_of(const PatientSurface& part) {
  Material material{.colour = part.colour};
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
      sky_rows_(static_cast<std::size_t>(height), 0U) {}

void StillLayers::draw(const PatientSurfaces& surfaces, std::span<const std::array<std::int32_t, 3>> skin_triangles,
                       const Camera& camera, Preset preset, std::span<const std::uint32_t> skin_tint) {
  const Projection projection = samples(camera);
  opaque_.clear();
  skin_.clear();
  for (const PatientSurface& part : surfaces.parts) {
    if (!shows(preset, part.kind)) continue;
    if (part.kind != SurfaceKind::skin && skin_opacity(preset) == 1.0F && preset == Preset::skin) continue;
    const bool is_skin = part.kind == SurfaceKind::skin;
    shade(part.mesh, material_of(part), projection, points_, is_skin ? skin_tint : std::span<const std::uint32_t>{});
    if (is_skin) {
      draw_triangles(points_, skin_triangles, true, skin_);
    } else {
      draw_triangles(points_, part.mesh.triangles, true, opaque_);
    }
  }
  under_patch_.resize({});
}

PixelBox StillLayers::draw_patch(std::span<const ScreenPoint> points,
                                 std::span<const std::array<std::int32_t, 3>> triangles) {
  PixelBox covered;
  for (const ScreenPoint& point : points) {
    if (point.nearness <= 0.0F) continue;
    const float limit = 1e6F;
    const int x = static_cast<int>(std::floor(std::clamp(point.x, -limit, limit)));
    const int y = static_cast<int>(std::floor(std::clamp(point.y, -limit, limit)));
    covered = covered.join({x, y, x + 1, y + 1});
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

void StillLayers::set_look(const Camera& camera, Preset preset, const Opening& opening, const Sky& sky) {
  for (int y = 0; y < height_; ++y) {
    const float down = height_ > 1 ? static_cast<float>(y) / static_cast<float>(height_ - 1) : 0.0F;
    sky_rows_[static_cast<std::size_t>(y)] = blend(sky.top & 0xFFFFFFU, sky.bottom & 0xFFFFFFU, down);
  }
  opacity_ = skin_opacity(preset);
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
        for (int sample = x * detail_; sample < (x + 1) * detail_; ++sample) {
          std::uint32_t colour = near[sample] > 0.0F ? opaque_.colours(sample_y)[sample] : sky;
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
      const float seen = nearness >= near ? opacity : opacity * behind;
      std::uint32_t result = near > 0.0F ? opaque_.colours(sample_y)[sample] : sky;
      const bool skin_before_opaque = near_skin > near, skin_before_it = near_skin > nearness;
      const std::uint32_t skin_colour = skin_.colours(sample_y)[sample];
      if (skin_before_opaque && !skin_before_it) result = blend(result, skin_colour, skin);
      result = blend(result, colour, seen);
      if (skin_before_opaque && skin_before_it) result = blend(result, skin_colour, skin);
      mean.add(result);
    }
  }
  return mean.pixel();
}

float StillLayers::nearness_at(int x, int y) const {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return 0.0F;
  const int column = x * detail_ + detail_ / 2, row = y * detail_ + detail_ / 2;
  const float near = opaque_.nearness(row)[column];
  return skin_at(x, y) > 0.0F ? std::max(near, skin_.nearness(row)[column]) : near;
}

}  // namespace bodkin::scene
