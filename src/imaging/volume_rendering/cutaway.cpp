#include "imaging/volume_rendering/cutaway.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace bodkin::imaging {

namespace {

constexpr int oval_tile = 24;     // rays along each side: neighbours share voxels
constexpr float steepest = 4.0F;  // times the bend: allowed difference between neighbours of a ray that is not cast
// Of the bend, for a ray between four at its corners: they are farther off, and the rays between them and it inherit
// its error.
constexpr float of_corners = 2.0F / 3.0F;
// Of the bend: allowed difference of a ray from four at its corners, by their difference from those beyond. Without
// it a line that passes between the four would be missed.
constexpr float of_line = 1.0F / 3.0F;
constexpr float coarse_bend = 1.5F;  // times the bend, at half the resolution, which itself is less accurate
constexpr float least_share = 0.1F;  // of the view in the image, by which its error is divided

std::uint8_t blended(std::uint8_t below, float light, float opacity, float share) {
  const float value = (1.0F - share * opacity) * static_cast<float>(below) + share * 255.0F * light;
  return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
}

using Place = std::array<int, 2>;  // column and row, of a ray
// Around a ray: two opposite to each other, and two opposite across from them.
constexpr std::array<Place, 4> at_corners = {{{-1, -1}, {1, 1}, {-1, 1}, {1, -1}}};
constexpr std::array<Place, 4> at_sides = {{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
// Farther off than the corners.
constexpr std::array<Place, 8> around = {{{-3, -1}, {-3, 1}, {3, -1}, {3, 1}, {-1, -3}, {1, -3}, {-1, 3}, {1, 3}}};
constexpr int beyond = 3;

// The mean of the lights of four rays about another, in the order of the places above; none if it may be far from the
// ray's own: if a part of the light varies steeply or bends around it.
std::optional<Cutaway::Light> mean_of_similar(const std::array<Cutaway::Light, 4>& about, float most_bend) {
  using Light = Cutaway::Light;
  Light mean;
  for (float Light::*const part : {&Light::red, &Light::green, &Light::blue, &Light::opacity}) {
    const float a = about[0].*part, b = about[1].*part, c = about[2].*part, d = about[3].*part;
    const auto [least, most] = std::minmax({a, b, c, d});
    if (most - least > steepest * most_bend) return std::nullopt;
    if (std::abs(a + b - c - d) > 2.0F * most_bend) return std::nullopt;
    mean.*part = 0.25F * (a + b + c + d);
  }
  return mean;
}

bool differ(const Cutaway::Light& a, const Cutaway::Light& b, float most) {
  return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue),
                   std::abs(a.opacity - b.opacity)}) > most;
}

}  // namespace

double CutawayOval::opacity_at(const Eigen::Vector2d& pixel) const {
  const double square = (pixel - centre).cwiseQuotient(radii).squaredNorm();  // of r
  if (!(square < 1.0)) return 0.0;
  return square <= threshold * threshold ? 1.0 : (1.0 - std::sqrt(square)) / (1.0 - threshold);
}

