#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "training/metric_groups.h"

namespace bodkin::training {

namespace {

constexpr std::size_t most_points = 1000;  // of a path that is compared with the plan
constexpr double plan_step = 0.5;          // mm between points of the plan

struct ComparedPaths {
  std::vector<Vec3> travelled, planned;
};

// The last insertion until the final position, and the planned path, as points in order.
std::optional<ComparedPaths> compared_paths(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  const anatomy::NeedlePath& path = attempt.path();
  if (attempt.insertions.empty() || path.length() <= 0.0) return std::nullopt;
  const double from = attempt.time[attempt.insertions.back().first], until = attempt.time[attempt.final_tip->tick];
  std::vector<Vec3> all;
  for (std::size_t i = 0; i < measured.motion.tip.size(); ++i)
    if (measured.motion.time[i] >= from && measured.motion.time[i] <= until) all.push_back(measured.motion.tip[i]);
  if (all.empty()) return std::nullopt;
  ComparedPaths paths;
  const std::size_t stride = (all.size() + most_points - 1) / most_points;
  for (std::size_t i = 0; i < all.size(); i += stride) paths.travelled.push_back(all[i]);
  if ((all.size() - 1) % stride != 0) paths.travelled.push_back(all.back());
  const int steps = std::max(1, static_cast<int>(std::ceil(path.length() / plan_step)));
  for (int k = 0; k <= steps; ++k) paths.planned.emplace_back(path.entry + (path.target - path.entry) * k / steps);
  return paths;
}

// The best of all joint walks along both paths from beginning to end, never backwards. `joined` gives the value of a
// walk from that of the previous walk and the distance at its last step.
template <typename Joined>
double best_walk(const ComparedPaths& paths, const Joined& joined) {
  constexpr double far = std::numeric_limits<double>::infinity();
  std::vector<double> before(paths.planned.size(), far), now(paths.planned.size(), far);
  for (std::size_t i = 0; i < paths.travelled.size(); ++i) {
    for (std::size_t k = 0; k < paths.planned.size(); ++k) {
      double reached = i == 0 && k == 0 ? 0.0 : before[k];
      if (k > 0) reached = std::min({reached, now[k - 1], before[k - 1]});
      now[k] = joined(reached, (paths.travelled[i] - paths.planned[k]).norm());
    }
    std::swap(before, now);
  }
  return before.back();
}

std::optional<double> frechet(const Measured& measured) {
  const auto paths = compared_paths(measured);
  if (!paths) return std::nullopt;
  return best_walk(*paths, [](double reached, double here) { return std::max(reached, here); });
}

std::optional<double> time_warp(const Measured& measured) {
  const auto paths = compared_paths(measured);
  if (!paths) return std::nullopt;
  return best_walk(*paths, [](double reached, double here) { return reached + here; }) /
         static_cast<double>(paths->travelled.size() + paths->planned.size() - 1);
}

std::optional<double> time_to_target(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  if (attempt.insertions.empty()) return std::nullopt;
  const double tolerance = attempt.description().procedure.target_tolerance;
  for (std::size_t i = attempt.first_contact(); i < attempt.size(); ++i)
    if (attempt.inside[i] != 0 && (attempt.tip[i] - attempt.path().target).norm() < tolerance)
      return attempt.time[i] - attempt.time[attempt.first_contact()];
  return std::nullopt;
}

std::optional<double> time_of_closest(const Measured& measured) {
  return with_insertion(measured, [](const Attempt& attempt) {
    double closest = std::numeric_limits<double>::infinity(), when = 0.0;
    for (std::size_t i = 0; i < attempt.size(); ++i) {
      const double here = (attempt.tip[i] - attempt.path().target).norm();
      if (attempt.inside[i] == 0 || here >= closest) continue;
      closest = here;
      when = attempt.time[i] - attempt.time[attempt.first_contact()];
    }
    return when;
  });
}

// Spread of the tip in the body about its mean.
std::optional<double> spread(const Measured& measured) {
  return with_insertion(measured, [](const Attempt& attempt) {
    Vec3 mean = Vec3::Zero();
    double count = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < attempt.size(); ++i) {
      if (attempt.inside[i] == 0) continue;
      count += 1.0;
      const Vec3 off = attempt.tip[i] - mean;
      mean += off / count;
      squares += off.dot(attempt.tip[i] - mean);
    }
    return std::sqrt(squares / count);
  });
}

// Sides of the box along the patient's axes that holds the tip in the body, mm.
std::optional<Vec3> box(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  if (attempt.insertions.empty()) return std::nullopt;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (std::size_t i = 0; i < attempt.size(); ++i) {
    if (attempt.inside[i] == 0) continue;
    low = low.cwiseMin(attempt.tip[i]);
    high = high.cwiseMax(attempt.tip[i]);
  }
  return high - low;
}

template <int axis>
std::optional<double> box_side(const Measured& measured) {
  const std::optional<Vec3> sides = box(measured);
  return sides ? std::optional((*sides)[axis]) : std::nullopt;
}

std::optional<double> box_volume(const Measured& measured) {
  const std::optional<Vec3> sides = box(measured);
  return sides ? std::optional(sides->prod()) : std::nullopt;
}

}  // namespace

std::vector<Metric> metrics_of_path() {
  return {
      {"deviation_frechet_mm", "mm", "Fréchet distance of the tip's path from the planned path",
       "of the last insertion until the final position, at most 1000 points, from points of the plan 0.5 mm apart; "
       "discrete",
       "PerkTutor, Frechet", frechet},
      {"deviation_warped_mm", "mm", "mean distance of the tip's path from the planned path, best aligned",
       "of the same points: least sum of distances by dynamic time warping, over the number of points less one",
       "PerkTutor, Time Warp", time_warp},
      {"time_to_target_s", "s", "time to the target",
       "from the first contact until the tip was first within the tolerance of the case", "PerkTutor",
       time_to_target},
      {"closest_time_s", "s", "time of the closest approach to the target", "from the first contact", "Bodkin",
       time_of_closest},
      {"spread_mm", "mm", "spread of the tip in the body", "root mean square of its distance from its own mean",
       "PerkTutor, RMS", spread},
      {"box_across_mm", "mm", "extent of the tip's motion from side to side",
       "in the body, between the patient's left and right", "PerkTutor, Bounding Box", box_side<0>},
      {"box_through_mm", "mm", "extent of the tip's motion from front to back", "the same, between front and back",
       "PerkTutor, Bounding Box", box_side<1>},
      {"box_along_mm", "mm", "extent of the tip's motion along the body", "the same, between head and feet",
       "PerkTutor, Bounding Box", box_side<2>},
      {"box_mm3", "mm3", "volume that the tip moved in",
       "of the box along the patient's axes that holds the tip in the body", "PerkTutor, Bounding Box", box_volume}};
}

}  // namespace bodkin::training
