#include "views/depth_segments.h"

#include <algorithm>
#include <cstddef>

#include "forces/tissue_path.h"

namespace bodkin::views {

std::vector<DepthSegment> depth_segments(const anatomy::TissueVolume& tissues, const Vec3& entry,
                                         const Vec3& direction, double length) {
  constexpr double layer = 0.1;  // mm
  if (!(length > 0.0)) return {};
  forces::TissuePath path(layer, length);
  path.restart(entry, direction);
  path.extend_to(length, tissues);
  std::vector<DepthSegment> segments;
  const std::span<const anatomy::TissueId> layers = path.layers();
  bool in_body = false;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const double from = layer * static_cast<double>(i), to = std::min(length, layer * static_cast<double>(i + 1));
    const bool air = layers[i] == anatomy::tissue::air;
    if (air && in_body) break;
    if (air) continue;  // the surface lies up to a voxel below the entry
    in_body = true;
    if (!segments.empty() && segments.back().tissue == layers[i]) {
      segments.back().to = to;
    } else {
      segments.push_back({segments.empty() ? 0.0 : from, to, layers[i]});
    }
  }
  return segments;
}

const DepthSegment* segment_at(std::span<const DepthSegment> segments, double depth) {
  for (const DepthSegment& segment : segments) {
    if (depth >= segment.from && depth < segment.to) return &segment;
  }
  return nullptr;
}

std::vector<double> spread_labels(std::span<const double> desired, double gap, double low, double high) {
  const std::size_t count = desired.size();
  if (count == 0) return {};
  const double room = high - low;
  const double between = count > 1 ? std::min(gap, room / static_cast<double>(count - 1)) : gap;
  // With place[i] = y[i] + i * between, the gaps require ascending y: groups that descend are set to their mean.
  struct Group {
    double sum = 0.0;
    std::size_t size = 0;
    double mean() const { return sum / static_cast<double>(size); }
  };
  std::vector<Group> groups;
  for (std::size_t i = 0; i < count; ++i) {
    groups.push_back({desired[i] - between * static_cast<double>(i), 1});
    while (groups.size() > 1 && groups[groups.size() - 2].mean() > groups.back().mean()) {
      groups[groups.size() - 2].sum += groups.back().sum;
      groups[groups.size() - 2].size += groups.back().size;
      groups.pop_back();
    }
  }
  std::vector<double> places;
  places.reserve(count);
  const double last = high - between * static_cast<double>(count - 1);
  for (const Group& group : groups) {
    for (std::size_t i = 0; i < group.size; ++i) {
      places.push_back(std::clamp(group.mean(), low, std::max(low, last)) +
                       between * static_cast<double>(places.size()));
    }
  }
  return places;
}

}  // namespace bodkin::views
