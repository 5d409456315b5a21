#include "tracking/placement_errors.h"

#include "tracking/cross_matrix.h"

namespace bodkin::tracking {

Eigen::Matrix<double, 3, 7> displacement(const Vec3& from_middle) {
  Eigen::Matrix<double, 3, 7> slope;
  slope.leftCols<3>().setIdentity();
  slope.block<3, 3>(0, 3) = -cross_matrix(from_middle);
  slope.col(6) = from_middle;
  return slope;
}

Mat3 covariance_at(const PlacementErrors& errors, const Vec3& place) {
  const auto slope = displacement(place - errors.middle);
  return slope * errors.covariance * slope.transpose();
}

}  // namespace bodkin::tracking
