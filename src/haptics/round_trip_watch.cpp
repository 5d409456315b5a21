#include "haptics/round_trip_watch.h"

#include <algorithm>
#include <cmath>

namespace bodkin::haptics {

namespace {
constexpr double trip_force = 0.1;  // N, below which nothing shakes the hand
// s: less than the interval of DelayProbe's pulses, which drive the hand on purpose.
constexpr double trip_unpushed = 0.125;
constexpr double longest_trip = 1.0 / 2.8;  // s: 3 Hz, for any period of the ticks
constexpr double driven_for = 0.6;          // s
constexpr int least_trips = 3;
}  // namespace

// Towards higher places, after the hand was on either side.
bool RoundTripWatch::passes(double before) const noexcept {
  return before < passed_ && place_ >= passed_ && low_ <= passed_ - swing_ && high_ >= passed_ + swing_;
}

void RoundTripWatch::begin(double work, double speed_integral, double time) noexcept {
  work_ = work;
  speed_integral_ = speed_integral;
  time_ = time;
  low_ = high_ = place_;
}

bool RoundTripWatch::step(const Vec3& moved, const Vec3& force, double dt) noexcept {
  const double size = force.norm();
  unpushed_ = size > trip_force ? 0.0 : unpushed_ + dt;
  if (unpushed_ > trip_unpushed) {
    reset();
    return false;
  }
  if (size > trip_force) axis_ = force * ((force.dot(axis_) < 0.0 ? -1.0 : 1.0) / size);

  const double before = place_, along = moved.dot(axis_), work = force.dot(moved),
               speed_integral = moved.squaredNorm() / dt;
  place_ += along;
  low_ = std::min(low_, place_);
  high_ = std::max(high_, place_);
  if (passes(before)) {
    const double rest = (place_ - passed_) / along;  // fraction of the tick that belongs to the next round trip
    const double took = time_ + (1.0 - rest) * dt;
    const bool is_driven =
        begun_ && work_ + (1.0 - rest) * work > gain_ * (speed_integral_ + (1.0 - rest) * speed_integral);
    frequency_ = 1.0 / took;
    width_ = (high_ - low_) * axis_.cwiseAbs().maxCoeff();
    lasting_ = is_driven ? lasting_ + took : 0.0;
    trips_ = is_driven ? trips_ + 1 : 0;
    begun_ = true;
    begin(rest * work, rest * speed_integral, rest * dt);
    if (lasting_ < driven_for || trips_ < least_trips) return false;
    lasting_ = 0.0;
    trips_ = 0;
    return true;
  }
  work_ += work;
  speed_integral_ += speed_integral;
  time_ += dt;
  if (time_ < longest_trip) return false;
  passed_ = 0.5 * (low_ + high_);
  begun_ = false;
  lasting_ = 0.0;
  trips_ = 0;
  begin(0.0, 0.0, 0.0);
  return false;
}

}  // namespace bodkin::haptics
