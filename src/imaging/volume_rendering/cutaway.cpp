#include "imaging/volume_rendering/cutaway.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace bodkin::imaging {

namespace {

struct Light {
  float red = 0.0F, green = 0.0F, blue = 0.0F, opacity = 0.0F;
};

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

CutawayReport draw_cutaway(const RayCaster& caster, const PictureCamera& camera, const CutawayOval& oval,
                           ThreadPool& pool, ImageRgb& picture, bool moving, int most_rays) {
  const int left = std::max(0, static_cast<int>(std::floor(oval.centre.x() - oval.radii.x())));
  const int top = std::max(0, static_cast<int>(std::floor(oval.centre.y() - oval.radii.y())));
  const int right = std::min(picture.width - 1, static_cast<int>(std::ceil(oval.centre.x() + oval.radii.x())));
  const int bottom = std::min(picture.height - 1, static_cast<int>(std::ceil(oval.centre.y() + oval.radii.y())));
  CutawayReport report;
  if (left > right || top > bottom) return report;
  constexpr double share_of_ellipse = 0.7853981633974483;
  const double area = share_of_ellipse * (right - left + 1.0) * (bottom - top + 1.0);
  report.coarser = moving || area > most_rays;
  const int step = report.coarser ? 2 : 1;
  const int columns = (right - left) / step + 2, rows = (bottom - top) / step + 2;
  std::vector<Light> lights(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  std::atomic<int> cast = 0;
  const Vec3 eye = camera.patient_from_camera.translation();
  pool.run(rows, [&](int row) {
    int here = 0;
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector2d pixel(left + step * column, top + step * row);
      // A pixel within may lie between rays that are just outside.
      if ((pixel - oval.centre).cwiseQuotient(oval.radii + Eigen::Vector2d::Constant(step)).norm() >= 1.0) continue;
      const Vec3 direction = (camera.patient_from_camera.linear() * camera.ray(pixel)).normalized();
      const CastRay met = caster.cast(eye, direction, 1e9);
      lights[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)] = {
          met.red, met.green, met.blue, met.opacity};
      ++here;
    }
    cast.fetch_add(here, std::memory_order_relaxed);
  });
  report.rays = cast.load();
  std::atomic<int> counted = 0;
  pool.run(bottom - top + 1, [&](int line) {
    const int y = top + line;
    int here = 0;
    for (int x = left; x <= right; ++x) {
      const auto share = static_cast<float>(oval.opacity_at({x, y}));
      if (share <= 0.0F) continue;
      ++here;
      const auto at = [&](int column, int row) {
        return lights[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(column)];
      };
      const int column = (x - left) / step, row = (y - top) / step;
      Light light = at(column, row);
      if (step == 2) {
        const float across = 0.5F * static_cast<float>((x - left) % 2),
                    down = 0.5F * static_cast<float>((y - top) % 2);
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
  report.pixels = counted.load();
  return report;
}

}  // namespace bodkin::imaging
