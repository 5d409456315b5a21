#include "tracking/photometric_refinement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace bodkin::tracking {

namespace {

constexpr int padded = marker_cells + 2;  // the margin of the sheet, one cell on every side
constexpr int numbers = 12;               // six of the pose, four of the light, the residual, one unused
constexpr int unknown_light = 4;
constexpr int most_coarse_pixels = 5000;  // with every second pixel of every second row

// The normal distribution and its density from -reach to reach.
constexpr float reach = 4.0F;
constexpr int table_steps = 512;
struct NormalTable {
  std::array<float, table_steps + 2> share{}, density{};
  NormalTable() {
    for (int i = 0; i < table_steps + 2; ++i) {
      const double x = -static_cast<double>(reach) + 2.0 * static_cast<double>(reach) * i / table_steps;
      share[static_cast<std::size_t>(i)] = static_cast<float>(0.5 * std::erfc(-x / std::sqrt(2.0)));
      density[static_cast<std::size_t>(i)] =
          static_cast<float>(std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi));
    }
  }
};
const NormalTable normal_table;

// How a blurred pixel spreads over the cells along one axis of a face.
struct Spread {
  int first = 0, count = 0;   // cells, of the padded pattern
  float weight[padded] = {};  // sums to 1
  float slope[padded] = {};   // derivative of the weights by the position, 1/cell
};

// `at`: cells from the edge of the black square; `sigma`: cells.
bool find_spread(float at, float sigma, Spread& spread) {
  const float reached = reach * sigma;
  const int low = std::max(0, static_cast<int>(std::ceil(at - reached)));
  const int high = std::min(marker_cells, static_cast<int>(std::floor(at + reached)));
  spread.first = std::clamp(low, 0, padded - 1);  // the cell left of line `low` is number `low` of the padded pattern
  const float inverse = 1.0F / sigma;
  float left_share = 1.0F, left_density = 0.0F;
  int n = 0;
  for (int line = low; line <= high; ++line, ++n) {
    const float where = ((at - static_cast<float>(line)) * inverse + reach) * (table_steps / (2.0F * reach));
    const float bounded = std::clamp(where, 0.0F, static_cast<float>(table_steps));
    const int index = static_cast<int>(bounded);
    const float part = bounded - static_cast<float>(index);
    const auto i = static_cast<std::size_t>(index);
    const float share = normal_table.share[i] + part * (normal_table.share[i + 1] - normal_table.share[i]);
    const float density = normal_table.density[i] + part * (normal_table.density[i + 1] - normal_table.density[i]);
    spread.weight[n] = left_share - share;
    spread.slope[n] = (left_density - density) * inverse;
    left_share = share;
    left_density = density;
  }
  spread.weight[n] = left_share;
  spread.slope[n] = left_density * inverse;
  spread.count = n + 1;
  return spread.first + spread.count <= padded;
}

}  // namespace

struct PhotometricRefinement::Face {
  const MarkerFace* face = nullptr;
  Vec3 body_origin = Vec3::Zero();  // in the face's frame
  float pattern[padded][padded] = {};
};

struct PhotometricRefinement::Row {
  float light = 0.0F, model = 0.0F, u = 0.0F, v = 0.0F;  // u, v: from -1 to 1 over the black square
  float slope[6] = {};                                   // of the model by the pose, in the face's axes
};

