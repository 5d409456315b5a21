#include "fem/contact_factor.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "core/error.h"
#include "fem/upper_triangular.h"

namespace bodkin::fem {

namespace {

constexpr std::size_t block = 8;        // rows of U processed together
constexpr std::size_t prefetched = 24;  // rows ahead
constexpr double least_pivot =
    1e-10;  // of the diagonal of S; a smaller pivot means that a constraint depends on the others

}  // namespace

ContactFactor::ContactFactor(const Eigen::MatrixXd& compliance, std::size_t most_nodes,
                             const std::optional<NeedleBeam>& beam)
    : compliance_(&compliance),
      beam_(beam),
      most_rows_(3 * most_nodes),
      stride_(upper_triangular::padded(3 * most_nodes)) {
  if (compliance.rows() != compliance.cols() || compliance.rows() % 3 != 0 || compliance.rows() == 0) {
    throw InputError("contact: the compliance of the body is " + std::to_string(compliance.rows()) + " x " +
                     std::to_string(compliance.cols()) + ", expected 3 rows and columns for each of its nodes");
  }
  if (most_nodes == 0) throw InputError("contact: room for 0 nodes, expected at least 1");
  constexpr std::size_t line = 64;
  storage_.assign(upper_triangular::padded(most_rows_) * stride_ + line / sizeof(double), 0.0);
  void* begin = storage_.data();
  std::size_t room = storage_.size() * sizeof(double);
  std::align(line, upper_triangular::padded(most_rows_) * stride_ * sizeof(double), begin, room);
  factor_ = {static_cast<double*>(begin), upper_triangular::padded(most_rows_) * stride_};
  scratch_.assign(3 * stride_, 0.0);
  row_of_.resize(most_rows_);
  first_rows_.assign(most_rows_ + 1, 0);
}

void ContactFactor::solve(std::span<double> values) noexcept {
  double* d = scratch_.data();
  std::copy_n(values.data(), rows_, d);
  forward(d, 1);
  backward(d);
  std::copy_n(d, rows_, values.data());
}

void ContactFactor::forward(double* columns, std::size_t count) noexcept {
  upper_triangular::solve_transposed({factor_.data(), stride_, rows_}, columns, count);
}

void ContactFactor::backward(double* values) noexcept {
  upper_triangular::solve({factor_.data(), stride_, rows_}, values);
}

// The Schur complement of S + F for the last constraint; `scratch_` contains its columns of U.
void ContactFactor::find_corner(std::size_t first, std::size_t count) noexcept {
  corner_.setZero();
  const auto node = static_cast<Eigen::Index>(3) * static_cast<Eigen::Index>(row_of_[first].node);
  const double depth = row_of_[first].depth;
  const double bent = beam_ && depth >= 0.0 ? beam_->flexibility(depth, depth) : 0.0;
  for (std::size_t a = 0; a < count; ++a) {
    const Vec3 moved = compliance_->block<3, 3>(node, node) * row_of_[first + a].direction;
    const double* left = scratch_.data() + a * stride_;
    for (std::size_t b = 0; b <= a; ++b) {
      const double* right = scratch_.data() + b * stride_;
      const double sum = upper_triangular::product(left, right, first);
      const double here = row_of_[first + b].direction.dot(moved);
      corner_(static_cast<int>(b), static_cast<int>(a)) = here + (a == b ? bent : 0.0) - sum;
      if (a == b) own_(static_cast<int>(a)) = here;
    }
  }
  corner_known_ = true;
}

// Factorises the corner of U that belongs to the last constraint.
bool ContactFactor::finish(std::size_t first, std::size_t count, double compliance) noexcept {
  Mat3 upper = Mat3::Zero();
  for (int a = 0; a < static_cast<int>(count); ++a) {
    for (int b = 0; b < a; ++b) {
      double value = corner_(b, a);
      for (int i = 0; i < b; ++i) value -= upper(i, a) * upper(i, b);
      upper(b, a) = value / upper(b, b);
    }
    double pivot = corner_(a, a) + compliance;
    for (int i = 0; i < a; ++i) pivot -= upper(i, a) * upper(i, a);
    if (!(pivot > least_pivot * own_(a)) || !std::isfinite(pivot)) return false;
    upper(a, a) = std::sqrt(pivot);
  }
  for (std::size_t b = 0; b < count; ++b) {
    for (std::size_t a = b; a < count; ++a) {
      row(first + b)[first + a] = upper(static_cast<int>(b), static_cast<int>(a));
    }
  }
  return true;
}

bool ContactFactor::fits(std::uint32_t node, std::size_t count, double compliance) const noexcept {
  const auto place = static_cast<Eigen::Index>(3) * static_cast<Eigen::Index>(node);
  return count > 0 && rows_ + count <= most_rows_ && place + 3 <= compliance_->rows() && compliance >= 0.0;
}

bool ContactFactor::append(std::uint32_t node, const ConstraintDirections& directions, double compliance,
                           double depth) noexcept {
  const auto count = static_cast<std::size_t>(directions.cols());
  const auto place = static_cast<Eigen::Index>(3) * static_cast<Eigen::Index>(node);
  if (!fits(node, count, compliance)) return false;
  if (!beam_ && compliance == 0.0) {  // a fourth direction of a node depends on the first three
    const auto same = [node](const Row& row) { return row.rigid && row.node == node; };
    const auto end = row_of_.begin() + static_cast<std::ptrdiff_t>(rows_);
    if (static_cast<std::size_t>(std::count_if(row_of_.begin(), end, same)) + count > 3) return false;
  }
  const bool bends = beam_ && depth >= 0.0;
  double* columns = scratch_.data();
  for (std::size_t i = 0; i < rows_; ++i) {
    if (i + prefetched < rows_) {  // the compliance is scattered over much memory
      const auto later = static_cast<Eigen::Index>(3) * static_cast<Eigen::Index>(row_of_[i + prefetched].node);
      for (Eigen::Index a = 0; a < 3; ++a) __builtin_prefetch(&(*compliance_)(later, place + a));
    }
    const auto at = static_cast<Eigen::Index>(3) * static_cast<Eigen::Index>(row_of_[i].node);
    Vec3 moved = compliance_->block<3, 3>(at, place).transpose() * row_of_[i].direction;
    if (bends && row_of_[i].depth >= 0.0) moved += beam_->flexibility(row_of_[i].depth, depth) * row_of_[i].direction;
    for (std::size_t a = 0; a < count; ++a) {
      columns[a * stride_ + i] = moved.dot(directions.col(static_cast<Eigen::Index>(a)));
    }
  }
  upper_triangular::solve_transposed({factor_.data(), stride_, rows_}, columns, count);
  return add_columns(node, directions, compliance, depth);
}

bool ContactFactor::append_solved(std::uint32_t node, const ConstraintDirections& directions, const double* columns,
                                  double compliance, double depth) noexcept {
  const auto count = static_cast<std::size_t>(directions.cols());
  if (!fits(node, count, compliance)) return false;
  for (std::size_t a = 0; a < count; ++a) std::copy_n(columns + a * stride_, rows_, scratch_.data() + a * stride_);
  return add_columns(node, directions, compliance, depth);
}

// Appends to U the columns in `scratch_` and the corner below them.
bool ContactFactor::add_columns(std::uint32_t node, const ConstraintDirections& directions, double compliance,
                                double depth) noexcept {
  const auto count = static_cast<std::size_t>(directions.cols());
  const double* const columns = scratch_.data();
  for (std::size_t i = 0; i < rows_; ++i) {
    for (std::size_t a = 0; a < count; ++a) row(i)[rows_ + a] = columns[a * stride_ + i];
  }
  for (std::size_t a = 0; a < count; ++a) {
    row_of_[rows_ + a] = {node, directions.col(static_cast<Eigen::Index>(a)), depth, compliance == 0.0};
  }
  find_corner(rows_, count);
  if (!finish(rows_, count, compliance)) {
    corner_known_ = false;
    for (std::size_t i = 0; i < rows_; ++i) std::fill_n(row(i) + rows_, count, 0.0);
    return false;
  }
  rows_ += count;
  first_rows_[++constraints_] = rows_;
  return true;
}

void ContactFactor::clear() noexcept {
  constraints_ = rows_ = 0;
  corner_known_ = false;
}

void ContactFactor::remove_last() noexcept {
  if (constraints_ > 0) rows_ = first_rows_[--constraints_];
  corner_known_ = false;
}

bool ContactFactor::set_last_compliance(double compliance) noexcept {
  if (constraints_ == 0 || !(compliance >= 0.0)) return false;
  const std::size_t first = first_rows_[constraints_ - 1];
  if (!corner_known_) {
    for (std::size_t i = 0; i < first; ++i) {
      for (std::size_t a = 0; a < rows_ - first; ++a) scratch_[a * stride_ + i] = row(i)[first + a];
    }
    find_corner(first, rows_ - first);
  }
  if (!finish(first, rows_ - first, compliance)) return false;
  for (std::size_t i = first; i < rows_; ++i) row_of_[i].rigid = compliance == 0.0;
  return true;
}

// Without the columns of the constraint U has too many rows. The rest of the constraint's rows, x, is rotated into
// the triangle T below it so that T'^T T' = T^T T + x^T x, by a Givens rotation for each row of x and of T. T' then
// takes the place of the removed rows.
void ContactFactor::remove(std::size_t constraint) noexcept {
  if (constraint >= constraints_) return;
  corner_known_ = false;
  const std::size_t first = first_rows_[constraint];
  const std::size_t count = first_rows_[constraint + 1] - first;
  const std::size_t after = first + count;
  for (std::size_t i = 0; i < first; ++i) std::copy(row(i) + after, row(i) + rows_, row(i) + first);
  double* x = scratch_.data();
  for (std::size_t a = 0; a < count; ++a) {
    std::copy(row(first + a) + after, row(first + a) + rows_, x + a * stride_ + after);
  }
  for (std::size_t i = after; i < rows_; ++i) {
    const double* from = row(i) + i;
    double* to = row(i - count) + (i - count);
    for (std::size_t a = 0; a < count; ++a) {
      upper_triangular::rotate(from, x + a * stride_ + i, to, rows_ - i);
      from = to;
    }
  }
  std::copy(row_of_.begin() + static_cast<std::ptrdiff_t>(after),
            row_of_.begin() + static_cast<std::ptrdiff_t>(rows_),
            row_of_.begin() + static_cast<std::ptrdiff_t>(first));
  for (std::size_t i = constraint + 1; i < constraints_; ++i) first_rows_[i] = first_rows_[i + 1] - count;
  --constraints_;
  rows_ -= count;
}

void ContactFactor::copy(const ContactFactor& other) noexcept {
  for (std::size_t i = 0; i < other.rows_; ++i) std::copy(other.row(i) + i, other.row(i) + other.rows_, row(i) + i);
  std::copy_n(other.row_of_.begin(), other.rows_, row_of_.begin());
  std::copy_n(other.first_rows_.begin(), other.constraints_ + 1, first_rows_.begin());
  constraints_ = other.constraints_;
  rows_ = other.rows_;
  corner_known_ = false;
}

}  // namespace bodkin::fem
