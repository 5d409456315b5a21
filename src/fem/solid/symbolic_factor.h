#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "fem/solid/nested_dissection.h"

namespace bodkin::fem {

// Columns of the Cholesky factor with the same rows below them, stored as one dense panel of 3 (columns + rows) by 3
// columns numbers.
struct Supernode {
  std::uint32_t first = 0;     // its first column; all counts are in nodes, in the order of elimination
  std::uint32_t columns = 0;   // their number
  std::size_t rows_at = 0;     // start of its rows in SymbolicFactor::rows
  std::uint32_t rows = 0;      // number of rows below its own columns
  std::uint32_t children = 0;  // number of earlier supernodes that pass their updates to this one
  std::size_t panel_at = 0;    // start of its panel in the factor, in numbers

  std::size_t height() const noexcept { return 3 * (std::size_t{columns} + rows); }
  std::size_t width() const noexcept { return 3 * std::size_t{columns}; }
  std::size_t panel_size() const noexcept { return height() * width(); }
  // Multiplications and additions of its factorisation and its update.
  double operations() const noexcept {
    const double w = 3.0 * columns, below = 3.0 * rows;
    return w * w * w / 3.0 + w * w * below + w * below * below;
  }
  // Size of its update: the lower triangle, packed by columns.
  std::size_t update_size() const noexcept { return 3 * std::size_t{rows} * (3 * std::size_t{rows} + 1) / 2; }
};

// The structure of a factorisation, found only from the graph: the supernodes in the order in which they are
// eliminated, each directly after the subtrees of its children, and the memory and work that they need.
struct SymbolicFactor {
  std::vector<std::uint32_t> order;     // node eliminated k-th
  std::vector<std::uint32_t> position;  // of each node in `order`
  std::vector<Supernode> supernodes;
  std::vector<std::uint32_t> rows;  // positions, ascending within a supernode
  std::uint32_t last = 0;           // this many nodes come last, as one supernode of their own
  std::size_t blocks = 0;           // of the matrix
  std::size_t factor_size = 0;      // numbers in all panels
  std::size_t largest_panel = 0;    // numbers, excluding the panel of the last nodes
  std::size_t stack_size = 0;       // numbers, the most that wait to be passed on at one time
  double operations = 0.0;          // multiplications and additions

  std::size_t last_size() const noexcept { return 9 * std::size_t{last} * last; }
  // Bytes at the peak of the factorisation and of later steps, including the matrix and the inverse of the last
  // panel; `keep_field`: all panels stay, not only that of the last nodes.
  std::size_t bytes(bool keep_field) const noexcept;
};

// Analyses the factorisation of a matrix with this graph and `last` eliminated last, in the order given. Neighbouring
// supernodes are merged where that costs few zeros (as CHOLMOD does, Chen et al. 2008, section 3.4), since larger
// dense blocks are faster. Throws what nested_dissection throws.
SymbolicFactor analyse(const NodeGraph& graph, std::span<const std::uint32_t> last);

}  // namespace bodkin::fem
