#pragma once

#include <Eigen/Core>

#include "core/geometry.h"

namespace bodkin::tracking {

using Matrix7 = Eigen::Matrix<double, 7, 7>;

// The uncertainty of a placement, in its target frame.
struct PlacementErrors {
  Vec3 middle = Vec3::Zero();  // mm
  // Of the shift of `middle` (mm), a small rotation about it (rad) and growth from it (fraction): 0 if not estimated.
  Matrix7 covariance = Matrix7::Zero();
  double freedom = 0.0;  // degrees of freedom from which the size of the covariance was estimated; above 0
};

// The displacement of a point, mm, as a linear function of shift, small rotation and growth about the middle;
// `from_middle`: the point relative to the middle.
Eigen::Matrix<double, 3, 7> displacement(const Vec3& from_middle);

// The covariance of the error of a placed point, mm^2, to first order.
Mat3 covariance_at(const PlacementErrors& errors, const Vec3& place);

}  // namespace bodkin::tracking
