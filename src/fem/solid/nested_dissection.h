#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fem/solid/block_matrix.h"

namespace bodkin::fem {

// The coupling of the nodes of a symmetric matrix: the neighbours of each node, in both directions, without itself,
// ascending.
struct NodeGraph {
  std::vector<std::size_t> start;         // nodes + 1
  std::vector<std::uint32_t> neighbours;  // of node n: start[n] to start[n + 1]
  std::uint32_t nodes() const noexcept { return static_cast<std::uint32_t>(start.size() - 1); }
};

NodeGraph graph_of(const BlockMatrix& matrix);

// An order of elimination that keeps the factor sparse: METIS's nested dissection of all nodes but `last`, then
// `last` in the order given. Result k is the node eliminated k-th; the same for the same graph. Throws SystemError
// when METIS fails, InputError when `last` contains a node twice or one that is not in the graph.
std::vector<std::uint32_t> nested_dissection(const NodeGraph& graph, std::span<const std::uint32_t> last);

}  // namespace bodkin::fem
