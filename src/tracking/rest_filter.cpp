#include "tracking/rest_filter.h"

namespace bodkin::tracking {

namespace {

constexpr std::size_t most_poses = 15;
// 99.7 % quantile of the squared Mahalanobis distance of poses at rest, six degrees of freedom.
constexpr double rest_limit = 19.8;

}  // namespace

Pose RestFilter::mean() const {
  Pose mean = poses_.front();
  Vector6 sum = Vector6::Zero();
  for (const Pose& pose : poses_) sum += step_between(mean, pose);
  sum /= static_cast<double>(poses_.size());
  take_step(mean, sum);
  return mean;
}

Pose RestFilter::add(const Pose& pose, const Matrix6& covariance) {
  if (!poses_.empty()) {
    const Vector6 change = step_between(mean(), pose);
    const double spread = 1.0 + 1.0 / static_cast<double>(poses_.size());
    const double distance = change.dot(inverse_of(covariance) * change) / spread;
    if (!(distance < rest_limit)) poses_.clear();
  }
  poses_.push_back(pose);
  if (poses_.size() > most_poses) poses_.pop_front();
  return mean();
}

}  // namespace bodkin::tracking
