#include "haptics/calming.h"

#include <algorithm>

namespace bodkin::haptics {

namespace {
constexpr double half_force = 0.5, quarter_force = 0.25;
constexpr double calming_window = 0.025;  // s
constexpr double still_shakes = 0.5;      // of the way that the shaking makes in a calming_window
constexpr double calm_after = 10.0;       // s after which the whole force comes back
constexpr double force_return = 1.0;      // s that this takes
constexpr double shortest_watch = 0.1;    // s for which the motion decides about the next step; one cycle at least
}  // namespace

Calming::Step Calming::begin(const Shaking& shaking) noexcept {
  if (is_on()) return Step::none_left;
  share_ = half_force;
  damps_ = false;
  watching_ = true;
  shaking_ = shaking;
  since_ = for_ = 0.0;
  place_ = low_ = high_ = Vec3::Zero();
  return Step::softer;
}

Calming::Step Calming::step(const Vec3& moved, const Vec3& turned, double dt) noexcept {
  if (!is_on()) return Step::none;
  since_ += dt;
  if (since_ > calm_after) {
    damps_ = watching_ = false;
    share_ = std::min(1.0, share_ + half_force * dt / force_return);
    return Step::none;
  }
  if (!watching_) return Step::none;
  for_ += dt;
  place_ += shaking_.turns ? turned : moved;
  low_ = low_.cwiseMin(place_);
  high_ = high_.cwiseMax(place_);
  if (for_ < calming_window) return Step::none;
  const double reach = (high_ - low_).maxCoeff();
  for_ = 0.0;
  place_ = low_ = high_ = Vec3::Zero();
  if (reach < still_shakes * shaking_.width * std::min(1.0, 2.0 * shaking_.frequency * calming_window)) {
    watching_ = since_ < std::max(shortest_watch, 1.0 / shaking_.frequency);
    return Step::none;
  }
  if (damps_) return Step::none_left;
  damps_ = true;
  share_ = quarter_force;
  since_ = 0.0;
  return Step::damped;
}

}  // namespace bodkin::haptics
