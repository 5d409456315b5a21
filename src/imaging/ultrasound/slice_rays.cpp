#include "imaging/ultrasound/slice_rays.h"

#include <algorithm>
#include <cmath>

namespace bodkin::imaging {

std::vector<SliceRay> slice_rays(int count) {
  if (count <= 1) return {SliceRay{}};
  const double apart = count == 3 ? 1.5 : count == 5 ? 1.0 : 0.8;
  std::vector<SliceRay> rays = {SliceRay{}};
  double sum = 1.0, variance = 0.0;
  for (int side = 1; side <= count / 2; ++side) {
    const double off = side * apart, weight = std::exp(-0.5 * off * off);
    rays.push_back({off, weight});
    rays.push_back({-off, weight});
    sum += 2.0 * weight;
    variance += 2.0 * weight * off * off;
  }
  for (SliceRay& ray : rays) {
    ray.weight /= sum;
    ray.off /= std::sqrt(variance / sum);
  }
  return rays;
}

double variance_left(const std::vector<double>& weights, double apart) {
  double variance = 0.0;
  for (std::size_t a = 0; a < weights.size(); ++a) {
    for (std::size_t b = 0; b < weights.size(); ++b) {
      const double cells = apart * std::abs(static_cast<double>(a) - static_cast<double>(b));
      variance += weights[a] * weights[b] * std::max(0.0, 1.0 - cells);
    }
  }
  return variance;
}

std::vector<SlicePass> slice_passes(const std::vector<SliceRay>& rays, bool blended) {
  std::vector<SlicePass> passes;
  for (const SliceRay& ray : rays) {
    if (!blended || ray.off == 0.0) {
      passes.push_back({ray.off, ray.weight, false});
    } else if (ray.off > 0.0) {
      passes.push_back({ray.off, 2.0 * ray.weight, true});
    }
  }
  return passes;
}

std::vector<double> half_gaussian(double deviation, int half) {
  std::vector<double> weights;
  double sum = 0.0;
  for (int step = 0; step <= half; ++step) {
    const double x = deviation > 0.0 ? step / deviation : (step == 0 ? 0.0 : 40.0);
    weights.push_back(std::exp(-0.5 * x * x));
    sum += (step == 0 ? 1.0 : 2.0) * weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

}  // namespace bodkin::imaging
