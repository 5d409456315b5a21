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

Eigen::Quaterniond interpolate(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to, double part) noexcept {
  const double dot = from.dot(to), cosine = std::abs(dot), sign = dot < 0.0 ? -1.0 : 1.0;
  const double angle = repeatable::atan2(std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), cosine);
  double first = 1.0 - part, second = part;
  if (angle > 1e-7) {  // below, a straight line is the same to the last bit
    const double whole = repeatable::sin(angle);
    first = repeatable::sin(first * angle) / whole;
    second = repeatable::sin(second * angle) / whole;
  }
  return Eigen::Quaterniond(first * from.coeffs() + sign * second * to.coeffs());
}

}  // namespace bodkin
