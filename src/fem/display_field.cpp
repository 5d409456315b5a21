#include "fem/display_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "core/error.h"
#include "core/simd.h"

namespace bodkin::fem {

namespace {

constexpr std::size_t longest_strip = 4096;  // floats that stay in the first-level cache while the columns pass by
constexpr std::size_t columns_at_once = 6;

std::vector<std::uint32_t> all_names(Eigen::Index columns) {
  std::vector<std::uint32_t> names(static_cast<std::size_t>(columns) / 3);
  std::iota(names.begin(), names.end(), 0U);
  return names;
}

std::size_t in_threes(const Eigen::MatrixXf& columns) {
  if (columns.size() > 0 && columns.rows() % 3 == 0 && columns.cols() % 3 == 0) {
    return static_cast<std::size_t>(columns.rows()) / 3;
  }
  throw InputError("display field: columns of " + std::to_string(columns.rows()) + " x " +
                   std::to_string(columns.cols()) + ", expected 3 rows a visible point and 3 columns a node");
}

// sum[i] += six columns times their factors.
BODKIN_PROCESSOR_CLONES
void add_columns(const std::array<const float*, columns_at_once>& columns, const float* factors, std::size_t count,
                 float* __restrict sum) noexcept {
  const float* __restrict a = columns[0];
  const float* __restrict b = columns[1];
  const float* __restrict c = columns[2];
  const float* __restrict d = columns[3];
  const float* __restrict e = columns[4];
  const float* __restrict f = columns[5];
  const float fa = factors[0], fb = factors[1], fc = factors[2], fd = factors[3], fe = factors[4], ff = factors[5];
  for (std::size_t i = 0; i < count; ++i) {
    sum[i] += ((fa * a[i] + fb * b[i]) + (fc * c[i] + fd * d[i])) + (fe * e[i] + ff * f[i]);
  }
}

}  // namespace

DisplayField::DisplayField(std::size_t points, const std::vector<std::uint32_t>& nodes, std::size_t all,
                           std::size_t spare)
    : points_(points),
      nodes_(nodes.size() + spare),
      strips_((3 * points + longest_strip - 1) / longest_strip),
      strip_length_(strips_ == 0 ? 0 : (3 * points / strips_ + 16) / 16 * 16),
      columns_((strips_ * strip_length_ * 3 * nodes_ + 1) / 2),
      places_(all, none),
      spare_(spare, none) {
  for (std::uint32_t place = 0; place < nodes.size(); ++place) {
    if (nodes[place] >= all || places_[nodes[place]] != none) {
      throw InputError("display field: node " + std::to_string(nodes[place]) +
                       " is named twice or is not one of the " + std::to_string(all) + " that there are");
    }
    places_[nodes[place]] = place;
  }
}

DisplayField::DisplayField(const Eigen::MatrixXf& columns, const std::vector<std::uint32_t>& nodes, std::size_t all)
    : DisplayField(in_threes(columns), nodes, all) {
  if (3 * nodes.size() != static_cast<std::size_t>(columns.cols())) {
    throw InputError("display field: " + std::to_string(nodes.size()) + " nodes, but columns of " +
                     std::to_string(columns.cols() / 3));
  }
  for (Eigen::Index i = 0; i < columns.cols(); ++i) {
    set_column(static_cast<std::size_t>(i), {columns.col(i).data(), static_cast<std::size_t>(columns.rows())});
  }
}

DisplayField::DisplayField(const Eigen::MatrixXf& columns)
    : DisplayField(columns, all_names(columns.cols()), static_cast<std::size_t>(columns.cols()) / 3) {}

void DisplayField::set_column(std::size_t index, std::span<const float> column) noexcept {
  for (std::size_t strip = 0, from = 0; from < column.size(); ++strip, from += strip_length_) {
    std::copy_n(column.data() + from, std::min(strip_length_, column.size() - from),
                columns_.singles() + (strip * 3 * nodes_ + index) * strip_length_);
  }
}

void DisplayField::take(std::size_t which, std::uint32_t node, const Eigen::Ref<const Eigen::MatrixXf>& columns) {
  if (spare_[which] != none) places_[spare_[which]] = none;
  spare_[which] = node;
  const std::size_t place = nodes_ - spare_.size() + which;
  places_[node] = static_cast<std::uint32_t>(place);
  for (Eigen::Index c = 0; c < 3; ++c)
    set_column(3 * place + static_cast<std::size_t>(c), {columns.col(c).data(), 3 * points_});
}

Mat3 DisplayField::between(std::size_t point, std::uint32_t node) const noexcept {
  Mat3 found;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t at = 3 * point + row;
      found(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(c)) =
          static_cast<double>(piece(at / strip_length_, 3 * std::size_t{places_[node]} + c)[at % strip_length_]);
    }
  return found;
}

void DisplayField::evaluate(const NodeForces& forces, std::span<float> displacements) const noexcept {
  // Columns and their factors; the last group is padded with factors of zero.
  std::array<std::size_t, 3 * NodeForces::capacity + columns_at_once> column;
  std::array<float, 3 * NodeForces::capacity + columns_at_once> factor;
  std::size_t used = 0;
  for (std::size_t i = 0; i < std::min(forces.count, NodeForces::capacity); ++i) {
    const NodeForce& here = forces.nodes[i];
    const std::uint32_t place = place_of(here.node);
    if (place == none) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      column[used] = 3 * std::size_t{place} + c;
      factor[used++] = here.force[c];
    }
  }
  for (; used % columns_at_once != 0; ++used) {
    column[used] = 0;
    factor[used] = 0.0F;
  }
  const std::size_t rows = std::min(displacements.size(), 3 * points_);
  for (std::size_t strip = 0, from = 0; from < rows; ++strip, from += strip_length_) {
    const std::size_t count = std::min(strip_length_, rows - from);
    float* const sum = displacements.data() + from;
    std::fill_n(sum, count, 0.0F);
    for (std::size_t group = 0; group < used; group += columns_at_once) {
      std::array<const float*, columns_at_once> pieces{};
      for (std::size_t i = 0; i < columns_at_once; ++i) pieces[i] = piece(strip, column[group + i]);
      add_columns(pieces, factor.data() + group, count, sum);
    }
  }
}

double DisplayField::left_out(const NodeForces& forces) const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < std::min(forces.count, NodeForces::capacity); ++i) {
    const auto& [node, force] = forces.nodes[i];
    if (place_of(node) == none) sum += static_cast<double>(std::hypot(force[0], force[1], force[2]));
  }
  return sum;
}

}  // namespace bodkin::fem