struct PhotometricRefinement::Sums {
  Matrix6 normal = Matrix6::Zero();
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
  double edge_squares = 0.0, edge_weights = 0.0;  // of residual over step, weighed by the pattern's slope
  double flat_squares = 0.0, flat_weights = 0.0;  // the same where the pattern has hardly any
  int pixels = 0;
  std::vector<Row> rows;
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

bool PhotometricRefinement::gather(const GreyPicture& picture, const Face& face, const Pose& camera_from_body,
                                   int stride, Sums& sums) const {
  const MarkerFace& sheet = *face.face;
  const Pose place = camera_from_body * sheet.place;
  const Mat3 to_face = place.linear().transpose();
  const Vec3 eye = -(to_face * place.translation());
  const double cell = sheet.side / marker_cells;
  const double widest = std::min(0.5 * sheet.sheet, 0.5 * sheet.side + cell);
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (int corner = 0; corner < 4; ++corner) {
    const Vec3 at = place * Vec3((corner & 1) != 0 ? widest : -widest, (corner & 2) != 0 ? widest : -widest, 0.0);
    if (at.z() < 1.0) return false;
    const Eigen::Vector2d pixel = camera_.project(at);
    low = low.cwiseMin(pixel);
    high = high.cwiseMax(pixel);
  }
  const int left = std::max(1, static_cast<int>(std::floor(low.x())));
  const int right = std::min(camera_.width - 2, static_cast<int>(std::ceil(high.x())));
  const int top = std::max(1, static_cast<int>(std::floor(low.y())));
  const int bottom = std::min(camera_.height - 2, static_cast<int>(std::ceil(high.y())));

  std::vector<Row>& rows = sums.rows;
  rows.clear();
  Eigen::Matrix<double, 5, 5> light_sums = Eigen::Matrix<double, 5, 5>::Zero();
  const auto width = static_cast<std::size_t>(camera_.width);
  const double blur = std::sqrt(variance_);
  Spread along_u, along_v;
  for (int y = top; y <= bottom; y += stride) {
    const std::size_t row_start = static_cast<std::size_t>(y) * width;
    for (int x = left + (stride > 1 ? (y / stride) % stride : 0); x <= right; x += stride) {
      const std::size_t at = row_start + static_cast<std::size_t>(x);
      const Eigen::Vector2f& ray = rays_[at];
      const double rx = static_cast<double>(ray.x()), ry = static_cast<double>(ray.y());
      const Vec3 e = to_face.col(0) * rx + to_face.col(1) * ry + to_face.col(2);
      if (e.z() <= 0.02) continue;
      const double inverse = 1.0 / e.z(), far = -eye.z() * inverse;
      const double u = eye.x() + far * e.x(), v = eye.y() + far * e.y();
      if (std::abs(u) > widest || std::abs(v) > widest) continue;
      const double eu = e.x() * inverse, ev = e.y() * inverse;
      // How the point on the face moves with the pixel.
      const double dxx = static_cast<double>(rays_[at + 1].x() - rays_[at - 1].x()) * 0.5;
      const double dxy = static_cast<double>(rays_[at + 1].y() - rays_[at - 1].y()) * 0.5;
      const double dyx = static_cast<double>(rays_[at + width].x() - rays_[at - width].x()) * 0.5;
      const double dyy = static_cast<double>(rays_[at + width].y() - rays_[at - width].y()) * 0.5;
      const Vec3 ex = to_face.col(0) * dxx + to_face.col(1) * dxy, ey = to_face.col(0) * dyx + to_face.col(1) * dyy;
      const double ux = far * (ex.x() - eu * ex.z()), uy = far * (ey.x() - eu * ey.z());
      const double vx = far * (ex.y() - ev * ex.z()), vy = far * (ey.y() - ev * ey.z());
      const double su = blur * std::sqrt(ux * ux + uy * uy), sv = blur * std::sqrt(vx * vx + vy * vy);
      // What lies beyond the sheet must not reach in.
      if (std::abs(u) + 2.0 * su > 0.5 * sheet.sheet || std::abs(v) + 2.0 * sv > 0.5 * sheet.sheet) continue;
      const double middle = 0.5 * marker_cells;
      if (!find_spread(static_cast<float>(u / cell + middle), static_cast<float>(su / cell), along_u) ||
          !find_spread(static_cast<float>(v / cell + middle), static_cast<float>(sv / cell), along_v)) {
        continue;
      }
      float model = 0.0F, by_u = 0.0F, by_v = 0.0F, mixed = 0.0F;
      for (int j = 0; j < along_v.count; ++j) {
        const float* const cells = face.pattern[along_v.first + j] + along_u.first;
        float sum = 0.0F, slope = 0.0F;
        for (int i = 0; i < along_u.count; ++i) {
          sum += along_u.weight[i] * cells[i];
          slope += along_u.slope[i] * cells[i];
        }
        model += along_v.weight[j] * sum;
        by_u += along_v.weight[j] * slope;
        by_v += along_v.slope[j] * sum;
        mixed += along_v.slope[j] * slope;
      }
      // The axes of the blur's ellipse are not those of the face: first order of the tetrachoric series.
      model += mixed * static_cast<float>(variance_ * (ux * vx + uy * vy) / (cell * cell));
      const double fu = static_cast<double>(by_u) / cell, fv = static_cast<double>(by_v) / cell;
      const Vec3 h(-fu, -fv, fu * eu + fv * ev);
      const Vec3 turn = (Vec3(u, v, 0.0) - face.body_origin).cross(h);
      Row row;
      row.light = light_[picture.pixels[at]];
      row.model = model;
      row.u = static_cast<float>(2.0 * u / sheet.side);
      row.v = static_cast<float>(2.0 * v / sheet.side);
      for (int i = 0; i < 3; ++i) {
        row.slope[i] = static_cast<float>(h[i]);
        row.slope[i + 3] = static_cast<float>(turn[i]);
      }
      rows.push_back(row);
    }
  }
  if (rows.size() < 60) return false;

  // The light of this face: a gain that is linear over it and an offset; twice, the second time with weights.
  Eigen::Vector4d light = Eigen::Vector4d::Zero();
  double scale = 1e9;
  for (int turn = 0; turn < 2; ++turn) {
    light_sums.setZero();
    for (const Row& row : rows) {
      const double f = static_cast<double>(row.model), u = static_cast<double>(row.u), v = static_cast<double>(row.v);
      const Eigen::Vector4d basis(f, f * u, f * v, 1.0);
      const double left_over = static_cast<double>(row.light) - light.dot(basis);
      const double weight = std::abs(left_over) < 2.5 * scale   ? 1.0
                            : std::abs(left_over) > 8.0 * scale ? 0.0
                                                                : 2.5 * scale / std::abs(left_over);
      light_sums.topLeftCorner<4, 4>() += weight * basis * basis.transpose();
      light_sums.col(4).head<4>() += weight * static_cast<double>(row.light) * basis;
    }
    light = light_sums.topLeftCorner<4, 4>().ldlt().solve(light_sums.col(4).head<4>());
    double sum = 0.0;
    for (const Row& row : rows) {
      const double f = static_cast<double>(row.model);
      sum += std::abs(static_cast<double>(row.light) - light[3] -
                      f * (light[0] + light[1] * static_cast<double>(row.u) + light[2] * static_cast<double>(row.v)));
    }
    scale = std::max(1.25 * sum / static_cast<double>(rows.size()), 1e-4);
  }
  const double step = light[0];
  if (!(step > 0.02)) return false;  // no contrast, or a negative

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
  // What the pose is read from is the edges, so it is their residual that counts.
  double edge_squares = 0.0, edge_weights = 0.0, flat_squares = 0.0, flat_weights = 0.0;
  const auto flat_slope = static_cast<float>(0.02 / cell);
  int since = 0;
  for (const Row& row : rows) {
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
  const Eigen::Matrix<double, 6, 1> right_side =
      all.block<6, 1>(0, 10) - removed.transpose() * all.block<unknown_light, 1>(6, 10);
  Matrix6 axes = Matrix6::Zero();
  axes.topLeftCorner<3, 3>() = axes.bottomRightCorner<3, 3>() = place.linear();
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

RefinedPose PhotometricRefinement::refine(const GreyPicture& picture, const MarkerBody& body,
                                          std::span<const int> ids, const Pose& start, int steps) const {
  RefinedPose refined;
  refined.camera_from_body = start;
  std::vector<Face> faces;
  for (const int id : ids) {
    const MarkerFace* const found = body.face_of(id);
    if (found == nullptr) continue;
    Face face;
    face.face = found;
    face.body_origin = found->place.inverse().translation();
    const auto pattern = marker_pattern(id);
    for (int row = 0; row < padded; ++row) {
      for (int column = 0; column < padded; ++column) {
        const bool inside = row > 0 && column > 0 && row <= marker_cells && column <= marker_cells;
        face.pattern[row][column] =
            !inside || pattern[static_cast<std::size_t>(row) - 1][static_cast<std::size_t>(column) - 1] ? 1.0F : 0.0F;
      }
    }
    faces.push_back(face);
  }
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
    for (const Face& face : faces) {
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
    const Eigen::Matrix<double, 6, 1> change = solved.solve(sums.right);
    if (!change.allFinite() || change.head<3>().norm() > 100.0 || change.tail<3>().norm() > 0.7) return refined;
    // How far the markers would move in the picture.
    const double far = std::max(pose.translation().norm(), 1.0);
    const double moved = camera_.fx * (change.head<3>().norm() / far + change.tail<3>().norm() * 0.05);
    const bool fine = stride == 1 || step > 0;
    if ((step == steps || moved < 0.02) && fine) {
      refined.covariance = solved.solve(Matrix6::Identity());
      refined.sound = moved < 1.0;
      if (moved >= 0.02) break;
    }
    if (step == steps) break;
    // A quarter of the pixels of a large board is enough.
    if (step == 0 && sums.pixels < most_coarse_pixels) stride = 1;
    pose.translation() += change.head<3>();
    const Vec3 turn = change.tail<3>();
    if (turn.norm() > 0.0) {
      pose.linear() = (Eigen::AngleAxisd(turn.norm(), turn.normalized()) * pose.linear()).eval();
    }
    if (refined.sound) {
      refined.camera_from_body = pose;
      break;
    }
  }
  for (const Face& face : faces) {
    const Pose place = refined.camera_from_body * face.face->place;
    if (place.linear().col(2).dot(place.translation()) <= 0.0) refined.sound = false;
  }
  return refined;
}

}  // namespace bodkin::tracking
