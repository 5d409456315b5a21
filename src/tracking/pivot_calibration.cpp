#include "tracking/pivot_calibration.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tracking/pose_step.h"
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::tracking {

namespace {

constexpr double least_spin = 60.0;  // degrees
constexpr int most_turns = 6;        // of removing outliers and refitting

double angle_between(const Mat3& a, const Mat3& b) {
  return Eigen::AngleAxisd(a.transpose() * b).angle() / degree;
}

// The poses that moved slowly from and to both neighbours.
std::vector<Pose> slow_ones(const std::vector<TimedPose>& poses, double fastest, int& left_out) {
  std::vector<Pose> slow;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    double speed = 0.0;
    for (const std::size_t other : {i == 0 ? i : i - 1, i + 1 == poses.size() ? i : i + 1}) {
      const double span = std::abs(poses[i].time - poses[other].time);
      if (span <= 0.0) continue;
      speed = std::max(
          speed, angle_between(poses[i].camera_from_body.linear(), poses[other].camera_from_body.linear()) / span);
    }
    if (speed > fastest) {
      ++left_out;
    } else {
      slow.push_back(poses[i].camera_from_body);
    }
  }
  return slow;
}

void require_enough(const std::vector<Pose>& poses, int least, int too_fast) {
  if (static_cast<int>(poses.size()) >= least) return;
  throw InputError(
      fmt::format("{} poses are slow enough and {} are too fast; at least {} are needed, so turn the body "
                  "more slowly and for longer",
                  poses.size(), too_fast, least));
}

// Removes outliers; `error` of each pose, by the last fit. False: none was removed.
bool leave_out(std::vector<Pose>& poses, const std::vector<double>& error, double outlier, int& left_out) {
  std::vector<double> sorted = error;
  std::sort(sorted.begin(), sorted.end());
  // Residuals are lengths: the median of the length of a normal vector of three numbers is 1.54 of its deviation.
  const double limit = std::max(outlier * sorted[sorted.size() / 2] / 0.89, 1e-6);
  std::vector<Pose> kept;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (error[i] <= limit) kept.push_back(poses[i]);
  }
  const bool fewer = kept.size() < poses.size();
  left_out += static_cast<int>(poses.size() - kept.size());
  poses = std::move(kept);
  return fewer;
}

double rms_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double widest_turn(const std::vector<Pose>& poses) {
  double widest = 0.0;
  for (const Pose& a : poses) {
    for (const Pose& b : poses) widest = std::max(widest, angle_between(a.linear(), b.linear()));
  }
  return widest;
}

}  // namespace

PivotCalibration calibrate_pivot(const std::vector<TimedPose>& poses, const PivotGate& gate) {
  PivotCalibration made;
  std::vector<Pose> used = slow_ones(poses, gate.fastest, made.too_fast);
  for (int turn = 0; turn < most_turns; ++turn) {
    require_enough(used, gate.least_poses, made.too_fast);
    // R_i tip - pivot = -t_i for all poses, by the normal equations.
    Matrix6 normal = Matrix6::Zero();
    Vector6 right = Vector6::Zero();
    for (const Pose& pose : used) {
      Eigen::Matrix<double, 3, 6> row;
      row << pose.linear(), -Mat3::Identity();
      normal += row.transpose() * row;
      right -= row.transpose() * pose.translation();
    }
    const Eigen::LDLT<Matrix6> solved(normal);
    const Vector6 pivots = solved.vectorD();
    if (pivots.minCoeff() < 1e-9 * pivots.maxCoeff()) {
      throw InputError("the body turned about one axis only, so its tip is undetermined; tilt it in all directions");
    }
    const Vector6 found = solved.solve(right);
    made.tip = found.head<3>();
    made.pivot = found.tail<3>();
    std::vector<double> error;
    for (const Pose& pose : used) error.push_back((pose * made.tip - made.pivot).norm());
    made.used = static_cast<int>(used.size());
    made.rms = rms_of(error);
    made.mean = mean_of(error);
    const double poses_used = static_cast<double>(used.size());
    const double variance = made.rms * made.rms * poses_used / (3.0 * poses_used - 6.0);
    made.deviation = std::sqrt(variance * inverse_of(normal).topLeftCorner<3, 3>().trace());
    if (!leave_out(used, error, gate.outlier, made.outliers)) break;
  }
  made.cone = 0.0;
  for (const Pose& a : used) {
    for (const Pose& b : used) {
      const Vec3 one = (a.translation() - made.pivot).normalized(),
                 other = (b.translation() - made.pivot).normalized();
      made.cone = std::max(made.cone, std::acos(std::clamp(one.dot(other), -1.0, 1.0)) / degree);
    }
  }
  if (made.cone < gate.least_cone) {
    throw InputError(
        fmt::format("the body was tilted by {:.0f} degrees in all; at least {:.0f} are needed to find its "
                    "tip, so tilt it further in all directions",
                    made.cone, gate.least_cone));
  }
  return made;
}

SpinCalibration calibrate_spin(const std::vector<TimedPose>& poses, const PivotGate& gate) {
  SpinCalibration made;
  std::vector<Pose> used = slow_ones(poses, gate.fastest, made.too_fast);
  for (int turn = 0; turn < most_turns; ++turn) {
    require_enough(used, gate.least_poses, made.too_fast);
    // The direction in the body that its poses turn least: R^T mean(R) a is nearest to a.
    Mat3 mean = Mat3::Zero();
    for (const Pose& pose : used) mean += pose.linear();
    mean /= static_cast<double>(used.size());
    const Eigen::SelfAdjointEigenSolver<Mat3> directions(mean.transpose() * mean);
    made.axis = directions.eigenvectors().col(2);
    if (made.axis.z() < 0.0) made.axis = -made.axis;
    const Vec3 still = (mean * made.axis).normalized();
    std::vector<double> error;
    for (const Pose& pose : used)
      error.push_back(std::acos(std::clamp(still.dot(pose.linear() * made.axis), -1.0, 1.0)) / degree);
    made.used = static_cast<int>(used.size());
    made.rms = rms_of(error);
    made.mean = mean_of(error);
    if (!leave_out(used, error, gate.outlier, made.outliers)) break;
  }
  made.turned = widest_turn(used);
  if (made.turned < least_spin) {
    throw InputError(fmt::format("the body was spun by {:.0f} degrees; at least {:.0f} are needed to find its axis",
                                 made.turned, least_spin));
  }
  return made;
}

}  // namespace bodkin::tracking
