#include "tracking/pattern_rows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <Eigen/Cholesky>

namespace bodkin::tracking {

namespace {

constexpr int padded = FacePattern::padded;

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

// Spread of a blurred pixel over the cells along one axis of a face.
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

std::vector<FacePattern> patterns_of(const MarkerBody& body, std::span<const int> ids) {
  std::vector<FacePattern> patterns;
  for (const int id : ids) {
    const MarkerFace* const found = body.face_of(id);
    if (found == nullptr) continue;
    FacePattern made;
    made.face = found;
    made.body_origin = found->place.inverse().translation();
    const auto pattern = marker_pattern(id);
    for (int row = 0; row < padded; ++row) {
      for (int column = 0; column < padded; ++column) {
        const bool inside = row > 0 && column > 0 && row <= marker_cells && column <= marker_cells;
        made.cells[row][column] =
            !inside || pattern[static_cast<std::size_t>(row) - 1][static_cast<std::size_t>(column) - 1] ? 1.0F : 0.0F;
      }
    }
    patterns.push_back(made);
  }
  return patterns;
}

void gather_rows(const PatternCamera& camera, const GreyImage& picture, const FacePattern& face,
                 const Pose& camera_from_body, int stride, std::vector<PatternRow>& rows) {
  rows.clear();
  const CameraModel& lens = camera.camera;
  const MarkerFace& sheet = *face.face;
  const Pose place = camera_from_body * sheet.place;
  const Mat3 to_face = place.linear().transpose();
  const Vec3 eye = -(to_face * place.translation());
  const double cell = sheet.side / marker_cells;
  const double widest = std::min(0.5 * sheet.sheet, 0.5 * sheet.side + cell);
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (int corner = 0; corner < 4; ++corner) {
    const Vec3 at = place * Vec3((corner & 1) != 0 ? widest : -widest, (corner & 2) != 0 ? widest : -widest, 0.0);
    if (at.z() < 1.0) return;
    const Eigen::Vector2d pixel = lens.project(at);
    low = low.cwiseMin(pixel);
    high = high.cwiseMax(pixel);
  }
  const int left = std::max(1, static_cast<int>(std::floor(low.x())));
  const int right = std::min(lens.width - 2, static_cast<int>(std::ceil(high.x())));
  const int top = std::max(1, static_cast<int>(std::floor(low.y())));
  const int bottom = std::min(lens.height - 2, static_cast<int>(std::ceil(high.y())));

  const auto width = static_cast<std::size_t>(lens.width);
  const double blur = std::sqrt(camera.variance);
  Spread along_u, along_v;
  for (int y = top; y <= bottom; y += stride) {
    const std::size_t row_start = static_cast<std::size_t>(y) * width;
    for (int x = left + (stride > 1 ? (y / stride) % stride : 0); x <= right; x += stride) {
      const std::size_t at = row_start + static_cast<std::size_t>(x);
      const Eigen::Vector2f& ray = camera.rays[at];
      const double rx = static_cast<double>(ray.x()), ry = static_cast<double>(ray.y());
      const Vec3 e = to_face.col(0) * rx + to_face.col(1) * ry + to_face.col(2);
      if (e.z() <= 0.02) continue;
      const double inverse = 1.0 / e.z(), far = -eye.z() * inverse;
      const double u = eye.x() + far * e.x(), v = eye.y() + far * e.y();
      if (std::abs(u) > widest || std::abs(v) > widest) continue;
      const double eu = e.x() * inverse, ev = e.y() * inverse;
      // Motion of the point on the face with the pixel.
      const double dxx = static_cast<double>(camera.rays[at + 1].x() - camera.rays[at - 1].x()) * 0.5;
      const double dxy = static_cast<double>(camera.rays[at + 1].y() - camera.rays[at - 1].y()) * 0.5;
      const double dyx = static_cast<double>(camera.rays[at + width].x() - camera.rays[at - width].x()) * 0.5;
      const double dyy = static_cast<double>(camera.rays[at + width].y() - camera.rays[at - width].y()) * 0.5;
      const Vec3 ex = to_face.col(0) * dxx + to_face.col(1) * dxy, ey = to_face.col(0) * dyx + to_face.col(1) * dyy;
      const double ux = far * (ex.x() - eu * ex.z()), uy = far * (ey.x() - eu * ey.z());
      const double vx = far * (ex.y() - ev * ex.z()), vy = far * (ey.y() - ev * ey.z());
      const double su = blur * std::sqrt(ux * ux + uy * uy), sv = blur * std::sqrt(vx * vx + vy * vy);
      // Light from beyond the sheet must not contribute.
      if (std::abs(u) + 2.0 * su > 0.5 * sheet.sheet || std::abs(v) + 2.0 * sv > 0.5 * sheet.sheet) continue;
      const double middle = 0.5 * marker_cells;
      if (!find_spread(static_cast<float>(u / cell + middle), static_cast<float>(su / cell), along_u) ||
          !find_spread(static_cast<float>(v / cell + middle), static_cast<float>(sv / cell), along_v)) {
        continue;
      }
      float model = 0.0F, by_u = 0.0F, by_v = 0.0F, mixed = 0.0F;
      for (int j = 0; j < along_v.count; ++j) {
        const float* const cells = face.cells[along_v.first + j] + along_u.first;
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
      model += mixed * static_cast<float>(camera.variance * (ux * vx + uy * vy) / (cell * cell));
      const double fu = static_cast<double>(by_u) / cell, fv = static_cast<double>(by_v) / cell;
      const Vec3 h(-fu, -fv, fu * eu + fv * ev);
      const Vec3 turn = (Vec3(u, v, 0.0) - face.body_origin).cross(h);
      PatternRow row;
      row.light = camera.light[picture.pixels[at]];
      row.model = model;
      row.u = static_cast<float>(2.0 * u / sheet.side);
      row.v = static_cast<float>(2.0 * v / sheet.side);
      for (int i = 0; i < 3; ++i) {
        row.slope[i] = static_cast<float>(h[i]);
        row.slope[i + 3] = static_cast<float>(turn[i]);
      }
      row.pixel = static_cast<std::uint32_t>(at);
      rows.push_back(row);
    }
  }
}

// In two passes, the second with weights.
FaceLight fit_light(const std::vector<PatternRow>& rows) {
  FaceLight fitted;
  Eigen::Vector4d& light = fitted.light;
  Eigen::Matrix<double, 4, 5> light_sums;
  double scale = 1e9;
  for (int turn = 0; turn < 2; ++turn) {
    light_sums.setZero();
    for (const PatternRow& row : rows) {
      const double f = static_cast<double>(row.model), u = static_cast<double>(row.u), v = static_cast<double>(row.v);
      const Eigen::Vector4d basis(f, f * u, f * v, 1.0);
      const double left_over = static_cast<double>(row.light) - light.dot(basis);
      const double weight = std::abs(left_over) < 2.5 * scale   ? 1.0
                            : std::abs(left_over) > 8.0 * scale ? 0.0
                                                                : 2.5 * scale / std::abs(left_over);
      light_sums.leftCols<4>() += weight * basis * basis.transpose();
      light_sums.col(4) += weight * static_cast<double>(row.light) * basis;
    }
    light = light_sums.leftCols<4>().ldlt().solve(light_sums.col(4));
    double sum = 0.0;
    for (const PatternRow& row : rows) {
      const double f = static_cast<double>(row.model);
      sum += std::abs(static_cast<double>(row.light) - light[3] -
                      f * (light[0] + light[1] * static_cast<double>(row.u) + light[2] * static_cast<double>(row.v)));
    }
    scale = std::max(1.25 * sum / static_cast<double>(rows.size()), 1e-4);
  }
  fitted.scale = scale;
  return fitted;
}

}  // namespace bodkin::tracking
