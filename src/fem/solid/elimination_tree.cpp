#include "fem/solid/elimination_tree.h"

namespace bodkin::fem {

namespace {

std::vector<std::uint32_t> positions_of(const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> position(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) position[order[k]] = k;
  return position;
}

// Liu's algorithm: each node becomes the parent of the roots that its earlier neighbours have so far.
std::vector<std::uint32_t> parents(const NodeGraph& graph, const std::vector<std::uint32_t>& order,
                                   std::uint32_t free) {
  const std::vector<std::uint32_t> position = positions_of(order);
  std::vector<std::uint32_t> parent(free, no_parent), shortcut(free, no_parent);
  for (std::uint32_t i = 0; i < free; ++i) {
    for (std::size_t e = graph.start[order[i]]; e < graph.start[order[i] + 1]; ++e) {
      std::uint32_t k = position[graph.neighbours[e]];
      while (k < i) {
        const std::uint32_t next = shortcut[k];
        shortcut[k] = i;
        if (next == no_parent) {
          parent[k] = i;
          break;
        }
        k = next;
      }
    }
  }
  return parent;
}

// Every node after its children's subtrees: result k is the k-th node.
std::vector<std::uint32_t> postorder(const std::vector<std::uint32_t>& parent) {
  const auto nodes = static_cast<std::uint32_t>(parent.size());
  std::vector<std::uint32_t> first_child(nodes, no_parent), next_sibling(nodes, no_parent), order, waiting;
  for (std::uint32_t node = nodes; node-- > 0;) {
    if (parent[node] == no_parent) continue;
    next_sibling[node] = first_child[parent[node]];
    first_child[parent[node]] = node;
  }
  for (std::uint32_t root = 0; root < nodes; ++root) {
    if (parent[root] != no_parent) continue;
    waiting.push_back(root);
    while (!waiting.empty()) {
      const std::uint32_t node = waiting.back();
      if (const std::uint32_t child = first_child[node]; child != no_parent) {
        first_child[node] = next_sibling[child];
        waiting.push_back(child);
      } else {
        order.push_back(node);
        waiting.pop_back();
      }
    }
  }
  return order;
}

}  // namespace

EliminationTree elimination_tree(const NodeGraph& graph, std::vector<std::uint32_t>& order, std::uint32_t free) {
  const std::vector<std::uint32_t> parent = parents(graph, order, free);
  const std::vector<std::uint32_t> rank = postorder(parent), place = positions_of(rank);
  EliminationTree tree;
  tree.parent.resize(free);
  std::vector<std::uint32_t> better(free);
  for (std::uint32_t k = 0; k < free; ++k) {
    better[k] = order[rank[k]];
    tree.parent[k] = parent[rank[k]] == no_parent ? no_parent : place[parent[rank[k]]];
  }
  for (std::uint32_t k = 0; k < free; ++k) order[k] = better[k];

  // Row i of the factor has the columns on the paths from its earlier neighbours up to i.
  const std::vector<std::uint32_t> position = positions_of(order);
  const auto nodes = static_cast<std::uint32_t>(order.size());
  std::vector<std::uint32_t> passed(free, no_parent);
  tree.count.assign(free, 1);
  for (std::uint32_t i = 0; i < nodes; ++i) {
    for (std::size_t e = graph.start[order[i]]; e < graph.start[order[i] + 1]; ++e) {
      for (std::uint32_t k = position[graph.neighbours[e]]; k < free && k < i && passed[k] != i; k = tree.parent[k]) {
        passed[k] = i;
        ++tree.count[k];
      }
    }
  }
  return tree;
}

}  // namespace bodkin::fem
