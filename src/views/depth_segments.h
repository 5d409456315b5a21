#pragma once

#include <span>
#include <vector>

#include "anatomy/tissue.h"
#include "anatomy/volume.h"

namespace bodkin::views {

// One tissue on a line into the patient, mm from the line's intersection with the skin.
struct DepthSegment {
  double from = 0.0, to = 0.0;
  anatomy::TissueId tissue = anatomy::tissue::air;
};

// The tissues along a line from `entry` along `direction` (unit) down to `length` mm, in order, in the same layers as
// in the tick. Ends at the first air after the body.
std::vector<DepthSegment> depth_segments(const anatomy::TissueVolume& tissues, const Vec3& entry,
                                         const Vec3& direction, double length);

// The segment that contains a depth; null above the skin and below the last one.
const DepthSegment* segment_at(std::span<const DepthSegment> segments, double depth);

// Moves labels apart so that neighbours are at least `gap` from each other and all lie between `low` and `high`, each
// as close as possible to its desired position. `desired`: ascending. Without enough room they are spaced evenly,
// closer than `gap`.
std::vector<double> spread_labels(std::span<const double> desired, double gap, double low, double high);

}  // namespace bodkin::views
