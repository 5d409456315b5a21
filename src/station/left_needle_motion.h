#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "anatomy/breathing.h"
#include "anatomy/needle_path.h"
#include "core/geometry.h"

namespace bodkin::station {

// A straight needle of `length` mm that sticks to tissue: `places` (LPS mm, two or more) are the present positions of
// the tissue along it, at equal distances from its entry to its tip. The line with the least sum of squared distances
// from each part of the needle to its tissue.
Pose rigid_needle(std::span<const Vec3> places, double length);

// The poses of needles left in the body while its tissue moves: breathing, a pressing probe and another needle carry
// them. For display; their own effect on the tissue is only in the equations of the tick.
class LeftNeedleMotion {
 public:
  LeftNeedleMotion() = default;
  // `left`: from entry to tip, at rest. `breath`: of a breathing patient.
  explicit LeftNeedleMotion(const std::vector<anatomy::NeedlePath>& left,
                            const std::optional<anatomy::BreathField>& breath = {});

  std::size_t needles() const noexcept { return left_.size(); }
  // LPS mm at rest, of the tissue along all needles, one after another.
  const std::vector<Vec3>& points() const noexcept { return points_; }
  // mm, motion of one of points() only by breathing.
  Vec3 breathed(std::size_t point, double drawn_in) const noexcept;
  // Tip and axis of each needle; unchanged until the next call. `displacements`: mm, x y z of each of points(),
  // without breathing; any other number of values: only breathing.
  const std::vector<Pose>& poses(std::span<const float> displacements, double drawn_in);

 private:
  struct Left {
    std::size_t first, count;  // its points
    double length;             // mm
  };

  std::optional<anatomy::BreathField> breath_;
  std::vector<Left> left_;
  std::vector<Vec3> points_, places_;  // at rest and at present
  std::vector<Pose> poses_;
};

}  // namespace bodkin::station
