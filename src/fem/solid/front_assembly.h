#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "fem/solid/block_matrix.h"
#include "fem/solid/symbolic_factor.h"

namespace bodkin::fem {

// A dense front: the panel of its supernode, height x width, and the update below and to the right of it, of 3 rows x
// 3 rows. Column-major, lower triangle.
struct Front {
  double* panel = nullptr;
  double* update = nullptr;
  const Supernode* supernode = nullptr;

  std::size_t height() const noexcept { return supernode->height(); }
  std::size_t width() const noexcept { return supernode->width(); }
  std::size_t update_height() const noexcept { return 3 * std::size_t{supernode->rows}; }
};

// Assembles fronts from the blocks of a matrix and from the updates of their children.
class FrontAssembly {
 public:
  FrontAssembly(const BlockMatrix& matrix, const SymbolicFactor& symbolic);

  // Adds the blocks of the matrix in the columns of this front.
  void add_matrix(const Front& front);
  // Adds the packed update of a child.
  void add_update(const Front& front, const Supernode& child, const double* update);

 private:
  // Determines the position of each row in the front, in nodes.
  void place_rows(const Supernode& supernode);

  struct Entry {
    std::uint32_t row;  // position
    bool transposed;    // the block is in the upper triangle in this order
    std::size_t block;  // in the matrix
  };
  const BlockMatrix& matrix_;
  const SymbolicFactor& symbolic_;
  std::vector<std::size_t> start_;  // by position, of its entries
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> place_;  // by position, in the present front
  // Rows of a child that stay neighbours in the parent: `length` from the child's row `from` on, to row `to`.
  struct Run {
    std::size_t from, to, length;
  };
  std::vector<Run> runs_;
};

}  // namespace bodkin::fem
