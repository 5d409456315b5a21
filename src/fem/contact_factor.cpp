#include "fem/contact_factor.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "core/error.h"

namespace bodkin {

namespace {

constexpr std::size_t block = 8;       // rows of U that are worked on together
constexpr double least_pivot = 1e-10;  // of the diagonal of S, below which a constraint is no news

std::size_t padded(std::size_t count) {
  return (count + block - 1) / block * block;
}

// Four numbers at once, wherever they lie. The order of every sum is written out, so that the bits are the same
// whatever width the processor has.
using Lanes = double __attribute__((vector_size(32), aligned(8), may_alias));
constexpr std::size_t lanes = 4;

// values[j] -= sum over the 8 rows of rows[r * stride + j] solved[r], j in [from, to).
inline void subtract_rows(const double* rows, std::size_t stride, const double* solved, double* values,
                          std::size_t from, std::size_t to) noexcept {
  for (std::size_t j = from; j < to; j += lanes) {
    Lanes sum = *reinterpret_cast<const Lanes*>(values + j);
    for (std::size_t r = 0; r < block; ++r) {
      sum -= *reinterpret_cast<const Lanes*>(rows + r * stride + j) * solved[r];
    }
    *reinterpret_cast<Lanes*>(values + j) = sum;
  }
}

// sums[r] = rows[r * stride + j] values[j] summed over j in [from, to), for 4 rows.
inline void four_products(const double* rows, std::size_t stride, const double* values, std::size_t from,
                          std::size_t to, double* sums) noexcept {
  Lanes sum[4] = {};
  for (std::size_t j = from; j < to; j += lanes) {
    const Lanes value = *reinterpret_cast<const Lanes*>(values + j);
    for (std::size_t r = 0; r < 4; ++r) sum[r] += *reinterpret_cast<const Lanes*>(rows + r * stride + j) * value;
  }
  for (std::size_t r = 0; r < 4; ++r) sums[r] = (sum[r][0] + sum[r][1]) + (sum[r][2] + sum[r][3]);
}

// The rotation that makes the first of `other` zero: `to` is what becomes of `from`, which may be the same.
inline void rotate(const double* from, double* other, double* to, std::size_t count) noexcept {
  const double length = std::sqrt(from[0] * from[0] + other[0] * other[0]);
  const double cosine = from[0] / length, sine = other[0] / length;
  std::size_t j = 0;
  for (; j + lanes <= count; j += lanes) {
    const Lanes here = *reinterpret_cast<const Lanes*>(from + j);
    const Lanes there = *reinterpret_cast<const Lanes*>(other + j);
    *reinterpret_cast<Lanes*>(to + j) = here * cosine + there * sine;
    *reinterpret_cast<Lanes*>(other + j) = there * cosine - here * sine;
  }
  for (; j < count; ++j) {
    const double here = from[j], there = other[j];
    to[j] = here * cosine + there * sine;
    other[j] = there * cosine - here * sine;
  }
}

}  // namespace

ContactFactor::ContactFactor(const Eigen::MatrixXd& compliance, std::size_t most_nodes)
    : compliance_(compliance), most_rows_(3 * most_nodes), stride_(padded(3 * most_nodes)) {
  if (compliance.rows() != compliance.cols() || compliance.rows() % 3 != 0 || compliance.rows() == 0) {
    throw InputError("contact: the compliance of the corridor is " + std::to_string(compliance.rows()) + " x " +
                     std::to_string(compliance.cols()) + ", expected 3 rows and columns for each of its nodes");
  }
  if (most_nodes == 0) throw InputError("contact: room for 0 nodes, expected at least 1");
  constexpr std::size_t line = 64;
  storage_.assign(padded(most_rows_) * stride_ + line / sizeof(double), 0.0);
  void* begin = storage_.data();
  std::size_t room = storage_.size() * sizeof(double);
  std::align(line, padded(most_rows_) * stride_ * sizeof(double), begin, room);
  factor_ = {static_cast<double*>(begin), padded(most_rows_) * stride_};
  scratch_.assign(3 * stride_, 0.0);
  row_of_.resize(most_rows_);
  first_rows_.assign(most_rows_ + 1, 0);
}

template <int Columns>
void ContactFactor::forward(double* columns) const noexcept {
  const std::size_t end = padded(rows_);
  for (std::size_t first = 0; first < rows_; first += block) {
    const std::size_t count = std::min(block, rows_ - first);
    for (int column = 0; column < Columns; ++column) {
      double* values = columns + static_cast<std::size_t>(column) * stride_;
      double solved[block] = {};
      for (std::size_t r = 0; r < count; ++r) {
        const double* upper = row(first + r);
        solved[r] = values[first + r] / upper[first + r];
        for (std::size_t j = first + r + 1; j < first + count; ++j) values[j] -= upper[j] * solved[r];
      }
      std::copy_n(solved, count, values + first);
      subtract_rows(row(first), stride_, solved, values, first + block, end);
    }
  }
}

void ContactFactor::solve(std::span<double> values) noexcept {
  double* d = scratch_.data();
  std::copy_n(values.data(), rows_, d);
  forward<1>(d);
  const std::size_t end = padded(rows_);
  std::fill(d + rows_, d + end, 0.0);
  for (std::size_t first = end; first > 0;) {
    first -= block;
    double sums[block];
    four_products(row(first), stride_, d, first + block, end, sums);
    four_products(row(first + 4), stride_, d, first + block, end, sums + 4);
    for (std::size_t r = std::min(block, rows_ - first); r > 0;) {
      --r;
      const double* upper = row(first + r);
      double value = d[first + r] - sums[r];
      for (std::size_t j = first + r + 1; j < std::min(first + block, rows_); ++j) value -= upper[j] * d[j];
      d[first + r] = value / upper[first + r];
    }
  }
  std::copy_n(d, rows_, values.data());
}

// The corner of U that belongs to the last constraint, from what stands above it.
bool ContactFactor::finish(std::size_t first, std::size_t count, double softness) noexcept {
  Mat3 corner = Mat3::Zero();
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      const auto node = static_cast<Eigen::Index>(3 * row_of_[first].node);
      corner(static_cast<int>(b), static_cast<int>(a)) =
          row_of_[first + b].direction.dot(compliance_.block<3, 3>(node, node) * row_of_[first + a].direction);
    }
  }
  const Vec3 whole = corner.diagonal();
  for (std::size_t i = 0; i < first; ++i) {
    const double* above = row(i) + first;
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = 0; b <= a; ++b) corner(static_cast<int>(b), static_cast<int>(a)) -= above[a] * above[b];
    }
  }
  Mat3 upper = Mat3::Zero();
  for (int a = 0; a < static_cast<int>(count); ++a) {
    for (int b = 0; b < a; ++b) {
      double value = corner(b, a);
      for (int i = 0; i < b; ++i) value -= upper(i, a) * upper(i, b);
      upper(b, a) = value / upper(b, b);
    }
    double pivot = corner(a, a) + softness;
    for (int i = 0; i < a; ++i) pivot -= upper(i, a) * upper(i, a);
    if (!(pivot > least_pivot * whole(a)) || !std::isfinite(pivot)) return false;
    upper(a, a) = std::sqrt(pivot);
  }
  for (std::size_t b = 0; b < count; ++b) {
    for (std::size_t a = b; a < count; ++a) {
      row(first + b)[first + a] = upper(static_cast<int>(b), static_cast<int>(a));
    }
  }
  return true;
}

