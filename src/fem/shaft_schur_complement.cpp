#include "fem/shaft_schur_complement.h"

#include <algorithm>
#include <cmath>

#include "fem/upper_triangular.h"
#include "fem/zero_pages.h"

namespace bodkin::fem {

namespace {

// A pivot of T below this fraction of the node's own compliance counts as zero: the node depends on those before it.
// ContactFactor uses the same limit.
constexpr double least_part = 1e-10;
// Number of sticking nodes from which T is updated when rows change, 6 n^2 operations instead of n^3 / 3; and of
// updates before it is refactorised, so that rounding errors stay small.
constexpr std::size_t least_updated = 24;
constexpr int most_updates = 1000;

}  // namespace

ShaftSchurComplement::ShaftSchurComplement(std::size_t most_nodes, std::size_t always)
    : always_(always),
      stride_(upper_triangular::padded(always + most_nodes)),
      eliminated_(upper_triangular::padded(2 * most_nodes) * stride_, 0.0),
      own_(most_nodes, 0.0),
      triangle_(stride_ * stride_, 0.0),
      scratch_(2 * stride_, 0.0),
      least_(stride_, 0.0),
      gathered_(upper_triangular::padded(std::max(2 * most_nodes, stride_)), nullptr),
      factors_(stride_, 0.0),
      order_(most_nodes, 0),
      sticks_(most_nodes, 0) {
  std::size_t size = 0;
  for (std::size_t level = 0; level <= most_nodes; ++level) {
    level_at_.push_back(size);
    size += (always + level + 2) * level_stride(level);
  }
  sigma_.reserve(size);
  prefer_large_pages(sigma_.data(), size * sizeof(double));
  sigma_.assign(size, 0.0);
  begin();
}

// There are as many nodes as pairs of rows, and at most two more: the last one and the one before the tip.
std::size_t ShaftSchurComplement::level_stride(std::size_t level) const noexcept {
  return upper_triangular::padded(always_ + level + 2);
}

void ShaftSchurComplement::begin() noexcept {
  columns_ = always_;
  level_ = sticking_ = 0;
  std::fill(sticks_.begin(), sticks_.end(), std::uint8_t{0});
  for (std::size_t i = 0; i < always_; ++i) std::fill_n(level_row(0, i), always_, 0.0);
  stale_ = false;
  changed_ = true;
}

void ShaftSchurComplement::push_node(std::span<const double> eliminated, std::span<const double> own) noexcept {
  const std::size_t node = nodes(), column = columns_;
  own_[node] = own[node];
  for (std::size_t r = 0; r < rows(); ++r) eliminated_[r * stride_ + column] = eliminated[r];
  ++columns_;
  std::fill_n(scratch_.data(), stride_, 0.0);
  add_transposed(eliminated.data(), scratch_.data());
  double* const across = level_row(level_, column);
  for (std::size_t i = 0; i <= column; ++i) {
    const double value = (i < always_ ? 0.0 : own[i - always_]) - scratch_[i];
    across[i] = value;
    level_row(level_, i)[column] = value;
  }
}

void ShaftSchurComplement::pop_node() noexcept {
  release(nodes() - 1);
  --columns_;
}

void ShaftSchurComplement::push_rows(std::span<const double> first, std::span<const double> second) noexcept {
  double* const a = eliminated_.data() + rows() * stride_;
  double* const b = a + stride_;
  std::copy_n(first.data(), columns_, a);
  std::copy_n(second.data(), columns_, b);
  std::fill(a + columns_, a + stride_, 0.0);
  std::fill(b + columns_, b + stride_, 0.0);
  upper_triangular::subtract_squares(level_row(level_, 0), level_stride(level_), a, b, columns_,
                                     level_row(level_ + 1, 0), level_stride(level_ + 1));
  ++level_;
  update_factor(true);
}

void ShaftSchurComplement::pop_rows() noexcept {
  --level_;
  update_factor(false);
}

// The last rows have been added, or have just been removed.
void ShaftSchurComplement::update_factor(bool rows_added) noexcept {
  changed_ = true;
  if (stale_ || sticking_ < least_updated || updates_ >= most_updates) {
    stale_ = true;
    return;
  }
  ++updates_;
  const double* const first = eliminated_.data() + 2 * (rows_added ? level_ - 1 : level_) * stride_;
  double* const a = scratch_.data();
  double* const b = a + stride_;
  for (std::size_t k = 0; k < sticking_; ++k) {
    const std::size_t column = always_ + order_[k];
    a[k] = first[column];
    b[k] = first[stride_ + column];
    least_[k] = least_part * own_[order_[k]];
  }
  if (!rows_added) {
    upper_triangular::add_squares_to_factor(triangle_.data(), stride_, sticking_, a, b);
  } else {
    stale_ =
        !upper_triangular::subtract_squares_from_factor(triangle_.data(), stride_, sticking_, a, b, least_.data());
  }
}

void ShaftSchurComplement::add_transposed(const double* factors, double* values) noexcept {
  for (std::size_t r = 0; r < rows(); ++r) gathered_[r] = eliminated_.data() + r * stride_;
  upper_triangular::add_rows(gathered_.data(), factors, rows(), values, columns_);
}

void ShaftSchurComplement::multiply(const double* values, double* products) const noexcept {
  upper_triangular::multiply(eliminated_.data(), stride_, rows(), values, columns_, products);
}

void ShaftSchurComplement::add_displacements(const double* forces, double* values) noexcept {
  std::size_t count = 0;
  for (std::size_t i = 0; i < columns_; ++i) {
    if (forces[i] == 0.0) continue;
    gathered_[count] = level_row(level_, i);
    factors_[count++] = forces[i];
  }
  upper_triangular::add_rows(gathered_.data(), factors_.data(), count, values, columns_);
}

std::size_t ShaftSchurComplement::row_of(std::size_t node) const noexcept {
  const auto nodes_of_t = sticking();
  return static_cast<std::size_t>(std::find(nodes_of_t.begin(), nodes_of_t.end(), node) - nodes_of_t.begin());
}

// Adds a column to T.
bool ShaftSchurComplement::add_column(std::size_t node) noexcept {
  double* const column = scratch_.data();
  const double* const from = level_row(level_, always_ + node);
  for (std::size_t k = 0; k < sticking_; ++k) column[k] = from[always_ + order_[k]];
  forward(column, 1);
  double pivot = from[always_ + node];
  pivot -= upper_triangular::product(column, column, sticking_);
  if (!(pivot > least_part * own_[node]) || !std::isfinite(pivot)) return false;
  for (std::size_t k = 0; k < sticking_; ++k) triangle_[k * stride_ + sticking_] = column[k];
  triangle_[sticking_ * stride_ + sticking_] = std::sqrt(pivot);
  order_[sticking_++] = static_cast<std::uint32_t>(node);
  sticks_[node] = 1;
  changed_ = true;
  return true;
}

bool ShaftSchurComplement::stick(std::size_t node) noexcept {
  if (sticks(node)) return false;
  if (stale_) factorise();
  return add_column(node);
}

void ShaftSchurComplement::release(std::size_t node) noexcept {
  if (!sticks(node)) return;
  const std::size_t at = row_of(node);
  sticks_[node] = 0;
  changed_ = true;
  std::copy(order_.begin() + static_cast<std::ptrdiff_t>(at) + 1,
            order_.begin() + static_cast<std::ptrdiff_t>(sticking_),
            order_.begin() + static_cast<std::ptrdiff_t>(at));
  --sticking_;
  if (stale_) return;
  // As in ContactFactor::remove(): the removed row's remaining numbers are rotated into the rows below it.
  const std::size_t before = sticking_ + 1;
  for (std::size_t i = 0; i < at; ++i) {
    double* const row = triangle_.data() + i * stride_;
    std::copy(row + at + 1, row + before, row + at);
  }
  double* const other = scratch_.data();
  std::copy_n(triangle_.data() + at * stride_ + at + 1, before - at - 1, other + at + 1);
  for (std::size_t i = at + 1; i < before; ++i) {
    upper_triangular::rotate(triangle_.data() + i * stride_ + i, other + i,
                             triangle_.data() + (i - 1) * (stride_ + 1), before - i);
  }
}

void ShaftSchurComplement::stick_first(std::size_t count) noexcept {
  std::fill(sticks_.begin(), sticks_.end(), std::uint8_t{0});
  for (std::size_t i = 0; i < count; ++i) {
    order_[i] = static_cast<std::uint32_t>(i);
    sticks_[i] = 1;
  }
  sticking_ = count;
  stale_ = changed_ = true;
}

std::size_t ShaftSchurComplement::release_cost(std::size_t node) const noexcept {
  const std::size_t behind = sticking_ - row_of(node);
  return behind * behind / 2;
}

void ShaftSchurComplement::factorise() noexcept {
  stale_ = false;
  changed_ = true;
  updates_ = 0;
  const auto first = order_.begin(), end = first + static_cast<std::ptrdiff_t>(sticking_);
  const bool consecutive =
      sticking_ > 0 && order_[sticking_ - 1] - order_[0] == sticking_ - 1 && std::is_sorted(first, end);
  for (std::size_t k = 0; k < sticking_; ++k) {
    const double* const from = level_row(level_, always_ + order_[k]) + always_;
    double* const to = triangle_.data() + k * stride_;
    std::fill(to + k / 8 * 8, to + k, 0.0);
    if (consecutive) {
      std::copy_n(from + order_[k], sticking_ - k, to + k);
    } else {
      for (std::size_t j = k; j < sticking_; ++j) to[j] = from[order_[j]];
    }
    std::fill(to + sticking_, to + upper_triangular::padded(sticking_), 0.0);
    least_[k] = least_part * own_[order_[k]];
  }
  if (upper_triangular::factorise(triangle_.data(), stride_, sticking_, least_.data()) == sticking_) return;
  // Some node depends on the others: add the nodes one by one; those that fail slide.
  const std::size_t wanted = sticking_;
  sticking_ = 0;
  for (std::size_t k = 0; k < wanted; ++k) {
    const std::uint32_t node = order_[k];
    sticks_[node] = 0;
    add_column(node);
  }
}

bool ShaftSchurComplement::refresh() noexcept {
  if (stale_) factorise();
  const bool changed = changed_;
  changed_ = false;
  return changed;
}

void ShaftSchurComplement::forward(double* vectors, std::size_t count) const noexcept {
  upper_triangular::solve_transposed({triangle_.data(), stride_, sticking_}, vectors, count);
}

void ShaftSchurComplement::backward(double* values) const noexcept {
  upper_triangular::solve({triangle_.data(), stride_, sticking_}, values);
}

}  // namespace bodkin::fem
