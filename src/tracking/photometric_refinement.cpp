#include "tracking/photometric_refinement.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace bodkin::tracking {

namespace {

constexpr int numbers = 12;  // six of the pose, four of the light, the residual, one unused
constexpr int unknown_light = 4;
constexpr int most_coarse_pixels = 5000;  // with every second pixel of every second row

}  // namespace

struct PhotometricRefinement::Sums {
  Matrix6 normal = Matrix6::Zero();
  Vector6 right = Vector6::Zero();
  double edge_squares = 0.0, edge_weights = 0.0;  // of residual over step, weighted by the pattern's slope
  double flat_squares = 0.0, flat_weights = 0.0;  // the same if the pattern has hardly any
  int pixels = 0;
  std::vector<PatternRow> rows;
};

PhotometricRefinement::PhotometricRefinement(const CameraModel& camera)
    : camera_(camera),
      rays_(ray_table(camera)),
      light_(camera.tone.light_of_bytes()),
      variance_(camera.blur * camera.blur + 1.0 / 12.0) {}

void PhotometricRefinement::set_light(const ToneCurve& tone, double blur) {
  camera_.tone = tone;
  camera_.blur = blur;
  light_ = tone.light_of_bytes();
  variance_ = blur * blur + 1.0 / 12.0;
}

bool PhotometricRefinement::gather(const GreyImage& picture, const FacePattern& face, const Pose& camera_from_body,
                                   int stride, Sums& sums) const {
  std::vector<PatternRow>& rows = sums.rows;
  gather_rows(pattern_camera(), picture, face, camera_from_body, stride, rows);
  if (rows.size() < least_rows) return false;
  const FaceLight fitted = fit_light(rows);
  const Eigen::Vector4d& light = fitted.light;
  const double scale = fitted.scale;
  const double step = light[0];
  if (!(step > 0.02)) return false;  // no contrast, or a negative image

  Eigen::Matrix<double, numbers, numbers> all = Eigen::Matrix<double, numbers, numbers>::Zero();
  float part[numbers][numbers] = {};
  const auto a0 = static_cast<float>(light[0]), a1 = static_cast<float>(light[1]), a2 = static_cast<float>(light[2]),
             a3 = static_cast<float>(light[3]);
  const auto huber = static_cast<float>(2.5 * scale), refused = static_cast<float>(8.0 * scale);
  const auto flush = [&] {
    for (int i = 0; i < numbers; ++i) {
      for (int j = 0; j < numbers; ++j) {
        all(i, j) += static_cast<double>(part[i][j]);
        part[i][j] = 0.0F;
      }
    }
  };
  // The pose depends on the edges, so their residual counts.
  double edge_squares = 0.0, edge_weights = 0.0, flat_squares = 0.0, flat_weights = 0.0;
  const auto flat_slope = static_cast<float>(0.02 * marker_cells / face.face->side);
  int since = 0;
  for (const PatternRow& row : rows) {
    const float gain = a0 + a1 * row.u + a2 * row.v;
    const float left_over = row.light - gain * row.model - a3, size = std::abs(left_over);
    const float slope = row.slope[0] * row.slope[0] + row.slope[1] * row.slope[1];
    if (slope > flat_slope * flat_slope) {
      edge_squares += static_cast<double>(slope * left_over * left_over);
      edge_weights += static_cast<double>(slope);
    } else {
      flat_squares += static_cast<double>(left_over * left_over);
      flat_weights += 1.0;
    }
    if (size > refused) continue;
    const float root = size < huber ? 1.0F : std::sqrt(huber / size);
    float x[numbers];
    for (int i = 0; i < 6; ++i) x[i] = root * gain * row.slope[i];
    x[6] = root * row.model;
    x[7] = root * row.model * row.u;
    x[8] = root * row.model * row.v;
    x[9] = root;
    x[10] = root * left_over;
    x[11] = 0.0F;
    for (int i = 0; i < 11; ++i) {
      const float left_factor = x[i];
      for (int j = 0; j < numbers; ++j) part[i][j] += left_factor * x[j];
    }
    if (++since == 256) {
      flush();
      since = 0;
    }
  }
  flush();
  const auto lights = all.block<unknown_light, unknown_light>(6, 6);
  const Eigen::Matrix<double, unknown_light, 6> across = all.block<unknown_light, 6>(6, 0);
  const Eigen::LDLT<Eigen::Matrix4d> solved(lights);
  const Eigen::Matrix<double, unknown_light, 6> removed = solved.solve(across);
  const Matrix6 normal = all.topLeftCorner<6, 6>() - across.transpose() * removed;
  const Vector6 right_side = all.block<6, 1>(0, 10) - removed.transpose() * all.block<unknown_light, 1>(6, 10);
  Matrix6 axes = Matrix6::Zero();
  axes.topLeftCorner<3, 3>() = axes.bottomRightCorner<3, 3>() = camera_from_body.linear() * face.face->place.linear();
  const double noise = std::max(edge_squares / std::max(edge_weights, 1e-9), 1e-7);
  sums.normal += axes * normal * axes.transpose() / noise;
  sums.right += axes * right_side / noise;
  sums.edge_squares += edge_squares / (step * step);
  sums.edge_weights += edge_weights;
  sums.flat_squares += flat_squares / (step * step);
  sums.flat_weights += flat_weights;
  sums.pixels += static_cast<int>(rows.size());
  return true;
}

