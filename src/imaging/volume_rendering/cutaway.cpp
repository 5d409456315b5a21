#include "imaging/volume_rendering/cutaway.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace bodkin::imaging {

namespace {

constexpr int oval_tile = 16;  // rays along each side: neighbours share voxels

std::uint8_t blended(std::uint8_t below, float light, float opacity, float share) {
  const float value = (1.0F - share * opacity) * static_cast<float>(below) + share * 255.0F * light;
  return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
}

}  // namespace

double CutawayOval::opacity_at(const Eigen::Vector2d& pixel) const {
  const double r = (pixel - centre).cwiseQuotient(radii).norm();
  if (!(r < 1.0)) return 0.0;
  return r <= threshold ? 1.0 : (1.0 - r) / (1.0 - threshold);
}

Cutaway cast_cutaway(const RayCaster& caster, const PictureCamera& camera, const CutawayOval& oval, int width,
                     int height, ThreadPool& pool, bool moves, int most_rays) {
  Cutaway made;
  made.oval = oval;
  made.left = std::max(0, static_cast<int>(std::floor(oval.centre.x() - oval.radii.x())));
  made.top = std::max(0, static_cast<int>(std::floor(oval.centre.y() - oval.radii.y())));
  made.right = std::min(width - 1, static_cast<int>(std::ceil(oval.centre.x() + oval.radii.x())));
  made.bottom = std::min(height - 1, static_cast<int>(std::ceil(oval.centre.y() + oval.radii.y())));
  if (made.left > made.right || made.top > made.bottom) return made;
  constexpr double share_of_ellipse = 0.7853981633974483;
  const double area = share_of_ellipse * (made.right - made.left + 1.0) * (made.bottom - made.top + 1.0);
  made.step = moves || area > most_rays ? 2 : 1;
  made.columns = (made.right - made.left) / made.step + 2;
  made.rows = (made.bottom - made.top) / made.step + 2;
  made.lights.resize(static_cast<std::size_t>(made.columns) * static_cast<std::size_t>(made.rows));
  std::atomic<int> cast = 0;
  const Vec3 eye = camera.patient_from_camera.translation();
  const int tiles_across = (made.columns + oval_tile - 1) / oval_tile,
            tiles_down = (made.rows + oval_tile - 1) / oval_tile;
  pool.run(tiles_across * tiles_down, [&](int index) {
    int here = 0;
    const int first_column = index % tiles_across * oval_tile, first_row = index / tiles_across * oval_tile;
    for (int row = first_row; row < std::min(first_row + oval_tile, made.rows); ++row) {
      for (int column = first_column; column < std::min(first_column + oval_tile, made.columns); ++column) {
        const Eigen::Vector2d pixel(made.left + made.step * column, made.top + made.step * row);
        // A pixel within may lie between rays that are just outside.
        if ((pixel - oval.centre).cwiseQuotient(oval.radii + Eigen::Vector2d::Constant(made.step)).norm() >= 1.0)
          continue;
        const Vec3 direction = (camera.patient_from_camera.linear() * camera.ray(pixel)).normalized();
        const CastRay met = caster.cast(eye, direction, 1e9, made.coarser());
        made.lights[static_cast<std::size_t>(row) * static_cast<std::size_t>(made.columns) +
                    static_cast<std::size_t>(column)] = {met.red, met.green, met.blue, met.opacity};
        ++here;
      }
    }
    cast.fetch_add(here, std::memory_order_relaxed);
  });
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
        const float across = 0.5F * static_cast<float>((x - cutaway.left) % 2),
                    down = 0.5F * static_cast<float>((y - cutaway.top) % 2);
        const Light b = at(column + 1, row), c = at(column, row + 1), d = at(column + 1, row + 1);
        const auto mix = [&](float p, float q, float r, float s) {
          return (1.0F - down) * ((1.0F - across) * p + across * q) + down * ((1.0F - across) * r + across * s);
        };
        light = {mix(light.red, b.red, c.red, d.red), mix(light.green, b.green, c.green, d.green),
                 mix(light.blue, b.blue, c.blue, d.blue), mix(light.opacity, b.opacity, c.opacity, d.opacity)};
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