bool ContactFactor::append(std::uint32_t node, const HeldDirections& directions, double softness) noexcept {
  const auto count = static_cast<std::size_t>(directions.cols());
  const auto place = static_cast<Eigen::Index>(3) * static_cast<Eigen::Index>(node);
  if (count == 0 || rows_ + count > most_rows_ || place + 3 > compliance_.rows() || !(softness >= 0.0)) return false;
  double* columns = scratch_.data();
  for (std::size_t i = 0; i < rows_; ++i) {
    const auto at = static_cast<Eigen::Index>(3) * static_cast<Eigen::Index>(row_of_[i].node);
    const Vec3 moved = compliance_.block<3, 3>(at, place).transpose() * row_of_[i].direction;
    for (std::size_t a = 0; a < count; ++a) {
      columns[a * stride_ + i] = moved.dot(directions.col(static_cast<Eigen::Index>(a)));
    }
  }
  if (count == 1) {
    forward<1>(columns);
  } else if (count == 2) {
    forward<2>(columns);
  } else {
    forward<3>(columns);
  }
  for (std::size_t i = 0; i < rows_; ++i) {
    for (std::size_t a = 0; a < count; ++a) row(i)[rows_ + a] = columns[a * stride_ + i];
  }
  for (std::size_t a = 0; a < count; ++a) {
    row_of_[rows_ + a] = {node, directions.col(static_cast<Eigen::Index>(a))};
  }
  if (!finish(rows_, count, softness)) {
    for (std::size_t i = 0; i < rows_; ++i) std::fill_n(row(i) + rows_, count, 0.0);
    return false;
  }
  rows_ += count;
  first_rows_[++held_] = rows_;
  return true;
}

void ContactFactor::clear() noexcept {
  held_ = rows_ = 0;
}

void ContactFactor::remove_last() noexcept {
  if (held_ > 0) rows_ = first_rows_[--held_];
}

bool ContactFactor::soften_last(double softness) noexcept {
  if (held_ == 0 || !(softness >= 0.0)) return false;
  const std::size_t first = first_rows_[held_ - 1];
  return finish(first, rows_ - first, softness);
}

std::size_t ContactFactor::removal_cost(std::size_t constraint) const noexcept {
  const std::size_t behind = rows_ - first_rows_[constraint];
  return behind * behind / 2;
}

// With the columns of the constraint gone, U has too many rows below: what its rows hold behind them, x, has to be
// turned into the triangle T that follows, so that T'^T T' = T^T T + x^T x (a Givens rotation for every row of x and
// of T). T' then stands where the constraint stood.
void ContactFactor::remove(std::size_t constraint) noexcept {
  if (constraint >= held_) return;
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
      rotate(from, x + a * stride_ + i, to, rows_ - i);
      from = to;
    }
  }
  std::copy(row_of_.begin() + static_cast<std::ptrdiff_t>(after),
            row_of_.begin() + static_cast<std::ptrdiff_t>(rows_),
            row_of_.begin() + static_cast<std::ptrdiff_t>(first));
  for (std::size_t i = constraint + 1; i < held_; ++i) first_rows_[i] = first_rows_[i + 1] - count;
  --held_;
  rows_ -= count;
}

void ContactFactor::copy(const ContactFactor& other) noexcept {
  for (std::size_t i = 0; i < other.rows_; ++i) std::copy(other.row(i) + i, other.row(i) + other.rows_, row(i) + i);
  std::copy_n(other.row_of_.begin(), other.rows_, row_of_.begin());
  std::copy_n(other.first_rows_.begin(), other.held_ + 1, first_rows_.begin());
  held_ = other.held_;
  rows_ = other.rows_;
}

}  // namespace bodkin
