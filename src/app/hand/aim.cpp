#include "app/hand/aim.h"

#include <cmath>

#include "anatomy/tissue.h"

namespace bodkin::app {

namespace {

constexpr double ray_step = 0.5;      // mm
constexpr double normal_reach = 4.0;  // mm
constexpr double flattest = 0.5;      // sine of the least angle between a planned needle and the skin

bool is_body(const anatomy::TissueVolume& tissues, const Vec3& point) {
  return anatomy::nearest(tissues, point, anatomy::tissue::air) != anatomy::tissue::air;
}

}  // namespace

std::optional<Vec3> outwards_at(const anatomy::TissueVolume& tissues, const Vec3& point) {
  Vec3 sum = Vec3::Zero();
  for (int i = -3; i <= 3; ++i) {
    for (int j = -3; j <= 3; ++j) {
      for (int k = -3; k <= 3; ++k) {
        const Vec3 way = Vec3(i, j, k) * (normal_reach / 3.0);
        if (way.norm() > normal_reach || way.isZero()) continue;
        if (!is_body(tissues, point + way)) sum += way.normalized();
      }
    }
  }
  if (sum.norm() < 1.0) return std::nullopt;
  return sum.normalized();
}

std::optional<SkinPoint> skin_on_ray(const anatomy::TissueVolume& tissues, const Vec3& from, const Vec3& direction,
                                     double reach) {
  if (is_body(tissues, from)) return std::nullopt;
  for (double way = ray_step; way <= reach; way += ray_step) {
    if (!is_body(tissues, from + way * direction)) continue;
    double outside = way - ray_step, inside = way;
    for (int i = 0; i < 8; ++i) {
      const double middle = 0.5 * (outside + inside);
      (is_body(tissues, from + middle * direction) ? inside : outside) = middle;
    }
    SkinPoint skin{from + outside * direction, -direction};
    if (const std::optional<Vec3> outwards = outwards_at(tissues, skin.point)) skin.outwards = *outwards;
    return skin;
  }
  return std::nullopt;
}

Vec3 aimed_axis(const SkinPoint& skin, const std::optional<anatomy::NeedlePath>& plan) {
  if (plan && plan->length() > 0.0 && plan->direction().dot(-skin.outwards) >= flattest) return plan->direction();
  return -skin.outwards;
}

}  // namespace bodkin::app
