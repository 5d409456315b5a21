#include <algorithm>
#include <cmath>

#include "training/metric_groups.h"
#include "training/probe_track.h"
#include "training/scan_guide.h"

namespace bodkin::training {

namespace {

std::optional<double> aim_miss(const Measured& measured) {
  const auto aim = aim_of(measured.attempt);
  return aim ? std::optional(aim->miss) : std::nullopt;
}

std::optional<double> aim_off_line(const Measured& measured) {
  const auto aim = aim_of(measured.attempt);
  return aim ? std::optional(aim->off_line) : std::nullopt;
}

std::optional<double> bone_on_first_way(const Measured& measured) {
  const auto aim = aim_of(measured.attempt);
  return aim ? std::optional(static_cast<double>(aim->bone_contacts)) : std::nullopt;
}

std::optional<double> spinous_processes_shown(const Measured& measured) {
  const auto steps = guide_steps(measured.attempt);
  double shown = 0.0;
  bool any = false;
  for (const GuideStep& each : steps) {
    if (!each.name.starts_with("spinous_process_")) continue;
    any = true;
    shown += each.kept ? 1.0 : 0.0;
  }
  return any ? std::optional(shown) : std::nullopt;
}

std::optional<double> time_target_was_shown(const Measured& measured) {
  return first_shown(measured.attempt, "target");
}

std::optional<double> guide_steps_kept(const Measured& measured) {
  const auto steps = guide_steps(measured.attempt);
  if (steps.empty()) return std::nullopt;
  const auto kept = std::count_if(steps.begin(), steps.end(), [](const GuideStep& each) { return each.kept; });
  return 100.0 * static_cast<double>(kept) / static_cast<double>(steps.size());
}

std::optional<double> nearest_forbidden(const Measured& measured) {
  return measured.nearest_forbidden;
}

}  // namespace

std::vector<Metric> metrics_of_guidance() {
  return {
      {"aim_miss_mm", "mm", "distance of the needle's line at the skin from the target",
       "of the needle's line, continued beyond the tip, at the first contact of the last insertion",
       "TrainUS, trajectory hits the target", aim_miss},
      {"aim_off_line_mm", "mm", "distance of the tip at the skin from the line of the planned path",
       "at the first contact of the last insertion", "TrainUS, distance from the optimal line", aim_off_line},
      {"bone_on_first_way", "", "contacts with bone on the first way in",
       "of the last insertion, before the needle was drawn back by over 5 mm", "TrainUS, trajectory hits the spine",
       bone_on_first_way},
      {"spinous_processes_shown", "", "spinous processes of L5, L4 and L3 that the ultrasound showed",
       "before the first insertion, inside the picture and within 5 mm of its slice, the beam within 15 deg of the "
       "straight way from skin to canal; of cases with the landmarks of the interspaces",
       "TrainUS, lumbar insertion", spinous_processes_shown},
      {"target_shown_first_s", "s", "time until the ultrasound first showed the target",
       "inside the picture, within 5 mm of its slice, the planned path within 15 deg of it", "TrainUS",
       time_target_was_shown},
      {"guide_steps_percent", "%", "steps of a guided insertion that were kept",
       "of seven: the spinous processes of L5, L4 and L3 and the target shown before the first insertion; at the "
       "skin the needle's line through the target (the tolerance of the case) and free of bone, the tip less than "
       "10 mm and the needle less than 15 deg from the planned path; of the last four without a lumbar spine",
       "TrainUS, lumbar insertion", guide_steps_kept},
      {"nearest_forbidden_mm", "mm", "least distance from what must not be entered",
       "of the tip in the body from the nearest voxel of what the procedure forbids and the case marks as critical; "
       "0 where it entered; of what is within 100 mm",
       "Lampotang et al. 2013, near misses", nearest_forbidden}};
}

}  // namespace bodkin::training