Cutaway cast_cutaway(const RayCaster& caster, const PictureCamera& camera, const CutawayOval& oval, int width,
                     int height, ThreadPool& pool, bool moves, int most_rays, float most_bend) {
  Cutaway made;
  made.oval = oval;
  made.left = std::max(0, static_cast<int>(std::floor(oval.centre.x() - oval.radii.x())));
  made.top = std::max(0, static_cast<int>(std::floor(oval.centre.y() - oval.radii.y())));
  made.right = std::min(width - 1, static_cast<int>(std::ceil(oval.centre.x() + oval.radii.x())));
  made.bottom = std::min(height - 1, static_cast<int>(std::ceil(oval.centre.y() + oval.radii.y())));
  if (made.left > made.right || made.top > made.bottom) return made;
  constexpr double share_of_ellipse = 0.7853981633974483;
  const double area = share_of_ellipse * (made.right - made.left + 1.0) * (made.bottom - made.top + 1.0);
  made.large = area > most_rays;
  made.step = moves || made.large ? 2 : 1;
  made.columns = (made.right - made.left) / made.step + 2;
  made.rows = (made.bottom - made.top) / made.step + 2;
  made.lights.resize(static_cast<std::size_t>(made.columns) * static_cast<std::size_t>(made.rows));
  std::atomic<int> cast = 0;
  const Vec3 eye = camera.patient_from_camera.translation();
  // A pixel inside may lie between rays just outside.
  const Eigen::Vector2d radii = oval.radii + Eigen::Vector2d::Constant(made.step);
  const auto pixel_of = [&](int column, int row) {
    return Eigen::Vector2d(made.left + made.step * column, made.top + made.step * row);
  };
  const auto is_within = [&](int column, int row) {
    return column >= 0 && row >= 0 && column < made.columns && row < made.rows &&
           (pixel_of(column, row) - oval.centre).cwiseQuotient(radii).squaredNorm() < 1.0;
  };
  const auto light_at = [&](int column, int row) -> Cutaway::Light& {
    return made.lights[static_cast<std::size_t>(row) * static_cast<std::size_t>(made.columns) +
                       static_cast<std::size_t>(column)];
  };
  const auto cast_ray = [&](int column, int row, bool far_apart) {
    const Vec3 direction = (camera.patient_from_camera.linear() * camera.ray(pixel_of(column, row))).normalized();
    const CastRay met = caster.cast(eye, direction, 1e9, far_apart);
    light_at(column, row) = {met.red, met.green, met.blue, met.opacity};
  };
  const float bend = made.coarser() ? coarse_bend * most_bend : most_bend;
  const auto lights_at = [&](int column, int row, const auto& places, auto& lights) {
    for (std::size_t n = 0; n < places.size(); ++n) {
      const auto& [right, down] = places[n];
      if (!is_within(column + right, row + down)) return false;
      lights[n] = light_at(column + right, row + down);
    }
    return true;
  };
  const auto light_between = [&](int column, int row, bool corners) -> std::optional<Cutaway::Light> {
    std::array<Cutaway::Light, 4> about;
    if (!lights_at(column, row, corners ? at_corners : at_sides, about)) return std::nullopt;
    // Towards the rim less of the view is visible, and less of its error.
    const auto share = static_cast<float>(oval.opacity_at(pixel_of(column, row)));
    const float may_bend = bend / std::max(share, least_share);
    const auto between = mean_of_similar(about, corners ? of_corners * may_bend : may_bend);
    if (!corners || !between) return between;
    std::array<Cutaway::Light, 8> farther;
    if (!lights_at(column, row, around, farther)) return std::nullopt;
    Cutaway::Light mean;
    for (const Cutaway::Light& light : farther) {
      mean.red += 0.125F * light.red;
      mean.green += 0.125F * light.green;
      mean.blue += 0.125F * light.blue;
      mean.opacity += 0.125F * light.opacity;
    }
    // Those beyond are sqrt(5) times as far off. If light bends equally in all directions, their mean differs from
    // that of the four by four times the latter's difference from the ray between.
    if (differ(*between, mean, 4.0F * of_line * of_corners * may_bend)) return std::nullopt;
    return between;
  };
  const int tiles_across = (made.columns + oval_tile - 1) / oval_tile,
            tiles_down = (made.rows + oval_tile - 1) / oval_tile;
  enum class Kind : std::uint8_t { first, between_corners, between_sides };
  // Rays of a tile: those of even columns and rows, of odd ones, and the others; the last two kinds in those that
  // need no ray of another tile (`inner`), and those that do. Returns the number cast.
  const auto cast_kind = [&](int tile, Kind kind, bool inner) {
    const int left = tile % tiles_across * oval_tile, top = tile / tiles_across * oval_tile;
    const bool corners = kind == Kind::between_corners;
    int here = 0;
    for (int y = corners ? 1 : 0; y < oval_tile; y += kind == Kind::between_sides ? 1 : 2) {
      for (int x = kind == Kind::first ? 0 : corners ? 1 : 1 - y % 2; x < oval_tile; x += 2) {
        if (!is_within(left + x, top + y)) continue;
        if (kind != Kind::first) {
          if ((std::min(x, y) >= beyond && std::max(x, y) < oval_tile - 1 - beyond) != inner) continue;
          if (const auto between = light_between(left + x, top + y, corners)) {
            light_at(left + x, top + y) = *between;
            continue;
          }
        }
        cast_ray(left + x, top + y, kind == Kind::first || !inner);
        ++here;
      }
    }
    return here;
  };
  // As much as possible of a tile in one go: its voxels are then still in the cache.
  const auto each_tile = [&](const auto& cast_in) {
    pool.run(tiles_across * tiles_down, [&](int tile) { cast.fetch_add(cast_in(tile), std::memory_order_relaxed); });
  };
  each_tile([&](int tile) {
    const int first = cast_kind(tile, Kind::first, true);
    const int between = cast_kind(tile, Kind::between_corners, true);
    return first + between + cast_kind(tile, Kind::between_sides, true);
  });
  each_tile([&](int tile) { return cast_kind(tile, Kind::between_corners, false); });
  each_tile([&](int tile) { return cast_kind(tile, Kind::between_sides, false); });
  made.rays = cast.load();
  return made;
}

int blend_cutaway(const Cutaway& cutaway, ThreadPool& pool, ImageRgb& picture) {
  using Light = Cutaway::Light;
  std::atomic<int> counted = 0;
  pool.run(cutaway.bottom - cutaway.top + 1, [&](int line) {
    const int y = cutaway.top + line, step = cutaway.step;
    int here = 0;
    for (int x = cutaway.left; x <= cutaway.right; ++x) {
      const auto share = static_cast<float>(cutaway.oval.opacity_at({x, y}));
      if (share <= 0.0F) continue;
      ++here;
      const auto at = [&](int column, int row) {
        return cutaway.lights[static_cast<std::size_t>(row) * static_cast<std::size_t>(cutaway.columns) +
                              static_cast<std::size_t>(column)];
      };
      const int column = (x - cutaway.left) / step, row = (y - cutaway.top) / step;
      Light light = at(column, row);
      if (step == 2) {
        const int right = (x - cutaway.left) % 2, down = (y - cutaway.top) % 2;  // 0: the pixel has a ray there
        const Light b = at(column + right, row), c = at(column, row + down), d = at(column + right, row + down);
        light = {0.25F * (light.red + b.red + c.red + d.red), 0.25F * (light.green + b.green + c.green + d.green),
                 0.25F * (light.blue + b.blue + c.blue + d.blue),
                 0.25F * (light.opacity + b.opacity + c.opacity + d.opacity)};
      }
      Rgb& pixel = picture.at(x, y);
      pixel = {blended(pixel.red, light.red, light.opacity, share),
               blended(pixel.green, light.green, light.opacity, share),
               blended(pixel.blue, light.blue, light.opacity, share)};
    }
    counted.fetch_add(here, std::memory_order_relaxed);
  });
  return counted.load();
}

}  // namespace bodkin::imaging
