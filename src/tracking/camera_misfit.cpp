#include "tracking/camera_misfit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Cholesky>

namespace bodkin::tracking {

namespace {

// Pose, tone curve, blur and focal length are those of the whole body, gain and offset of the light those of one
// face; last comes the residual.
constexpr int of_pose = 6, tone_at = 6, blur_at = 7, focal_at = 8, shared = 9, of_light = 4,
              residual = shared + of_light;
constexpr double wider = 1.2;            // of the variance, to measure how the pattern changes with it
constexpr double focal_deviation = 0.1;  // before any data: a single marker says nothing
constexpr double by_chance = 5.0;        // standard deviations

using Numbers = Eigen::Matrix<double, residual + 1, 1>;
using NumberSums = Eigen::Matrix<double, residual + 1, residual + 1>;
using Normal = Eigen::Matrix<double, shared, shared>;
using Right = Eigen::Matrix<double, shared, 1>;

// Adds a face to the normal equations, its light eliminated.
void add_face(const FacePattern& face, const Pose& place, const std::vector<PatternRow>& rows,
              const std::vector<PatternRow>& blurred, double by_blur, Normal& normal, Right& right) {
  const FaceLight fitted = fit_light(rows);
  if (!(fitted.light[0] > 0.02)) return;  // no contrast
  const double half = 0.5 * face.face->side;
  const Mat3 to_face = place.linear().transpose();
  NumberSums sums = NumberSums::Zero();
  double edge_squares = 0.0, edge_weights = 0.0;
  std::size_t same = 0;
  for (const PatternRow& row : rows) {
    while (same < blurred.size() && blurred[same].pixel < row.pixel) ++same;
    if (same == blurred.size()) break;
    if (blurred[same].pixel != row.pixel) continue;
    const double m = static_cast<double>(row.model), u = static_cast<double>(row.u), v = static_cast<double>(row.v);
    const double gain = fitted.light[0] + fitted.light[1] * u + fitted.light[2] * v;
    const double left = static_cast<double>(row.light) - gain * m - fitted.light[3], size = std::abs(left);
    if (size > 8.0 * fitted.scale) continue;
    Numbers x;
    for (int i = 0; i < of_pose; ++i) x[i] = gain * static_cast<double>(row.slope[i]);
    edge_squares += x.head<2>().norm() * left * left;
    edge_weights += x.head<2>().norm();
    x[tone_at] = gain * m * (1.0 - m);
    x[blur_at] = gain * (static_cast<double>(blurred[same].model) - m) / by_blur;
    // A different focal length acts as if every point lay farther from the camera's axis by that fraction.
    const Vec3 at = place * Vec3(half * u, half * v, 0.0);
    x[focal_at] = x.head<3>().dot(to_face * Vec3(at.x(), at.y(), 0.0));
    x.segment<of_light>(shared) << m, m * u, m * v, 1.0;
    x[residual] = left;
    sums += (size < 2.5 * fitted.scale ? 1.0 : 2.5 * fitted.scale / size) * x * x.transpose();
  }
  const double noise = std::max(edge_squares / std::max(edge_weights, 1e-9), 1e-7);
  const Eigen::LDLT<Eigen::Matrix4d> lights(sums.block<of_light, of_light>(shared, shared));
  const Eigen::Matrix<double, of_light, shared> across = sums.block<of_light, shared>(shared, 0);
  const Eigen::Matrix<double, of_light, shared> removed = lights.solve(across);
  Normal axes = Normal::Identity();  // of the camera, from those of the face
  axes.topLeftCorner<3, 3>() = axes.block<3, 3>(3, 3) = place.linear();
  normal += axes * (sums.topLeftCorner<shared, shared>() - across.transpose() * removed) * axes.transpose() / noise;
  right += axes *
           (sums.block<shared, 1>(0, residual) - removed.transpose() * sums.block<of_light, 1>(shared, residual)) /
           noise;
}

}  // namespace

bool Estimate::exceeds(double limit) const {
  return std::abs(value) > limit && std::abs(value) > by_chance * deviation;
}

CameraMisfit camera_misfit(const PatternCamera& camera, const GreyImage& picture,
                           const std::vector<FacePattern>& faces, const Pose& camera_from_body, int stride) {
  PatternCamera blurred = camera;
  blurred.variance *= wider;
  Normal normal = Normal::Zero();
  normal(focal_at, focal_at) = 1.0 / (focal_deviation * focal_deviation);
  Right right = Right::Zero();
  std::vector<PatternRow> rows, rows_blurred;
  for (const FacePattern& face : faces) {
    gather_rows(camera, picture, face, camera_from_body, stride, rows);
    if (rows.size() < least_rows) continue;
    gather_rows(blurred, picture, face, camera_from_body, stride, rows_blurred);
    add_face(face, camera_from_body * face.face->place, rows, rows_blurred, blurred.variance - camera.variance,
             normal, right);
  }
  const Eigen::LDLT<Normal> solved(normal);
  if (solved.info() != Eigen::Success || !solved.isPositive()) return {};
  const Right found = solved.solve(right);
  const Normal covariance = solved.solve(Normal::Identity());
  if (!found.allFinite() || !covariance.allFinite()) return {};
  const auto estimate = [&](int which) {
    return Estimate{found[which], std::sqrt(std::max(covariance(which, which), 0.0))};
  };
  return {estimate(tone_at), estimate(blur_at), estimate(focal_at)};
}

}  // namespace bodkin::tracking
