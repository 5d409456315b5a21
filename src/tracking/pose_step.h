#pragma once

#include "core/geometry.h"

namespace bodkin::tracking {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

// The step from one pose to another: shift (mm) and rotation vector (radians), both along the axes in which the poses
// are given.
Vector6 step_between(const Pose& from, const Pose& to);
void take_step(Pose& pose, const Vector6& step);

// Of a symmetric, positive definite matrix.
Matrix6 inverse_of(const Matrix6& matrix);

}  // namespace bodkin::tracking
