#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "anatomy/breathing.h"
#include "anatomy/needle_path.h"
#include "core/geometry.h"

namespace bodkin::station {

// A straight needle of `length` mm that sticks to tissue: `places` (LPS mm, two or more) is where the tissue along it
// is now, at equal distances from its entry to its tip. The line with the least sum of squared distances from each
// part of the needle to its tissue.
Pose rigid_needle(std::span<const Vec3> places, double length);

// Where needles that were left in the body are while its tissue moves: breath, a probe that presses and another
// needle take them along. For display; what they do to the tissue in turn is in the equations of the tick alone.
class LeftNeedleMotion {
 public:
  LeftNeedleMotion() = default;
  // `left`: from entry to tip, at rest. `breath`: of a patient who breathes.
  explicit LeftNeedleMotion(const std::vector<anatomy::NeedlePath>& left,
                            const std::optional<anatomy::BreathField>& breath = {});

  std::size_t needles() const noexcept { return left_.size(); }
  // LPS mm at rest, of the tissue along all needles in turn.
  const std::vector<Vec3>& points() const noexcept { return points_; }
  // mm, the motion of each of points() by breath alone.
  Vec3 breathed(std::size_t point, double drawn_in) const noexcept;
  // Tip and axis of each needle; unchanged until the next call. `displacements`: mm, x y z of each of points() in
  // turn, by all but breath; another number of values: by breath alone.
  const std::vector<Pose>& poses(std::span<const float> displacements, double drawn_in);

 private:
  struct Left {
    std::size_t first, count;  // of its points
    double length;             // mm
  };

  std::optional<anatomy::BreathField> breath_;
  std::vector<Left> left_;
  std::vector<Vec3> points_, places_;  // at rest and now
  std::vector<Pose> poses_;
};

}  // namespace bodkin::station