RefinedPose PhotometricRefinement::refine(const GreyImage& picture, const MarkerBody& body, std::span<const int> ids,
                                          const Pose& start, int steps) const {
  RefinedPose refined;
  refined.camera_from_body = start;
  const std::vector<FacePattern> faces = patterns_of(body, ids);
  if (faces.empty() || !start.matrix().allFinite() || picture.width != camera_.width ||
      picture.height != camera_.height)
    return refined;

  Sums sums;
  Pose pose = start;
  int stride = 2;
  for (int step = 0; step <= steps; ++step) {
    sums.normal.setZero();
    sums.right.setZero();
    sums.edge_squares = sums.edge_weights = sums.flat_squares = sums.flat_weights = 0.0;
    sums.pixels = 0;
    int used = 0;
    for (const FacePattern& face : faces) {
      if (gather(picture, face, pose, stride, sums)) ++used;
    }
    if (used == 0) return refined;
    const Eigen::LDLT<Matrix6> solved(sums.normal);
    if (solved.info() != Eigen::Success || !solved.isPositive()) return refined;
    refined.camera_from_body = pose;
    refined.residual = std::sqrt(sums.edge_squares / std::max(sums.edge_weights, 1e-9));
    const double flat = std::sqrt(sums.flat_squares / std::max(sums.flat_weights, 1.0));
    refined.edge_ratio = sums.flat_weights > 50.0 ? refined.residual / std::max(flat, 2e-3) : 1.0;
    refined.pixels = sums.pixels;
    const Vector6 change = solved.solve(sums.right);
    if (!change.allFinite() || change.head<3>().norm() > 100.0 || change.tail<3>().norm() > 0.7) return refined;
    // Displacement of the markers in the image.
    const double far = std::max(pose.translation().norm(), 1.0);
    const double moved = camera_.fx * (change.head<3>().norm() / far + change.tail<3>().norm() * 0.05);
    const bool fine = stride == 1 || step > 0;
    if ((step == steps || moved < 0.02) && fine) {
      refined.covariance = solved.solve(Matrix6::Identity());
      refined.sound = moved < 1.0;
      if (moved >= 0.02) break;
    }
    if (step == steps) break;
    // A quarter of the pixels of a large board suffices.
    if (step == 0 && sums.pixels < most_coarse_pixels) stride = 1;
    take_step(pose, change);
    if (refined.sound) {
      refined.camera_from_body = pose;
      break;
    }
  }
  for (const FacePattern& face : faces) {
    const Pose place = refined.camera_from_body * face.face->place;
    if (place.linear().col(2).dot(place.translation()) <= 0.0) refined.sound = false;
  }
  return refined;
}

CameraMisfit PhotometricRefinement::misfit(const GreyImage& picture, const MarkerBody& body, std::span<const int> ids,
                                           const RefinedPose& pose) const {
  const int stride = pose.pixels > most_coarse_pixels ? 4 : 1;  // a part of a board suffices
  return camera_misfit(pattern_camera(), picture, patterns_of(body, ids), pose.camera_from_body, stride);
}

}  // namespace bodkin::tracking
