#include "core/rotation.h"

#include <algorithm>
#include <cmath>

#include "core/repeatable.h"

namespace bodkin {

Mat3 rotation_about(const Vec3& axis, double angle) noexcept {
  const double half = 0.5 * angle, s = repeatable::sin(half);
  return Eigen::Quaterniond(repeatable::cos(half), s * axis.x(), s * axis.y(), s * axis.z()).toRotationMatrix();
}

AxisAngle axis_angle_of(const Mat3& rotation) noexcept {
  const Eigen::Quaterniond turn(rotation);
  const double sine = turn.vec().norm();
  if (!(sine > 0.0)) return {};
  const double sign = turn.w() < 0.0 ? -1.0 : 1.0;
  return {turn.vec() * (sign / sine), 2.0 * repeatable::atan2(sine, std::abs(turn.w()))};
}

double angle_between(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) noexcept {
  const Eigen::Quaterniond turn = from.conjugate() * to;
  return 2.0 * repeatable::atan2(turn.vec().norm(), std::abs(turn.w()));
}

Arc::Arc(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) noexcept : from_(from), to_(to) {
  const double dot = from.dot(to), cosine = std::abs(dot);
  if (dot < 0.0) to_.coeffs() = -to_.coeffs();
  angle_ = repeatable::atan2(std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), cosine);
  sine_ = repeatable::sin(angle_);
}

Eigen::Quaterniond Arc::at(double part) const noexcept {
  double first = 1.0 - part, second = part;
  if (angle_ > 1e-7) {  // below, a straight line is the same to the last bit
    first = repeatable::sin(first * angle_) / sine_;
    second = repeatable::sin(second * angle_) / sine_;
  }
  return Eigen::Quaterniond(first * from_.coeffs() + second * to_.coeffs());
}

}  // namespace bodkin
