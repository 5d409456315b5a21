#include "haptics/calibration.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "core/error.h"

namespace bodkin::haptics {

namespace {

constexpr std::size_t fewest = 20;          // readings
constexpr double smallest_side = 20.0;      // mm
constexpr double smallest_swivel = 20.0;    // deg
constexpr double largest_residual = 2.0;    // mm
constexpr double largest_unrest = 5.0;      // deg
constexpr double shortest_stroke = 40.0;    // mm
constexpr double straightness = 4.0;        // length over width
constexpr double largest_weight = 5.0;      // N
constexpr double smallest_weight = 0.02;    // N; less counts as no weight
constexpr double least_follow_share = 0.2;  // of the requested way

[[noreturn]] void refuse(const char* what, double found, const char* rest) {
  std::ostringstream text;
  text.precision(3);
  text << what << found << rest;
  throw InputError(text.str());
}

void require_readings(std::span<const Pose> readings) {
  if (readings.size() < fewest) {
    refuse("the device gave ", static_cast<double>(readings.size()), " readings, expected 20 or more; try again");
  }
}

// The two largest extents of the tool's rotation, deg: standard deviations, doubled, of the rotation vectors from the
// mean pose.
Eigen::Vector3d swivel_of(std::span<const Pose> readings) {
  const Mat3 first = readings.front().linear();
  const double count = static_cast<double>(readings.size());
  std::vector<Vec3> turns;
  Vec3 mean = Vec3::Zero();
  for (const Pose& hand : readings) {
    const Eigen::AngleAxisd turn(Mat3(first.transpose() * hand.linear()));
    turns.emplace_back(turn.angle() * turn.axis());
    mean += turns.back() / count;
  }
  Mat3 covariance = Mat3::Zero();
  for (const Vec3& turn : turns) covariance += (turn - mean) * (turn - mean).transpose() / count;
  Eigen::SelfAdjointEigenSolver<Mat3> axes;
  axes.computeDirect(covariance, Eigen::EigenvaluesOnly);
  return 2.0 / degree * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();  // ascending
}

// The smallest turn that takes Z to `axis` (unit); half a turn about X where it is -Z.
Mat3 turn_of_z_to(const Vec3& axis) {
  const Vec3 about = Vec3::UnitZ().cross(axis);
  const double sine = about.norm();
  const Vec3 unit = sine > 1e-12 ? Vec3(about / sine) : Vec3(Vec3::UnitX());
  return Eigen::AngleAxisd(std::atan2(sine, axis.z()), unit).toRotationMatrix();
}

}  // namespace

DeviceCalibration::Reach reach_of(std::span<const Pose> readings) {
  require_readings(readings);
  DeviceCalibration::Reach reach{readings.front().translation(), readings.front().translation()};
  for (const Pose& hand : readings) {
    reach.low = reach.low.cwiseMin(hand.translation());
    reach.high = reach.high.cwiseMax(hand.translation());
  }
  const double side = (reach.high - reach.low).minCoeff();
  if (side < smallest_side) {
    refuse("the hand covered ", side,
           " mm along one axis, expected 20 mm or more; move to every corner of the workspace");
  }
  return reach;
}

TipFit tip_of(std::span<const Pose> readings) {
  require_readings(readings);
  const double swivel = swivel_of(readings)[1];
  if (swivel < smallest_swivel) {
    refuse("the tool was turned by ", swivel,
           " degrees, expected 20 or more about two axes; swivel it wider while the tip stays in its place");
  }
  // p + H o = c for every reading. With c the mean of the left sides, three equations for o remain: with the mean
  // rotation M and the mean position m, (1 - M^T M) o = M^T m - mean(H^T p), whose matrix the swivel makes regular.
  Mat3 turn = Mat3::Zero();
  Vec3 position = Vec3::Zero(), turned_back = Vec3::Zero();
  for (const Pose& hand : readings) {
    turn += hand.linear();
    position += hand.translation();
    turned_back += hand.linear().transpose() * hand.translation();
  }
  const double count = static_cast<double>(readings.size());
  turn /= count;
  position /= count;
  turned_back /= count;
  const Mat3 spread = Mat3::Identity() - turn.transpose() * turn;
  TipFit fit;
  fit.offset = spread.inverse() * (turn.transpose() * position - turned_back);
  fit.place = position + turn * fit.offset;
  double strayed = 0.0;
  for (const Pose& hand : readings) strayed += (hand * fit.offset - fit.place).squaredNorm();
  fit.residual = std::sqrt(strayed / count);
  if (fit.residual > largest_residual) {
    refuse("the tip strayed by ", fit.residual,
           " mm, expected 2 mm or less; put it into a dimple that holds it, and try again");
  }
  return fit;
}

TouchFit touch_of(std::span<const Pose> readings, const Vec3& tip_offset) {
  constexpr double most_spread = 1.0;  // mm
  if (readings.empty()) throw InputError("the device reported no pose; touch the point again");
  const auto count = static_cast<double>(readings.size());
  TouchFit fit;
  for (const Pose& hand : readings) fit.place += (hand * tip_offset) / count;
  double sum = 0.0;
  for (const Pose& hand : readings) sum += (hand * tip_offset - fit.place).squaredNorm();
  fit.spread = std::sqrt(sum / count);
  if (!(fit.spread <= most_spread)) {
    refuse("the tip moved by ", fit.spread,
           " mm, expected 1 or less; keep it on the point, and calibrate the tip if it does not stay while the tool "
           "turns");
  }
  return fit;
}

Vec3 tool_axis_of(std::span<const Pose> readings) {
  require_readings(readings);
  Vec3 sum = Vec3::Zero();
  for (const Pose& hand : readings) sum -= hand.linear().transpose().col(2);
  Vec3 axis = sum.normalized();
  double unrest = 0.0;
  for (const Pose& hand : readings) {
    const double cosine = std::clamp(-hand.linear().transpose().col(2).dot(axis), -1.0, 1.0);
    unrest = std::max(unrest, std::acos(cosine) / degree);
  }
  if (!(unrest <= largest_unrest)) {
    refuse("the tool turned by ", unrest,
           " degrees while it was to point straight down, expected 5 or less; hold it still");
  }
  return axis;
}

double mounting_of(std::span<const Pose> readings) {
  require_readings(readings);
  // The farthest reading from the first gives the direction of the stroke, the others its width.
  const Vec3 begin = readings.front().translation();
  const auto flat = [&](const Pose& hand) { return Eigen::Vector2d((hand.translation() - begin).head<2>()); };
  const Pose& farthest = *std::max_element(readings.begin(), readings.end(), [&](const Pose& a, const Pose& b) {
    return flat(a).norm() < flat(b).norm();
  });
  const Eigen::Vector2d stroke = flat(farthest);
  if (stroke.norm() < shortest_stroke) {
    refuse("the hand went ", stroke.norm(), " mm away, expected 40 mm or more; push it straight away from you");
  }
  const Eigen::Vector2d along = stroke.normalized();
  double width = 0.0;
  for (const Pose& hand : readings) {
    const Eigen::Vector2d here = flat(hand);
    width = std::max(width, std::abs(along.x() * here.y() - along.y() * here.x()));
  }
  if (width * straightness > stroke.norm()) {
    refuse("the hand strayed by ", width, " mm to the side; push it straight away from you, without turning back");
  }
  return std::numbers::pi / 2.0 - std::atan2(along.y(), along.x());
}

WeightFit weight_of(double from_below, double from_above) {
  WeightFit fit{0.5 * (from_below + from_above), 0.5 * std::abs(from_below - from_above)};
  if (!(fit.weight >= -fit.friction - smallest_weight) || fit.weight > largest_weight) {
    refuse("the handle seems to weigh ", fit.weight,
           " N, expected 0 to 5 N; leave it alone while it is weighed, and see that its controller's own gravity "
           "compensation is as you use it");
  }
  if (fit.friction > std::max(largest_weight / 5.0, fit.weight)) {
    refuse("between lifting and lowering, the handle's weight differs by ", 2.0 * fit.friction,
           " N; leave it alone while it is weighed");
  }
  fit.weight = fit.weight < smallest_weight ? 0.0 : fit.weight;
  return fit;
}

double level_friction(double from_one_side, double from_the_other, double way, double asked) noexcept {
  return std::abs(way) < least_follow_share * std::abs(asked) ? 0.0 : 0.5 * std::abs(from_one_side - from_the_other);
}

void apply(const DeviceCalibration& calibration, DeviceAbilities& abilities) {
  if (calibration.delay) abilities.measured_delay = calibration.delay;
  if (!calibration.reach) return;
  abilities.workspace_low = calibration.reach->low;
  abilities.workspace_high = calibration.reach->high;
}

void apply(const DeviceCalibration& calibration, ServoSettings& settings) {
  WorkspaceSettings& workspace = settings.workspace;
  if (calibration.reach) workspace.hand_middle = 0.5 * (calibration.reach->low + calibration.reach->high);
  if (calibration.mounting) {
    workspace.rotation = workspace.rotation * Eigen::AngleAxisd(*calibration.mounting, Vec3::UnitZ());
  }
  if (calibration.tip_offset) workspace.tip_offset = *calibration.tip_offset;
  if (calibration.tool_axis) {
    workspace.tool_rotation = turn_of_z_to(*calibration.tool_axis);
  }
  if (calibration.weight) settings.weight = *calibration.weight;
}

}  // namespace bodkin::haptics
