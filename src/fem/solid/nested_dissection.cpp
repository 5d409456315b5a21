#include "fem/solid/nested_dissection.h"

#include <limits>
#include <mutex>

#include <fmt/format.h>
#include <metis.h>

#include "core/error.h"

namespace bodkin::fem {

namespace {

constexpr std::uint32_t absent = std::numeric_limits<std::uint32_t>::max();
constexpr idx_t seed = 1;

// METIS's indices of the nodes: all except `last`, in their order.
std::vector<std::uint32_t> names_without(std::uint32_t nodes, std::span<const std::uint32_t> last) {
  std::vector<std::uint32_t> names(nodes, 0);
  for (const std::uint32_t node : last) {
    if (node >= nodes) throw InputError(fmt::format("node {} of the corridor is not in the body", node));
    if (names[node] == absent) throw InputError(fmt::format("node {} of the corridor is named twice", node));
    names[node] = absent;
  }
  std::uint32_t next = 0;
  for (std::uint32_t& name : names)
    if (name != absent) name = next++;
  return names;
}

}  // namespace

NodeGraph graph_of(const BlockMatrix& matrix) {
  NodeGraph graph;
  graph.start.assign(std::size_t{matrix.nodes} + 1, 0);
  for (std::uint32_t column = 0; column < matrix.nodes; ++column) {
    for (std::size_t i = matrix.start[column] + 1; i < matrix.start[column + 1]; ++i) {
      ++graph.start[column + 1];
      ++graph.start[matrix.row[i] + 1];
    }
  }
  for (std::size_t node = 0; node < matrix.nodes; ++node) graph.start[node + 1] += graph.start[node];
  graph.neighbours.resize(graph.start.back());
  // Columns come in turn, so that each node first gets its smaller neighbours, ascending; its larger ones come in its
  // own column, after all of those.
  std::vector<std::size_t> next(graph.start.begin(), graph.start.end() - 1);
  for (std::uint32_t column = 0; column < matrix.nodes; ++column) {
    for (std::size_t i = matrix.start[column] + 1; i < matrix.start[column + 1]; ++i) {
      graph.neighbours[next[column]++] = matrix.row[i];
      graph.neighbours[next[matrix.row[i]]++] = column;
    }
  }
  return graph;
}

std::vector<std::uint32_t> nested_dissection(const NodeGraph& graph, std::span<const std::uint32_t> last) {
  const std::vector<std::uint32_t> names = names_without(graph.nodes(), last);
  auto count = static_cast<idx_t>(graph.nodes() - last.size());
  if (graph.neighbours.size() > static_cast<std::size_t>(std::numeric_limits<idx_t>::max())) {
    throw InputError(
        fmt::format("a body of {} nodes is too large to be ordered; mesh it more coarsely", graph.nodes()));
  }
  std::vector<std::uint32_t> order(graph.nodes());
  for (std::size_t i = 0; i < last.size(); ++i) order[static_cast<std::size_t>(count) + i] = last[i];
  if (count == 0) return order;

  std::vector<idx_t> start{0}, neighbours, permutation(static_cast<std::size_t>(count)), inverse(permutation.size());
  std::vector<std::uint32_t> nodes;  // by METIS's index
  for (std::uint32_t node = 0; node < graph.nodes(); ++node) {
    if (names[node] == absent) continue;
    nodes.push_back(node);
    for (std::size_t i = graph.start[node]; i < graph.start[node + 1]; ++i) {
      const std::uint32_t name = names[graph.neighbours[i]];
      if (name != absent) neighbours.push_back(static_cast<idx_t>(name));
    }
    start.push_back(static_cast<idx_t>(neighbours.size()));
  }
  if (neighbours.empty()) neighbours.push_back(0);  // METIS requires an address even for an empty array
  std::array<idx_t, METIS_NOPTIONS> options{};
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = seed;
  options[METIS_OPTION_NUMBERING] = 0;
  const int status = [&] {
    // METIS uses the C library's random numbers, one sequence per program: two simultaneous orderings would take
    // numbers from each other, and neither would be repeatable.
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    return METIS_NodeND(&count, start.data(), neighbours.data(), nullptr, options.data(), permutation.data(),
                        inverse.data());
  }();
  if (status != METIS_OK) {
    throw SystemError(fmt::format(
        "METIS could not order the {} nodes of the body (status {}); is there enough memory?", count, status));
  }
  for (std::size_t k = 0; k < permutation.size(); ++k) order[k] = nodes[static_cast<std::size_t>(permutation[k])];
  return order;
}

}  // namespace bodkin::fem
