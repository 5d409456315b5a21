#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anatomy/case.h"
#include "core/geometry.h"

namespace bodkin::study {

// A straight path of a needle through a patient, as a machine that does not feel would take it. Places on it are mm
// from the path's entry along its direction, negative before the entry.
struct StraightPath {
  anatomy::NeedlePath path;
  Pose at_entry = Pose::Identity();  // the needle with its tip on the entry
  double surface = 0.0;              // the skin; depth counts from here
  double start = 0.0;                // 10 mm before the skin; the entry itself in a volume without skin before it
  double end = 0.0;          // the target or so much beyond it as was asked for, but no deeper than the hub lets
  bool ends_at_hub = false;  // the needle is too short for what was asked for
  double outside = 0.0;      // during withdrawal: far enough before the skin for tented skin to let go of the shaft
  std::vector<std::string> notes;  // what was assumed, one sentence each

  // The needle with its tip at a place. Poses differ in their tip alone, so that the axis stays exact.
  Pose needle_at(double place) const;
};

// The line from `entry` to `target` (LPS mm; the case's planned path where absent) and `beyond` mm further. Throws
// InputError when that is no path, lies outside the volume or misses the body (saying by how much).
StraightPath straight_path(const anatomy::Case& patient, const std::optional<Vec3>& entry,
                           const std::optional<Vec3>& target, double beyond = 0.0);

// Where the tip is, tick by tick, on its line from one place to another by `step` mm (> 0) a tick: without `from`,
// with `to` as the last.
std::vector<double> places_between(double from, double to, double step);

}  // namespace bodkin::study
