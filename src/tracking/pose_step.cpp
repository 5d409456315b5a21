#include "tracking/pose_step.h"

#include <Eigen/Cholesky>

namespace bodkin::tracking {

Vector6 step_between(const Pose& from, const Pose& to) {
  const Eigen::AngleAxisd turn(to.linear() * from.linear().transpose());
  Vector6 step;
  step << to.translation() - from.translation(), turn.angle() * turn.axis();
  return step;
}

void take_step(Pose& pose, const Vector6& step) {
  pose.translation() += step.head<3>();
  const Vec3 turn = step.tail<3>();
  if (turn.norm() > 0.0) pose.linear() = (Eigen::AngleAxisd(turn.norm(), turn.normalized()) * pose.linear()).eval();
}

Matrix6 inverse_of(const Matrix6& matrix) {
  return matrix.ldlt().solve(Matrix6::Identity());
}

}  // namespace bodkin::tracking
