#include "haptics/oscillation_watch.h"

#include <algorithm>

namespace bodkin {

namespace {
constexpr double least_force = 0.1;         // N, below which nothing shakes the hand
constexpr double longest_unpushed = 0.05;   // s
constexpr double half_period = 0.5 / 30.0;  // s, of the slowest oscillation
constexpr double long_enough = 0.1;         // s
}  // namespace

bool OscillationWatch::step(const Vec3& moved, const Vec3& force, double dt) noexcept {
  const double size = force.norm();
  unpushed_ = size > least_force ? 0.0 : unpushed_ + dt;
  if (unpushed_ > longest_unpushed) {
    reset();
    return false;
  }
  // A force that swings through zero turns about; the axis keeps its sign, so that every swing of the hand counts
  // once.
  if (size > least_force) axis_ = force * ((force.dot(axis_) < 0.0 ? -1.0 : 1.0) / size);

  place_ += moved.dot(axis_);
  since_turn_ += dt;
  if (since_turn_ > half_period) shaking_ = 0.0;
  extreme_ = forwards_ ? std::max(extreme_, place_) : std::min(extreme_, place_);
  const double back = forwards_ ? extreme_ - place_ : place_ - extreme_;
  if (back < amplitude_) return false;

  forwards_ = !forwards_;
  extreme_ = place_;
  if (since_turn_ <= half_period) shaking_ += since_turn_;
  since_turn_ = 0.0;
  if (shaking_ < long_enough) return false;
  shaking_ = 0.0;
  return true;
}

}  // namespace bodkin
