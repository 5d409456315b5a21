#include "fem/solid/bound_points.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <Eigen/Geometry>

#include "core/error.h"
#include "fem/solid/dense_kernels.h"

namespace bodkin::fem {

namespace {

constexpr double least_motion = 1e-8;  // of a motion's size that must remain beside the others

// A chain in the order of the rows.
double product_of(const double* a, const double* b, std::size_t rows) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < rows; ++i) sum += a[i] * b[i];
  return sum;
}

double* column_of(Eigen::MatrixXd& matrix, std::size_t column) {
  return matrix.data() + column * static_cast<std::size_t>(matrix.rows());
}

const double* column_of(const Eigen::MatrixXd& matrix, std::size_t column) {
  return matrix.data() + column * static_cast<std::size_t>(matrix.rows());
}

void subtract(double* from, const double* what, double factor, std::size_t rows) noexcept {
  for (std::size_t i = 0; i < rows; ++i) from[i] -= factor * what[i];
}

}  // namespace

BoundPoints::BoundPoints(std::vector<Group> groups) {
  std::vector<Mat3> gains;
  std::vector<std::pair<std::size_t, std::size_t>> free;  // first and last point of each needle
  std::vector<std::size_t> held;
  for (Group& group : groups) {
    const std::size_t first = places_.size();
    std::move(group.responses.begin(), group.responses.end(), std::back_inserter(responses_));
    places_.insert(places_.end(), group.places.begin(), group.places.end());
    gains.insert(gains.end(), group.gains.begin(), group.gains.end());
    if (group.is_free && places_.size() > first) free.emplace_back(first, places_.size());
    for (std::size_t point = first; !group.is_free && point < places_.size(); ++point) held.push_back(point);
  }
  const std::size_t rows = 3 * places_.size();
  const auto size = static_cast<Eigen::Index>(rows);
  lower_ = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t b = 0; b < places_.size(); ++b) {
    const auto column = static_cast<Eigen::Index>(3 * b);
    for (std::size_t a = b; a < places_.size(); ++a)
      lower_.block<3, 3>(static_cast<Eigen::Index>(3 * a), column) = compliance_between(responses_[a], responses_[b]);
    lower_.block<3, 3>(column, column) += gains[b];
  }
  if (cholesky(dense_tiles().front(), rows, lower_.data(), rows) < rows)
    throw InputError("a node of the body is held twice; name each node once");

  // For each needle three motions along the axes and three about its first point, as far as they differ: rotation
  // about its own axis moves none of its points.
  motions_ = Eigen::MatrixXd::Zero(size, static_cast<Eigen::Index>(6 * free.size()));
  std::size_t found = 0;
  for (const auto& [first, last] : free) {
    for (Eigen::Index axis = 0; axis < 6; ++axis) {
      double* const motion = column_of(motions_, found);
      std::fill_n(motion, rows, 0.0);
      for (std::size_t point = first; point < last; ++point) {
        const Vec3 moved =
            axis < 3 ? Vec3(Vec3::Unit(axis)) : Vec3(Vec3::Unit(axis - 3).cross(places_[point] - places_[first]));
        Eigen::Map<Vec3>(motion + 3 * point) = moved;
      }
      invert_lower_times(dense_tiles().front(), rows, 1, lower_.data(), rows, motion, rows);
      const double before = std::sqrt(product_of(motion, motion, rows));
      for (int twice = 0; twice < 2; ++twice)
        for (std::size_t k = 0; k < found; ++k)
          subtract(motion, column_of(motions_, k), product_of(column_of(motions_, k), motion, rows), rows);
      const double left = std::sqrt(product_of(motion, motion, rows));
      if (!(left > least_motion * before)) continue;
      for (std::size_t i = 0; i < rows; ++i) motion[i] /= left;
      ++found;
    }
  }
  motions_.conservativeResize(Eigen::NoChange, static_cast<Eigen::Index>(found));
  add_holder(held);
}

