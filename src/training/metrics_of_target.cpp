#include <algorithm>
#include <cmath>
#include <limits>

#include "training/metric_groups.h"

namespace bodkin::training {

namespace {

double angle_to_plan(const Vec3& axis, const anatomy::NeedlePath& path) {
  const Vec3 planned = path.target - path.entry;
  return std::atan2(axis.cross(planned).norm(), axis.dot(planned)) / degree;
}

double distance_to_plan(const Vec3& point, const anatomy::NeedlePath& path) {
  const Vec3 along = path.target - path.entry;
  const double square = along.squaredNorm();
  const double share = square > 0.0 ? std::clamp((point - path.entry).dot(along) / square, 0.0, 1.0) : 0.0;
  return (path.entry + share * along - point).norm();
}

std::optional<double> final_distance(const Measured& measured) {
  return with_insertion(measured, [](const Attempt& a) { return target_error(a.final_tip->tip, a.path()).distance; });
}

std::optional<double> final_axial(const Measured& measured) {
  return with_insertion(measured, [](const Attempt& a) { return target_error(a.final_tip->tip, a.path()).axial; });
}

std::optional<double> final_lateral(const Measured& measured) {
  return with_insertion(measured, [](const Attempt& a) { return target_error(a.final_tip->tip, a.path()).lateral; });
}

std::optional<double> closest_distance(const Measured& measured) {
  return with_insertion(measured, [](const Attempt& a) {
    double closest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a.inside[i] != 0) closest = std::min(closest, (a.tip[i] - a.path().target).norm());
    return closest;
  });
}

std::optional<double> past_target(const Measured& measured) {
  return with_insertion(measured, [](const Attempt& a) {
    double furthest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a.inside[i] != 0) furthest = std::max(furthest, target_error(a.tip[i], a.path()).axial);
    return furthest;
  });
}

std::optional<double> deepest(const Measured& measured) {
  return with_insertion(measured, [](const Attempt& a) {
    double depth = 0.0;
    for (const Insertion& insertion : a.insertions) depth = std::max(depth, insertion.deepest);
    return depth;
  });
}

std::optional<double> entry_distance(const Measured& measured) {
  return with_insertion(measured,
                        [](const Attempt& a) { return (a.tip[a.insertions.back().first] - a.path().entry).norm(); });
}

std::optional<double> deviation_max(const Measured& measured) {
  return with_insertion(measured, [](const Attempt& a) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a.inside[i] != 0) most = std::max(most, distance_to_plan(a.tip[i], a.path()));
    return most;
  });
}

std::optional<double> deviation_rms(const Measured& measured) {
  return with_insertion(measured, [](const Attempt& a) {
    double squares = 0.0, count = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (a.inside[i] == 0) continue;
      const double here = distance_to_plan(a.tip[i], a.path());
      squares += here * here;
      count += 1.0;
    }
    return std::sqrt(squares / count);
  });
}

std::optional<double> deviation_mean(const Measured& measured) {
  return with_insertion(measured, [](const Attempt& a) {
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (a.inside[i] == 0) continue;
      sum += distance_to_plan(a.tip[i], a.path());
      count += 1.0;
    }
    return sum / count;
  });
}

std::optional<double> angle_at_contact(const Measured& measured) {
  return with_insertion(measured,
                        [](const Attempt& a) { return angle_to_plan(a.axis[a.insertions.back().first], a.path()); });
}

std::optional<double> angle_at_end(const Measured& measured) {
  return with_insertion(measured,
                        [](const Attempt& a) { return angle_to_plan(a.axis[a.final_tip->tick], a.path()); });
}

}  // namespace

std::vector<Metric> metrics_of_target() {
  return {
      {"final_distance_mm", "mm", "distance of the final position from the target",
       "from the final position to the planned target", "Kwon et al. 2001, final tip position", final_distance},
      {"final_axial_mm", "mm", "depth of the final position beyond the target",
       "its part along the planned path; positive: too deep", "Bodkin", final_axial},
      {"final_lateral_mm", "mm", "lateral distance of the final position from the target",
       "its part across the planned path", "Bodkin", final_lateral},
      {"closest_distance_mm", "mm", "closest approach to the target",
       "least distance of the tip in the body from the target", "PerkTutor, Targets Hit", closest_distance},
      {"past_target_mm", "mm", "greatest depth beyond the target",
       "greatest distance of the tip in the body beyond the target, along the planned path", "Bodkin", past_target},
      {"deepest_mm", "mm", "greatest depth", "greatest depth along the needle's line", "Bodkin", deepest},
      {"entry_distance_mm", "mm", "distance of the entry from the planned entry",
       "of the tip at the first contact of the last insertion", "TrainUS", entry_distance},
      {"deviation_max_mm", "mm", "greatest distance from the planned path",
       "of the tip in the body from the segment between entry and target",
       "Kwon et al. 2001, maximum deviation; PerkTutor, Hausdorff", deviation_max},
      {"deviation_rms_mm", "mm", "distance from the planned path, root mean square", "the same, over all ticks",
       "Bodkin", deviation_rms},
      {"deviation_mean_mm", "mm", "distance from the planned path, mean", "the same, mean", "Bodkin", deviation_mean},
      {"angle_at_contact_deg", "deg", "angle to the planned path at the skin",
       "between needle and planned path at the first contact of the last insertion", "TrainUS", angle_at_contact},
      {"angle_at_end_deg", "deg", "angle to the planned path at the final position", "the same there", "Bodkin",
       angle_at_end}};
}

}  // namespace bodkin::training
