#include "anatomy/label_distance.h"

#include <array>
#include <cmath>
#include <limits>

#include "core/parallel_for.h"

namespace bodkin::anatomy {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

// The lower envelope of the parabolas height[i] + (x - place[i])^2, kept as those that are lowest somewhere.
class Envelope {
 public:
  explicit Envelope(std::size_t most) : place_(most), height_(most), from_(most) {}

  void clear() {
    count_ = 0;
    at_ = 0;
  }
  // Places must rise from call to call.
  void add(double place, double height) {
    if (height == nowhere) return;
    double from = -nowhere;
    while (count_ > 0) {
      const std::size_t last = count_ - 1;
      from = 0.5 * (place + place_[last] + (height - height_[last]) / (place - place_[last]));
      if (from > from_[last]) break;
      --count_;
      from = -nowhere;
    }
    place_[count_] = place;
    height_[count_] = height;
    from_[count_] = from;
    ++count_;
  }
  // The lowest value at x, which must rise from call to call after the last add.
  double lowest(double x) {
    if (count_ == 0) return nowhere;
    while (at_ + 1 < count_ && from_[at_ + 1] <= x) ++at_;
    const double away = x - place_[at_];
    return height_[at_] + away * away;
  }

 private:
  std::vector<double> place_, height_, from_;
  std::size_t count_ = 0, at_ = 0;
};

// Whether each label is computed.
using Wanted = std::array<bool, 256>;

Wanted all_but(std::span<const std::uint8_t> left_out) {
  Wanted wanted;
  wanted.fill(true);
  for (const std::uint8_t label : left_out) wanted[label] = false;
  return wanted;
}

// Replaces `values` along one axis by min over q of (values[q] + |p - q|^2), within runs of one wanted label. Where
// `borders` is set the voxel beyond an end of the run counts with value 0.
void sweep(const Volume<std::uint8_t>& labels, const Wanted& wanted, std::size_t axis, bool borders,
           std::vector<double>& values) {
  const auto& size = labels.grid.size;
  const std::array<std::size_t, 3> stride = {1, static_cast<std::size_t>(size[0]),
                                             static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1])};
  const std::size_t count = static_cast<std::size_t>(size[axis]), step = stride[axis];
  const std::size_t u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  const double spacing = labels.grid.spacing[static_cast<Eigen::Index>(axis)];
  parallel_for(static_cast<std::size_t>(size[v]), [&](std::size_t b) {
    Envelope envelope(count + 2);
    for (std::size_t a = 0; a < static_cast<std::size_t>(size[u]); ++a) {
      const std::size_t line = a * stride[u] + b * stride[v];
      for (std::size_t begin = 0, end = 0; begin < count; begin = end) {
        const std::uint8_t label = labels.voxels[line + begin * step];
        while (end < count && labels.voxels[line + end * step] == label) ++end;
        if (!wanted[label]) continue;
        envelope.clear();
        if (borders && begin > 0) envelope.add(spacing * (static_cast<double>(begin) - 1.0), 0.0);
        for (std::size_t i = begin; i < end; ++i) {
          envelope.add(spacing * static_cast<double>(i), values[line + i * step]);
        }
        if (borders && end < count) envelope.add(spacing * static_cast<double>(end), 0.0);
        for (std::size_t i = begin; i < end; ++i) {
          values[line + i * step] = envelope.lowest(spacing * static_cast<double>(i));
        }
      }
    }
  });
}

}  // namespace

std::vector<float> distance_to_other_label(const Volume<std::uint8_t>& labels,
                                           std::span<const std::uint8_t> left_out) {
  const Wanted wanted = all_but(left_out);
  std::vector<double> squared(labels.voxels.size(), nowhere);
  for (std::size_t axis = 0; axis < 3; ++axis) sweep(labels, wanted, axis, true, squared);
  std::vector<float> distance(squared.size());
  for (std::size_t i = 0; i < squared.size(); ++i) distance[i] = static_cast<float>(std::sqrt(squared[i]));
  return distance;
}

std::vector<std::uint8_t> thick_enough(const Volume<std::uint8_t>& labels, const std::vector<float>& distance,
                                       const std::vector<float>& radius, std::span<const std::uint8_t> left_out) {
  // |p - c|^2 - distance[c]^2 < 0 for some middle c: then p lies in its ball. The ball holds one label only, so the
  // path from c to p, axis by axis, never leaves the label, and the runs may be swept one by one.
  const double half = 0.5 * labels.grid.spacing.minCoeff();
  constexpr double slack = 1e-5;  // mm, of single precision
  const Wanted wanted = all_but(left_out);
  std::vector<double> power(labels.voxels.size(), nowhere);
  for (std::size_t i = 0; i < power.size(); ++i) {
    if (!wanted[labels.voxels[i]]) continue;
    const double away = static_cast<double>(distance[i]);
    if (away - half + slack < static_cast<double>(radius[i])) continue;
    const double reach = std::isinf(away) ? 1e6 : away - slack;
    power[i] = -reach * reach;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) sweep(labels, wanted, axis, false, power);
  std::vector<std::uint8_t> kept(power.size());
  for (std::size_t i = 0; i < power.size(); ++i) kept[i] = power[i] < 0.0 ? 1 : 0;
  return kept;
}

}  // namespace bodkin::anatomy
