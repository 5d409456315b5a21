#include <algorithm>
#include <cmath>
#include <vector>

#include "training/metric_groups.h"
#include "training/probe_track.h"

namespace bodkin::training {

namespace {

constexpr double at_target = 1.0;  // mm: nearer, the line to the target has no direction

struct Mean {
  double sum = 0.0, most = 0.0;
  int count = 0;

  void add(double value) {
    sum += value;
    most = std::max(most, value);
    ++count;
  }
  std::optional<double> mean() const { return count > 0 ? std::optional(sum / count) : std::nullopt; }
  std::optional<double> greatest() const { return count > 0 ? std::optional(most) : std::nullopt; }
};

struct Seen {
  Mean distance, angle;                // mm of the tip, deg of the needle
  Mean moving_distance, moving_angle;  // the same while the needle was in action
  Mean to_target;                      // deg in the slice, between needle and the line to the target
  Mean tip_seen, target_seen;          // 1: it was
};

// Samples of the probe while the needle was in the body.
std::optional<Seen> look(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  const double start = static_cast<double>(attempt.session().ticks.front().tick) * attempt.dt();
  const std::vector<char>& moving = measured.active;
  const auto& machine = attempt.session().header.ultrasound;
  Seen found;
  for (const ProbeState& probe : probe_track(attempt.session())) {
    const auto place = std::lower_bound(attempt.time.begin(), attempt.time.end(), probe.time - start);
    if (place == attempt.time.end()) continue;
    const auto i = static_cast<std::size_t>(place - attempt.time.begin());
    if (attempt.inside[i] == 0) continue;
    const Vec3& normal = probe.normal;
    const double distance = std::abs((attempt.hand[i] - probe.face).dot(normal));
    const double angle = std::asin(std::clamp(std::abs(attempt.axis[i].dot(normal)), 0.0, 1.0)) / degree;
    found.distance.add(distance);
    found.angle.add(angle);
    found.tip_seen.add(distance <= attempt.thresholds().tip_in_slice ? 1.0 : 0.0);
    const auto point = static_cast<std::size_t>(attempt.time[i] / measured.motion.interval + 0.5);
    if (moving[std::min(point, moving.size() - 1)] != 0) {
      found.moving_distance.add(distance);
      found.moving_angle.add(angle);
    }
    const Vec3 target = attempt.now(attempt.path().target, i);
    const bool shows_target =
        is_in_picture(probe, machine ? &*machine : nullptr, target, attempt.thresholds().target_in_slice);
    found.target_seen.add(shows_target ? 1.0 : 0.0);
    const auto in_slice = [&](const Vec3& v) { return Vec3(v - v.dot(normal) * normal); };
    const Vec3 way = in_slice(target - attempt.hand[i]), shaft = in_slice(attempt.axis[i]);
    if (way.norm() > at_target && shaft.norm() > 0.1)
      found.to_target.add(std::atan2(way.cross(shaft).norm(), way.dot(shaft)) / degree);
  }
  return found.distance.count > 0 ? std::optional(found) : std::nullopt;
}

std::optional<double> mean_of(const Measured& measured, Mean Seen::*member) {
  const auto seen = look(measured);
  return seen ? (*seen.*member).mean() : std::nullopt;
}

std::optional<double> greatest_of(const Measured& measured, Mean Seen::*member) {
  const auto seen = look(measured);
  return seen ? (*seen.*member).greatest() : std::nullopt;
}

std::optional<double> percent_of(const Measured& measured, Mean Seen::*member) {
  const auto seen = look(measured);
  return seen ? std::optional(100.0 * (*seen.*member).sum / (*seen.*member).count) : std::nullopt;
}

// PerkTutor asks whether any scanline ever met one structure; here the procedure names the structure, and a line ends
// at bone and gas, behind which an image shows nothing.
std::optional<double> structures_scanned(const Measured& measured) {
  if (!measured.attempt.session().header.ultrasound) return std::nullopt;
  return static_cast<double>(measured.scanned.size());
}

}  // namespace

std::vector<Metric> metrics_of_ultrasound() {
  return {{"tip_to_slice_mean_mm", "mm", "distance of the tip from the ultrasound slice, mean",
           "over the probe's samples with the needle in the body", "TrainUS",
           [](const Measured& m) { return mean_of(m, &Seen::distance); }},
          {"tip_to_slice_max_mm", "mm", "distance of the tip from the ultrasound slice, greatest",
           "the same, greatest", "TrainUS", [](const Measured& m) { return greatest_of(m, &Seen::distance); }},
          {"tip_to_slice_moving_mean_mm", "mm",
           "distance of the tip of a needle in action from the ultrasound slice, mean",
           "the same while the needle was in action (`in_action_percent`)", "TrainUS, while in action",
           [](const Measured& m) { return mean_of(m, &Seen::moving_distance); }},
          {"tip_to_slice_moving_max_mm", "mm",
           "distance of the tip of a needle in action from the ultrasound slice, greatest", "the same, greatest",
           "TrainUS, while in action", [](const Measured& m) { return greatest_of(m, &Seen::moving_distance); }},
          {"tip_in_slice_percent", "%", "time with the tip in the ultrasound slice",
           "share of those samples with the tip within 2 mm of the slice", "Bodkin",
           [](const Measured& m) { return percent_of(m, &Seen::tip_seen); }},
          {"target_in_slice_percent", "%", "time with the target in the ultrasound slice",
           "share of those samples with the target inside the picture and within 5 mm of its slice",
           "PerkTutor, Targets Scanned", [](const Measured& m) { return percent_of(m, &Seen::target_seen); }},
          {"needle_to_slice_deg", "deg", "angle between needle and ultrasound slice", "mean over those samples",
           "TrainUS", [](const Measured& m) { return mean_of(m, &Seen::angle); }},
          {"needle_to_slice_max_deg", "deg", "greatest angle between needle and ultrasound slice",
           "the same, greatest", "TrainUS", [](const Measured& m) { return greatest_of(m, &Seen::angle); }},
          {"needle_to_slice_moving_deg", "deg", "angle between a needle in action and the ultrasound slice",
           "mean while the needle was in action (`in_action_percent`)", "TrainUS, while in action",
           [](const Measured& m) { return mean_of(m, &Seen::moving_angle); }},
          {"needle_to_slice_moving_max_deg", "deg",
           "greatest angle between a needle in action and the ultrasound slice", "the same, greatest",
           "TrainUS, while in action", [](const Measured& m) { return greatest_of(m, &Seen::moving_angle); }},
          {"needle_to_target_deg", "deg", "angle between needle and the line to the target in the ultrasound picture",
           "both projected onto the slice, mean over the samples with the tip over 1 mm from the target", "TrainUS",
           [](const Measured& m) { return mean_of(m, &Seen::to_target); }},
          {"structures_scanned", "", "structures of the procedure that the ultrasound showed",
           "of the tissues and structures that the procedure names, those that a scanline met, before bone or gas "
           "ended it, at any time",
           "PerkTutor, Structure Scanned", structures_scanned}};
}

}  // namespace bodkin::training
