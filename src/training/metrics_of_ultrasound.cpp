#include <algorithm>
#include <cmath>

#include "training/metric_groups.h"

namespace bodkin::training {

namespace {

constexpr double in_plane = 2.0;  // mm from the slice within which the tip is seen

struct Seen {
  double sum = 0.0, most = 0.0, angle = 0.0;  // mm, mm, deg
  int seen = 0, count = 0;
};

// Of the samples of the probe while the needle was in the body. The slice lies in the first and third axis of the
// probe; its second axis is the normal.
std::optional<Seen> look(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  const session::Session& session = attempt.session();
  if (!session.header.second || session.header.second->role != session::SecondRole::probe) return std::nullopt;
  const double start = static_cast<double>(session.ticks.front().tick) * attempt.dt();
  Seen found;
  for (const session::SecondSample& sample : session.second) {
    const auto place = std::lower_bound(attempt.time.begin(), attempt.time.end(), sample.time - start);
    if (place == attempt.time.end()) continue;
    const auto i = static_cast<std::size_t>(place - attempt.time.begin());
    if (attempt.inside[i] == 0) continue;
    const Vec3 normal = sample.rotation * Vec3::UnitY();
    const double distance = std::abs((attempt.tip[i] - sample.position).dot(normal));
    found.sum += distance;
    found.most = std::max(found.most, distance);
    found.angle += std::asin(std::clamp(std::abs(attempt.axis[i].dot(normal)), 0.0, 1.0)) / degree;
    found.seen += distance <= in_plane ? 1 : 0;
    ++found.count;
  }
  return found.count > 0 ? std::optional(found) : std::nullopt;
}

std::optional<double> tip_to_slice_mean(const Measured& measured) {
  const auto seen = look(measured);
  return seen ? std::optional(seen->sum / seen->count) : std::nullopt;
}

std::optional<double> tip_to_slice_max(const Measured& measured) {
  const auto seen = look(measured);
  return seen ? std::optional(seen->most) : std::nullopt;
}

std::optional<double> tip_in_slice(const Measured& measured) {
  const auto seen = look(measured);
  return seen ? std::optional(100.0 * seen->seen / seen->count) : std::nullopt;
}

std::optional<double> needle_to_slice(const Measured& measured) {
  const auto seen = look(measured);
  return seen ? std::optional(seen->angle / seen->count) : std::nullopt;
}

}  // namespace

std::vector<Metric> metrics_of_ultrasound() {
  return {{"tip_to_slice_mean_mm", "mm", "distance of the tip from the ultrasound slice, mean",
           "over the probe's samples with the needle in the body", "TrainUS", tip_to_slice_mean},
          {"tip_to_slice_max_mm", "mm", "distance of the tip from the ultrasound slice, greatest",
           "the same, greatest", "TrainUS", tip_to_slice_max},
          {"tip_in_slice_percent", "%", "time with the tip in the ultrasound slice",
           "share of those samples with the tip within 2 mm of the slice", "Bodkin", tip_in_slice},
          {"needle_to_slice_deg", "deg", "angle between needle and ultrasound slice", "mean over those samples",
           "TrainUS", needle_to_slice}};
}

}  // namespace bodkin::training
