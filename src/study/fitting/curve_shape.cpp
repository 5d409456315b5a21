#include "study/fitting/curve_shape.h"

#include <algorithm>
#include <cmath>

namespace bodkin::study {

namespace {

constexpr std::size_t window = 3;  // samples that are averaged
constexpr double begins = 0.05;    // of the largest force: contact
constexpr double loaded = 0.8;     // of the largest force: end of the first rise
constexpr std::size_t apart = 4;   // samples between two falls

double mean(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

double mean_before(std::span<const double> values, std::size_t end) {
  const std::size_t first = end > window ? end - window : 0;
  return mean(values.subspan(first, end - first));
}

double mean_after(std::span<const double> values, std::size_t first) {
  return mean(values.subspan(first, std::min(window, values.size() - first)));
}

}  // namespace

double contact_of(const MeasuredCurve& curve) {
  const double largest = *std::max_element(curve.force.begin(), curve.force.end());
  const double threshold = std::max(begins * largest, 3.0 * noise_of(curve));
  std::size_t first = 0;
  while (first + 1 < curve.size() && curve.force[first] < threshold) ++first;
  return curve.depth[first > 0 ? first - 1 : 0];
}

double noise_of(const MeasuredCurve& curve) {
  std::vector<double> steps;  // second differences: a straight line has none
  for (std::size_t i = 2; i < curve.size(); ++i)
    steps.push_back(std::abs(curve.force[i] - 2.0 * curve.force[i - 1] + curve.force[i - 2]));
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle / (0.6745 * std::sqrt(6.0));  // median of |normal|, and 1 + 4 + 1
}

std::vector<std::size_t> falls_of(const MeasuredCurve& curve, std::size_t most) {
  std::vector<std::pair<double, std::size_t>> falls;
  const auto advances = [&](std::size_t i) { return curve.depth[i] > curve.depth[i - 1]; };
  for (std::size_t i = 2; i + 2 < curve.size(); ++i) {
    if (!advances(i - 1) || !advances(i) || !advances(i + 1) || !advances(i + 2)) continue;  // a turn is no fall
    falls.emplace_back(mean_before(curve.force, i) - mean_after(curve.force, i), i);
  }
  std::sort(falls.begin(), falls.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::size_t> found;
  for (const auto& [fall, sample] : falls) {
    if (found.size() == most || fall <= 0.0) break;
    const std::size_t here = sample;
    const bool fresh = std::none_of(found.begin(), found.end(), [&](std::size_t other) {
      return (other > here ? other - here : here - other) < apart;
    });
    if (fresh) found.push_back(sample);
  }
  return found;
}

CurveShape shape_of(const MeasuredCurve& curve, double contact, std::size_t yield) {
  CurveShape shape;
  shape.contact = contact;
  const auto [shallow, deep] = std::minmax_element(curve.depth.begin(), curve.depth.end());
  const double nearly = *deep - 1e-3 * (*deep - *shallow);
  std::size_t end = 0;  // the deepest point, before the needle's rest there
  while (curve.depth[end] < nearly) ++end;
  shape.end_depth = *deep;
  shape.end_force = std::max(0.0, mean_before(curve.force, end + 1));
  const std::size_t peak = yield > 0 ? yield - 1 : end;
  shape.peak_depth = curve.depth[peak];
  shape.peak_force = std::max(curve.force[peak], 1e-3);
  shape.after_force = yield > 0 ? std::max(0.0, mean_after(curve.force, yield)) : shape.end_force;

  const double largest = *std::max_element(curve.force.begin(), curve.force.end());
  double n = 0.0, x = 0.0, f = 0.0, xx = 0.0, xf = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (curve.force[i] > begins * largest) {
      n += 1.0;
      x += curve.depth[i];
      f += curve.force[i];
      xx += curve.depth[i] * curve.depth[i];
      xf += curve.depth[i] * curve.force[i];
    }
    if (curve.force[i] > loaded * largest) break;
  }
  const double spread = n * xx - x * x;
  shape.slope = spread > 0.0 ? (n * xf - x * f) / spread : 0.0;
  if (!(shape.slope > 0.0)) shape.slope = largest / std::max(0.1, *deep - contact);
  shape.intercept = n > 0.0 ? (x - f / shape.slope) / n : contact;
  return shape;
}

}  // namespace bodkin::study