// The points of `held`, moved as one along the axes and about their middle.
void BoundPoints::add_holder(const std::vector<std::size_t>& held) {
  if (held.empty()) return;
  Vec3 middle = Vec3::Zero();
  for (const std::size_t point : held) middle += places_[point] / static_cast<double>(held.size());
  const std::size_t rows = 3 * places_.size();
  holder_ = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows), 6);
  for (const std::size_t point : held) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const Vec3 turned = Vec3::Unit(axis).cross(places_[point] - middle);
      holder_.col(axis).segment<3>(static_cast<Eigen::Index>(3 * point)) = Vec3::Unit(axis);
      holder_.col(axis + 3).segment<3>(static_cast<Eigen::Index>(3 * point)) = turned;
    }
  }
  invert_lower_times(dense_tiles().front(), rows, 6, lower_.data(), rows, holder_.data(), rows);
}

void BoundPoints::take_out_motions(double* columns, std::size_t count) const noexcept {
  const std::size_t rows = 3 * places_.size();
  for (std::size_t column = 0; column < count; ++column)
    for (std::size_t k = 0; k < static_cast<std::size_t>(motions_.cols()); ++k) {
      const double* const motion = column_of(motions_, k);
      subtract(columns + column * rows, motion, product_of(motion, columns + column * rows, rows), rows);
    }
}

Eigen::MatrixXd BoundPoints::shares(std::span<const PointResponse> others) const {
  const std::size_t rows = 3 * places_.size();
  Eigen::MatrixXd found(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(3 * others.size()));
  for (std::size_t other = 0; other < others.size(); ++other)
    for (std::size_t point = 0; point < places_.size(); ++point)
      found.block<3, 3>(static_cast<Eigen::Index>(3 * point), static_cast<Eigen::Index>(3 * other)) =
          compliance_between(responses_[point], others[other]);
  if (rows == 0) return found;
  invert_lower_times(dense_tiles().front(), rows, 3 * others.size(), lower_.data(), rows, found.data(), rows);
  take_out_motions(found.data(), 3 * others.size());
  return found;
}

Mat3 BoundPoints::taken(const Eigen::MatrixXd& shares, std::size_t a, const Eigen::MatrixXd& shares_b,
                        std::size_t b) const {
  Mat3 sum;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      sum(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
          product_of(column_of(shares, 3 * a + row), column_of(shares_b, 3 * b + column), 3 * places_.size());
  return sum;
}

Eigen::MatrixXd BoundPoints::forces_against(Eigen::MatrixXd moved) const {
  const std::size_t rows = 3 * places_.size();
  if (rows == 0) return moved;
  const auto columns = static_cast<std::size_t>(moved.cols());
  invert_lower_times(dense_tiles().front(), rows, columns, lower_.data(), rows, moved.data(), rows);
  take_out_motions(moved.data(), columns);
  lower_.triangularView<Eigen::Lower>().transpose().solveInPlace(moved);
  return -moved;
}

HeldFraction BoundPoints::on_held(const Eigen::MatrixXd& shares, std::size_t point) const {
  HeldFraction share;
  if (holder_.cols() == 0) return share;
  const std::size_t rows = 3 * places_.size();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t column = 0; column < 3; ++column) {
      const auto row = static_cast<Eigen::Index>(axis), at = static_cast<Eigen::Index>(column);
      const double* const moved = column_of(shares, 3 * point + column);
      share.force(row, at) = product_of(column_of(holder_, axis), moved, rows);
      share.torque(row, at) = product_of(column_of(holder_, axis + 3), moved, rows);
    }
  }
  return share;
}

Eigen::VectorXd BoundPoints::forces(const Eigen::MatrixXd& shares, const Eigen::VectorXd& on_points) const {
  Eigen::VectorXd found = -(shares * on_points);
  lower_.triangularView<Eigen::Lower>().transpose().solveInPlace(found);
  return found;
}

}  // namespace bodkin::fem
