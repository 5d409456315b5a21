#include "imaging/ultrasound_screen/skin.h"

#include <cmath>

#include "anatomy/tissue.h"

namespace bodkin::imaging {

namespace {

constexpr double skin_step = 0.25;      // mm
constexpr double for_good = 15.0;       // mm of air
constexpr double neighbourhood = 12.0;  // mm, radius of the ball that determines the outward direction
constexpr double neighbour_step = 2.0;  // mm
constexpr anatomy::TissueId beyond_image = 255;

bool is_body(anatomy::TissueId id) {
  return id != anatomy::tissue::air && id != beyond_image;
}

}  // namespace

std::optional<SkinPoint> skin_along(const anatomy::TissueVolume& tissues, const Vec3& inside, const Vec3& direction) {
  if (!is_body(anatomy::nearest(tissues, inside, beyond_image)) || !(direction.norm() > 0.0)) return std::nullopt;
  const Vec3 axis = direction.normalized();
  double last = 0.0;  // mm along the axis, where the body was last found
  for (int step = 1;; ++step) {
    const double gone = skin_step * step;
    const anatomy::TissueId id = anatomy::nearest(tissues, Vec3(inside + gone * axis), beyond_image);
    if (is_body(id)) last = gone;
    if (id == beyond_image && gone - last < 1.5 * skin_step) return std::nullopt;  // the image cuts off the body
    if (id == beyond_image || gone - last > for_good) break;
  }
  const Vec3 place = inside + (last + 0.5 * skin_step) * axis;
  return SkinPoint{place, outward_of_skin(tissues, place, axis)};
}

std::optional<SkinPoint> skin_near(const anatomy::TissueVolume& tissues, const Vec3& point, const Vec3& outward,
                                   double reach) {
  if (!(outward.norm() > 0.0) || !point.allFinite()) return std::nullopt;
  const Vec3 axis = outward.normalized();
  const auto body = [&](double at) {
    return is_body(anatomy::nearest(tissues, Vec3(point + at * axis), beyond_image));
  };
  // From the point to both sides at once; the skin has the body below and not above.
  for (int step = 0; skin_step * step <= reach; ++step) {
    for (const double at : {skin_step * step, -skin_step * step}) {
      const double low = at - 0.5 * skin_step, high = at + 0.5 * skin_step;
      if (!body(low) || anatomy::nearest(tissues, Vec3(point + high * axis), beyond_image) != anatomy::tissue::air)
        continue;
      const Vec3 place = point + at * axis;
      return SkinPoint{place, outward_of_skin(tissues, place, axis)};
    }
  }
  return std::nullopt;
}

Vec3 outward_of_skin(const anatomy::TissueVolume& tissues, const Vec3& place, const Vec3& fallback) {
  Vec3 sum = Vec3::Zero();
  const int cells = static_cast<int>(neighbourhood / neighbour_step);
  for (int k = -cells; k <= cells; ++k) {
    for (int j = -cells; j <= cells; ++j) {
      for (int i = 0; i <= cells; ++i) {  // half of the ball: each place together with its opposite
        const Vec3 offset = neighbour_step * Vec3(i, j, k);
        if (offset.norm() > neighbourhood) continue;
        const anatomy::TissueId here = anatomy::nearest(tissues, Vec3(place + offset), beyond_image);
        const anatomy::TissueId opposite = anatomy::nearest(tissues, Vec3(place - offset), beyond_image);
        if (here == beyond_image || opposite == beyond_image) continue;  // half a ball would lean to the image's edge
        sum += offset * ((here == anatomy::tissue::air ? 1.0 : 0.0) - (opposite == anatomy::tissue::air ? 1.0 : 0.0));
      }
    }
  }
  return sum.norm() > 1e-6 ? Vec3(sum.normalized()) : fallback;
}

}  // namespace bodkin::imaging
