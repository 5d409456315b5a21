#include "tracking/rest_filter.h"

#include <Eigen/Cholesky>

namespace bodkin::tracking {

namespace {

constexpr std::size_t most_poses = 15;
// Squared Mahalanobis distance with six degrees of freedom that 99.7 % of poses at rest keep below.
constexpr double rest_limit = 19.8;

using Vector6 = Eigen::Matrix<double, 6, 1>;

Vector6 difference(const Pose& from, const Pose& to) {
  const Eigen::AngleAxisd turn(to.linear() * from.linear().transpose());
  Vector6 change;
  change << to.translation() - from.translation(), turn.angle() * turn.axis();
  return change;
}

}  // namespace

Pose RestFilter::mean() const {
  Pose mean = poses_.front();
  Vector6 sum = Vector6::Zero();
  for (const Pose& pose : poses_) sum += difference(mean, pose);
  sum /= static_cast<double>(poses_.size());
  mean.translation() += sum.head<3>();
  const Vec3 turn = sum.tail<3>();
  if (turn.norm() > 0.0) mean.linear() = (Eigen::AngleAxisd(turn.norm(), turn.normalized()) * mean.linear()).eval();
  return mean;
}

Pose RestFilter::add(const Pose& pose, const Matrix6& covariance) {
  if (!poses_.empty()) {
    const Vector6 change = difference(mean(), pose);
    const double spread = 1.0 + 1.0 / static_cast<double>(poses_.size());
    const double distance = change.dot(covariance.ldlt().solve(change)) / spread;
    if (!(distance < rest_limit)) poses_.clear();
  }
  poses_.push_back(pose);
  if (poses_.size() > most_poses) poses_.pop_front();
  return mean();
}

}  // namespace bodkin::tracking
