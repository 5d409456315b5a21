#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry.h"
#include "fem/node_forces.h"
#include "fem/zero_pages.h"

namespace bodkin::fem {

// The displacement of the visible points of a body by the forces of a needle: u = columns(nodes) f, the same operator
// as in the tick, so that display and hand show one body. For the display thread; the tick passes NodeForces to it
// through LatestValue.
class DisplayField {
 public:
  // `columns`: 3 x points rows and 3 columns for each node that has any, mm/N, single precision: displacement of
  // every point (x, y, z) by 1 N on the node. Throws InputError when rows or columns are not multiples of three, or
  // empty.
  explicit DisplayField(const Eigen::MatrixXf& columns);
  // As above, for some nodes only: 3 columns for each of `nodes` (each once), whose indices are below `all`.
  DisplayField(const Eigen::MatrixXf& columns, const std::vector<std::uint32_t>& nodes, std::size_t all);
  // As above, with columns that are zero until set_column(), and room for `spare` more nodes (take()).
  DisplayField(std::size_t points, const std::vector<std::uint32_t>& nodes, std::size_t all, std::size_t spare = 0);

  // Column `index`, 0 to 3 x nodes() - 1; 3 x points() values. Not in parallel with evaluate().
  void set_column(std::size_t index, std::span<const float> column) noexcept;
  // Gives the spare place `which`, below spare(), the three columns of `node` instead of those of its previous node.
  // Not in parallel with evaluate().
  void take(std::size_t which, std::uint32_t node, const Eigen::Ref<const Eigen::MatrixXf>& columns);
  // `node` must be below `all`, and must not have columns yet when take() adds it.
  bool knows(std::uint32_t node) const noexcept { return place_of(node) != none; }
  std::size_t all() const noexcept { return places_.size(); }
  // mm/N: displacement of a point by unit forces on a known node.
  Mat3 between(std::size_t point, std::uint32_t node) const noexcept;

  std::size_t points() const noexcept { return points_; }
  // Number of nodes that have columns or a spare place for them.
  std::size_t nodes() const noexcept { return nodes_; }
  std::size_t spare() const noexcept { return spare_.size(); }

  // mm, 3 x points() values, all of them written; forces on nodes without columns are ignored. Never throws,
  // allocates or locks; several threads may call it at once.
  void evaluate(const NodeForces& forces, std::span<float> displacements) const noexcept;
  // N, the sum of the forces on nodes without columns, which the display omits.
  double left_out(const NodeForces& forces) const noexcept;

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  std::uint32_t place_of(std::uint32_t node) const noexcept { return node < places_.size() ? places_[node] : none; }

  const float* piece(std::size_t strip, std::size_t column) const noexcept {
    return columns_.singles() + (strip * 3 * nodes_ + column) * strip_length_;
  }

  std::size_t points_, nodes_;
  std::size_t strips_, strip_length_;
  ZeroPages columns_;                  // strip by strip, in each all columns
  std::vector<std::uint32_t> places_;  // by node: position of its columns, or none
  std::vector<std::uint32_t> spare_;   // by spare place, the last ones: its node, or none
};

}  // namespace bodkin::fem
