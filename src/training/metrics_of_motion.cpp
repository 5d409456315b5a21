#include <algorithm>
#include <cmath>

#include "training/metric_groups.h"

namespace bodkin::training {

namespace {

constexpr double shortest_way = 0.1;  // mm; below it a share of the way is meaningless

std::optional<double> path_length_of(const Measured& measured) {
  return with_insertion(measured, [&](const Attempt&) { return measured.path_length; });
}

// PerkTutor's Path Length includes the ways outside the body.
std::optional<double> whole_path_length(const Measured& measured) {
  double length = 0.0;
  for (std::size_t i = 1; i < measured.motion.tip.size(); ++i)
    length += (measured.motion.tip[i] - measured.motion.tip[i - 1]).norm();
  return length;
}

// Shares of the time at either speed.
std::optional<double> time_in_action(const Measured& measured) {
  const Motion& motion = measured.motion;
  double active = 0.0, all = 0.0;
  for (std::size_t i = 0; i < motion.tip.size(); ++i) {
    if (motion.inside[i] == 0) continue;
    all += 1.0;
    active += measured.active[i] != 0 ? 1.0 : 0.0;
  }
  return all > 0.0 ? std::optional(100.0 * active / all) : std::nullopt;
}

// From the last skin contact to the final position: length of the way over the straight distance.
std::optional<double> path_inefficiency(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  if (attempt.insertions.empty()) return std::nullopt;
  const std::size_t first = attempt.insertions.back().first, last = attempt.final_tip->tick;
  const double straight = (attempt.final_tip->tip - attempt.tip[first]).norm();
  if (straight < shortest_way) return std::nullopt;
  const Motion& motion = measured.motion;
  double length = 0.0;
  for (std::size_t i = 1; i < motion.tip.size(); ++i) {
    if (motion.time[i - 1] >= attempt.time[first] && motion.time[i] <= attempt.time[last])
      length += (motion.tip[i] - motion.tip[i - 1]).norm();
  }
  return std::max(0.0, 100.0 * (length / straight - 1.0));
}

std::optional<double> travel_along(const Measured& measured) {
  return with_insertion(measured, [&](const Attempt& attempt) {
    const Motion& motion = measured.motion;
    const std::size_t stride = std::max<std::size_t>(1, attempt.size() / std::max<std::size_t>(1, motion.tip.size()));
    double sum = 0.0;
    for (std::size_t i = 1; i < motion.tip.size(); ++i) {
      if (motion.inside[i] == 0 || motion.inside[i - 1] == 0) continue;
      sum +=
          std::abs((motion.tip[i] - motion.tip[i - 1]).dot(attempt.axis[std::min(i * stride, attempt.size() - 1)]));
    }
    return sum;
  });
}

std::optional<double> mean_speed(const Measured& measured) {
  return with_insertion(measured, [&](const Attempt& attempt) {
    const double time =
        static_cast<double>(std::count(attempt.inside.begin(), attempt.inside.end(), 1)) * attempt.dt();
    return measured.path_length / time;
  });
}

// The area that the needle sweeps inside the body between two samples: two triangles of both tips and both points
// where it enters the skin (PerkTutor's Tissue Damage).
std::optional<double> swept_area(const Measured& measured) {
  return with_insertion(measured, [&](const Attempt& attempt) {
    constexpr double interval = 0.01;  // s
    const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(interval / attempt.dt())));
    double area = 0.0;
    for (std::size_t i = stride; i < attempt.size(); i += stride) {
      const std::size_t j = i - stride;
      if (attempt.inside[i] == 0 || attempt.inside[j] == 0) continue;
      const Vec3 entry_now = attempt.tip[i] - attempt.depth[i] * attempt.axis[i];
      const Vec3 entry_before = attempt.tip[j] - attempt.depth[j] * attempt.axis[j];
      area += 0.5 * (attempt.tip[j] - attempt.tip[i]).cross(entry_before - attempt.tip[i]).norm();
      area += 0.5 * (entry_before - attempt.tip[i]).cross(entry_now - attempt.tip[i]).norm();
    }
    return area;
  });
}

