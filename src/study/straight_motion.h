#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anatomy/case.h"
#include "core/geometry.h"

namespace bodkin::study {

// A straight path of a needle through a patient, driven by a machine that does not feel forces. Positions on it are
// mm from the path's entry along its direction, negative before the entry.
struct StraightPath {
  anatomy::NeedlePath path;
  Pose at_entry = Pose::Identity();  // the needle with its tip on the entry
  double surface = 0.0;              // the skin; origin of depth
  double start = 0.0;              // 10 mm before the skin; the entry itself in a volume without skin in front of it
  double end = 0.0;                // the target or as far beyond it as requested, but no deeper than the hub allows
  bool ends_at_hub = false;        // the needle is too short for the request
  double outside = 0.0;            // during withdrawal: far enough outside for tented skin to release the shaft
  std::vector<std::string> notes;  // assumptions, one sentence each

  // The needle with its tip at a position. Poses differ only in their tip, so that the axis stays exact.
  Pose needle_at(double place) const;
};

// The line from `entry` to `target` (LPS mm; the case's planned path if absent) and `beyond` mm farther. Throws
// InputError when it is invalid, lies outside the volume or misses the body (saying by how much).
StraightPath straight_path(const anatomy::Case& patient, const std::optional<Vec3>& entry,
                           const std::optional<Vec3>& target, double beyond = 0.0);

// Positions of the tip, tick by tick, on its line from one position to another by `step` mm (> 0) per tick: without
// `from`, with `to` as the last.
std::vector<double> places_between(double from, double to, double step);

}  // namespace bodkin::study
