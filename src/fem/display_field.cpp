#include "fem/display_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "core/error.h"

namespace bodkin {

namespace {

constexpr std::size_t strip = 2048;  // floats that stay in the first-level cache while the columns pass by
constexpr std::size_t columns_at_once = 6;

}  // namespace

DisplayField::DisplayField(Eigen::MatrixXf columns) : columns_(std::move(columns)), places_(nodes()) {
  std::iota(places_.begin(), places_.end(), 0U);
  check();
}

DisplayField::DisplayField(Eigen::MatrixXf columns, const std::vector<std::uint32_t>& nodes, std::size_t all)
    : columns_(std::move(columns)), places_(all, none) {
  check();
  if (nodes.size() != this->nodes()) {
    throw InputError("display field: " + std::to_string(nodes.size()) + " nodes, but columns of " +
                     std::to_string(this->nodes()));
  }
  for (std::uint32_t place = 0; place < nodes.size(); ++place) {
    if (nodes[place] >= all || places_[nodes[place]] != none) {
      throw InputError("display field: node " + std::to_string(nodes[place]) +
                       " is named twice or is not one of the " + std::to_string(all) + " that there are");
    }
    places_[nodes[place]] = place;
  }
}

void DisplayField::check() const {
  if (columns_.size() > 0 && columns_.rows() % 3 == 0 && columns_.cols() % 3 == 0) return;
  throw InputError("display field: columns of " + std::to_string(columns_.rows()) + " x " +
                   std::to_string(columns_.cols()) + ", expected 3 rows a visible point and 3 columns a node");
}

void DisplayField::evaluate(const NodeForces& forces, std::span<float> displacements) const noexcept {
  // Columns and their factors; the last group is filled up with factors of zero.
  std::array<const float*, 3 * NodeForces::capacity + columns_at_once> column;
  std::array<float, 3 * NodeForces::capacity + columns_at_once> factor;
  std::size_t used = 0;
  for (std::size_t i = 0; i < std::min(forces.count, NodeForces::capacity); ++i) {
    const NodeForce& here = forces.nodes[i];
    const std::uint32_t place = place_of(here.node);
    if (place == none) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      column[used] = columns_.data() + (3 * std::size_t{place} + c) * static_cast<std::size_t>(columns_.rows());
      factor[used++] = here.force[c];
    }
  }
  for (; used % columns_at_once != 0; ++used) {
    column[used] = columns_.data();
    factor[used] = 0.0F;
  }
  const std::size_t rows = std::min(displacements.size(), static_cast<std::size_t>(columns_.rows()));
  for (std::size_t from = 0; from < rows; from += strip) {
    const std::size_t count = std::min(strip, rows - from);
    float* __restrict sum = displacements.data() + from;
    std::fill_n(sum, count, 0.0F);
    for (std::size_t group = 0; group < used; group += columns_at_once) {
      const float* __restrict a = column[group] + from;
      const float* __restrict b = column[group + 1] + from;
      const float* __restrict c = column[group + 2] + from;
      const float* __restrict d = column[group + 3] + from;
      const float* __restrict e = column[group + 4] + from;
      const float* __restrict f = column[group + 5] + from;
      const float fa = factor[group], fb = factor[group + 1], fc = factor[group + 2];
      const float fd = factor[group + 3], fe = factor[group + 4], ff = factor[group + 5];
      for (std::size_t i = 0; i < count; ++i) {
        sum[i] += ((fa * a[i] + fb * b[i]) + (fc * c[i] + fd * d[i])) + (fe * e[i] + ff * f[i]);
      }
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

}  // namespace bodkin