std::optional<double> smoothness_of(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  if (attempt.insertions.empty()) return std::nullopt;
  return smoothness(measured.motion, attempt.time[attempt.final_tip->tick]);
}

std::optional<double> jerk_of(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  if (attempt.insertions.empty()) return std::nullopt;
  return root_of_jerk(measured.motion, attempt.time[attempt.final_tip->tick]);
}

std::optional<double> tremor_amplitude(const Measured& measured) {
  return measured.tremor ? std::optional(measured.tremor->amplitude) : std::nullopt;
}

std::optional<double> tremor_frequency(const Measured& measured) {
  return measured.tremor ? std::optional(measured.tremor->frequency) : std::nullopt;
}

std::optional<double> shaft_sweep(const Measured& measured) {
  return with_insertion(measured, [](const Attempt& attempt) {
    constexpr double interval = 0.05;  // s, so that noise of the rotation does not add up
    const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(interval / attempt.dt())));
    double sum = 0.0;
    for (std::size_t i = stride; i < attempt.size(); i += stride) {
      if (attempt.inside[i] == 0 || attempt.inside[i - stride] == 0) continue;
      const Vec3 &now = attempt.axis[i], &before = attempt.axis[i - stride];
      sum += std::atan2(now.cross(before).norm(), now.dot(before)) / degree;
    }
    return sum;
  });
}

}  // namespace

std::vector<Metric> metrics_of_motion() {
  return {
      {"path_length_mm", "mm", "length of the tip's path in the body",
       "sum of the distances between points of the filtered motion (10 Hz, sampled at 100 Hz)",
       "PerkTutor, Path in Tissue", path_length_of},
      {"whole_path_length_mm", "mm", "length of the tip's path", "the same, with the motion outside the body",
       "PerkTutor, Path Length", whole_path_length},
      {"in_action_percent", "%", "time in action",
       "share of the time in the body in which the filtered tip moves by over 5 mm/s or the needle turns by over 10 "
       "deg/s, each change counted once it has lasted for over 0.2 s",
       "TrainUS, in action", time_in_action},
      {"path_inefficiency_percent", "%", "detour to the final position",
       "length of the path from the last contact to the final position, divided by the straight distance, less 100 %",
       "PerkTutor, Path Inefficiency", path_inefficiency},
      {"travel_along_mm", "mm", "travel along the shaft", "sum of the filtered motion's steps along the needle",
       "PerkTutor, Depth Perception", travel_along},
      {"mean_speed_mm_per_s", "mm/s", "mean speed in the body", "length of the path over the time in the body",
       "PerkTutor, Average Velocity", mean_speed},
      {"swept_area_mm2", "mm2", "area swept by the needle",
       "sum over 10 ms of the two triangles of both tips and both entries; cross products",
       "PerkTutor, Tissue Damage", swept_area},
      {"smoothness", "", "smoothness",
       "logarithmic dimensionless jerk of the filtered motion until the final position; nearer to 0 is smoother",
       "Hogan and Sternad 2009; Balasubramanian et al. 2012", smoothness_of},
      {"jerk_mm_per_s2_5", "mm/s^2.5", "root of the squared jerk",
       "square root of the sum of squared third differences times dt, of the same motion",
       "PerkTutor, Motion "
       "Smoothness, whose printed unit is another",
       jerk_of},
      {"tremor_mm", "mm", "tremor of the tip", "root mean square of the motion from 4 to 12 Hz, Welch's spectrum",
       "Bodkin", tremor_amplitude},
      {"tremor_Hz", "Hz", "frequency of the tremor", "where that spectrum is greatest", "Bodkin", tremor_frequency},
      {"shaft_sweep_deg", "deg", "turning of the shaft in the body",
       "sum of the angles between needle axes 50 ms apart", "PerkTutor, Rotation Total, without the spin",
       shaft_sweep}};
}

}  // namespace bodkin::training
