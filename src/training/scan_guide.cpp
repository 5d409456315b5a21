#include "training/scan_guide.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bodkin::training {

namespace {

constexpr std::string_view target_name = "target", process_prefix = "spinous_process_";
constexpr std::array<std::string_view, 3> scanned_vertebrae = {"L5", "L4", "L3"};

struct Interspaces {
  std::string_view vertebra, above, below;
};
constexpr std::array<Interspaces, 4> around_vertebrae = {
    {{"L2", "L1_L2", "L2_L3"}, {"L3", "L2_L3", "L3_L4"}, {"L4", "L3_L4", "L4_L5"}, {"L5", "L4_L5", "L5_S1"}}};

std::optional<Vec3> find_landmark(const anatomy::CaseDescription& description, std::string_view name) {
  for (const anatomy::Landmark& each : description.landmarks)
    if (each.name == name) return each.position;
  return std::nullopt;
}

double angle_between(const Vec3& one, const Vec3& other) {
  return std::atan2(one.cross(other).norm(), one.dot(other)) / degree;
}

std::optional<double> first_on(const std::vector<ProbeState>& track, const Attempt& attempt, std::string_view what) {
  const auto wanted = find_scan_target(attempt.description(), attempt.path(), what);
  if (!wanted) return std::nullopt;
  const double start = static_cast<double>(attempt.session().ticks.front().tick) * attempt.dt();
  const auto& machine = attempt.session().header.ultrasound;
  for (const ProbeState& probe : track) {
    if (is_shown(*wanted, probe, machine ? &*machine : nullptr, attempt.thresholds()))
      return std::max(0.0, probe.time - start);
  }
  return std::nullopt;
}

}  // namespace

std::optional<ScanTarget> find_scan_target(const anatomy::CaseDescription& description,
                                           const anatomy::NeedlePath& path, std::string_view what) {
  if (what == target_name) {
    ScanTarget found{.point = path.target};
    if (path.length() > 0.0) found.slice_along = path.direction();
    return found;
  }
  if (what.starts_with(process_prefix)) {
    const auto process = spinous_process(description, what.substr(process_prefix.size()));
    return process ? std::optional(ScanTarget{.point = process->middle, .beam_along = process->into}) : std::nullopt;
  }
  const auto landmark = find_landmark(description, what);
  return landmark ? std::optional(ScanTarget{.point = *landmark}) : std::nullopt;
}

bool is_shown(const ScanTarget& target, const ProbeState& probe, const anatomy::UltrasoundProbe* machine,
              const Thresholds& limits) {
  if (target.beam_along && angle_between(probe.into, *target.beam_along) > limits.guide_angle) return false;
  if (target.slice_along) {
    const double out_of_slice =
        std::asin(std::clamp(std::abs(target.slice_along->dot(probe.normal)), 0.0, 1.0)) / degree;
    if (out_of_slice > limits.guide_angle) return false;
  }
  return is_in_picture(probe, machine, target.point, limits.target_in_slice);
}

std::optional<SpinousProcess> spinous_process(const anatomy::CaseDescription& description,
                                              std::string_view vertebra) {
  for (const Interspaces& each : around_vertebrae) {
    if (each.vertebra != vertebra) continue;
    const auto above = find_landmark(description, each.above), below = find_landmark(description, each.below);
    const auto skin_above = find_landmark(description, std::string(each.above) + "_skin");
    const auto skin_below = find_landmark(description, std::string(each.below) + "_skin");
    if (!above || !below || !skin_above || !skin_below) return std::nullopt;
    const Vec3 canal = 0.5 * (*above + *below), skin = 0.5 * (*skin_above + *skin_below);
    if (!((canal - skin).norm() > 0.0)) return std::nullopt;
    return SpinousProcess{.middle = 0.5 * (canal + skin), .into = (canal - skin).normalized()};
  }
  return std::nullopt;
}

std::optional<double> first_shown(const Attempt& attempt, std::string_view what) {
  return first_on(probe_track(attempt.session()), attempt, what);
}

bool can_be_shown(const anatomy::CaseDescription& description, std::string_view what) {
  return find_scan_target(description, description.procedure.path.value_or(anatomy::NeedlePath()), what).has_value();
}

std::optional<Aim> aim_of(const Attempt& attempt) {
  const anatomy::NeedlePath& path = attempt.path();
  if (attempt.insertions.empty() || !(path.length() > 0.0)) return std::nullopt;
  const Insertion& insertion = attempt.insertions.back();
  const Vec3 &tip = attempt.tip[insertion.first], &axis = attempt.axis[insertion.first];
  Aim aim;
  aim.miss = (path.target - tip).cross(axis).norm();
  aim.off_line = (tip - path.entry).cross(path.direction()).norm();
  aim.angle = angle_between(axis, path.direction());
  std::size_t end = insertion.first;
  double deepest = attempt.depth[end];
  for (; end < insertion.last && deepest - attempt.depth[end] <= attempt.thresholds().retreat; ++end)
    deepest = std::max(deepest, attempt.depth[end]);
  for (const session::SessionEvent& each : attempt.session().events) {
    const std::size_t at = attempt.index_of(each);
    if (each.event.kind == forces::EventKind::bone_contact && at >= insertion.first && at <= end) ++aim.bone_contacts;
  }
  return aim;
}

std::vector<GuideStep> guide_steps(const Attempt& attempt) {
  std::vector<GuideStep> steps;
  const std::vector<ProbeState> track = probe_track(attempt.session());
  const auto aim = aim_of(attempt);
  if (track.empty() || !aim) return steps;
  const double entered = attempt.time[attempt.first_contact()];
  const auto was_shown = [&](std::string_view what) {
    const auto time = first_on(track, attempt, what);
    return time && *time < entered;
  };
  std::vector<GuideStep> processes;
  for (const std::string_view vertebra : scanned_vertebrae) {
    const std::string name = std::string(process_prefix) + std::string(vertebra);
    if (can_be_shown(attempt.description(), name)) processes.push_back({name, was_shown(name)});
  }
  if (processes.size() == scanned_vertebrae.size()) steps = std::move(processes);
  steps.push_back({std::string(target_name), was_shown(target_name)});
  const double tolerance = attempt.description().procedure.target_tolerance;
  steps.push_back({"line", aim->miss <= tolerance && aim->bone_contacts == 0});
  steps.push_back({"offset", aim->off_line < attempt.thresholds().guide_offset});
  steps.push_back({"angle", aim->angle < attempt.thresholds().guide_angle});
  return steps;
}

}  // namespace bodkin::training
