#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "fem/solid/nested_dissection.h"

namespace bodkin::fem {

inline constexpr std::uint32_t no_parent = std::numeric_limits<std::uint32_t>::max();

// For each column of a Cholesky factor the first later column that it changes: its parent. By position in the order
// of elimination.
struct EliminationTree {
  std::vector<std::uint32_t> parent;  // no_parent: none, or one of the last nodes
  std::vector<std::uint32_t> count;   // blocks of the column, with the diagonal and the last nodes' rows
};

// The tree of the first `free` nodes of `order`; the others come last and are not part of it. Reorders these first
// nodes so that the fill-in is the same and every node comes directly after the subtrees of its children (Liu, The
// role of elimination trees in sparse factorization, 1990).
EliminationTree elimination_tree(const NodeGraph& graph, std::vector<std::uint32_t>& order, std::uint32_t free);

}  // namespace bodkin::fem
