#include "fem/solid/symbolic_factor.h"

#include <algorithm>
#include <numeric>

#include "fem/solid/elimination_tree.h"

namespace bodkin::fem {

namespace {

// Supernodes during merging. Each begins as a fundamental one, a range of positions.
struct MergeTree {
  std::vector<std::uint32_t> begin;    // supernodes + 1: first positions of the fundamental supernodes
  std::vector<std::uint32_t> parent;   // by supernode; no_parent for a root
  std::vector<std::uint32_t> into;     // the supernode into which it was merged; itself if not merged
  std::vector<std::uint64_t> columns;  // nodes
  std::vector<std::uint64_t> rows;     // nodes below
  std::vector<double> zeros;           // blocks stored though they are zero

  std::size_t size() const { return parent.size(); }
  std::uint32_t find(std::uint32_t supernode) const {
    while (into[supernode] != supernode) supernode = into[supernode];
    return supernode;
  }
};

// Ranges of columns with one structure: a column joins its predecessor if that is its only child and has just one row
// more.
MergeTree fundamental_supernodes(const EliminationTree& tree) {
  const auto nodes = static_cast<std::uint32_t>(tree.parent.size());
  std::vector<std::uint32_t> children(nodes, 0), supernode_of(nodes, 0);
  for (const std::uint32_t parent : tree.parent)
    if (parent != no_parent) ++children[parent];
  MergeTree merge;
  for (std::uint32_t j = 0; j < nodes; ++j) {
    const bool joins = j > 0 && tree.parent[j - 1] == j && children[j] == 1 && tree.count[j - 1] == tree.count[j] + 1;
    if (!joins) merge.begin.push_back(j);
    supernode_of[j] = static_cast<std::uint32_t>(merge.begin.size() - 1);
  }
  const std::size_t count = merge.begin.size();
  merge.begin.push_back(nodes);
  merge.into.resize(count);
  std::iota(merge.into.begin(), merge.into.end(), 0U);
  merge.zeros.assign(count, 0.0);
  for (std::size_t s = 0; s < count; ++s) {
    const std::uint32_t top = merge.begin[s + 1] - 1;
    merge.columns.push_back(merge.begin[s + 1] - merge.begin[s]);
    merge.rows.push_back(tree.count[top] - 1);
    merge.parent.push_back(tree.parent[top] == no_parent ? no_parent : supernode_of[tree.parent[top]]);
  }
  return merge;
}

// Whether a supernode of `columns` nodes may hold this share of zeros.
bool worth_its_zeros(std::uint64_t columns, double share) {
  const std::uint64_t equations = 3 * columns;
  if (equations <= 16) return share < 0.8;
  if (equations <= 64) return share < 0.15;
  return share < 0.05;
}

// Merges children into their parents, lowest first.
void merge_supernodes(MergeTree& merge) {
  const auto size = [](double columns, double rows) { return columns * (columns + 1.0) / 2.0 + columns * rows; };
  for (std::uint32_t child = 0; child < merge.size(); ++child) {
    if (merge.parent[child] == no_parent) continue;
    const std::uint32_t parent = merge.find(merge.parent[child]);
    const auto c = static_cast<double>(merge.columns[child]), p = static_cast<double>(merge.columns[parent]);
    const auto below_c = static_cast<double>(merge.rows[child]), below_p = static_cast<double>(merge.rows[parent]);
    const double together = size(c + p, below_p);
    const double zeros =
        together - (size(c, below_c) - merge.zeros[child]) - (size(p, below_p) - merge.zeros[parent]);
    if (!worth_its_zeros(merge.columns[child] + merge.columns[parent], zeros / together)) continue;
    merge.into[child] = parent;
    merge.columns[parent] += merge.columns[child];
    merge.zeros[parent] = zeros;
  }
}

// The remaining supernodes, each after its subtrees, which are in the order that needs the smallest stack (Liu 1986):
// first the subtree whose peak is highest above its remainder.
std::vector<std::uint32_t> smallest_stack_order(const MergeTree& merge) {
  std::vector<std::vector<std::uint32_t>> children(merge.size());
  std::vector<double> peak(merge.size(), 0.0), left(merge.size(), 0.0);
  std::vector<std::uint32_t> roots;
  for (std::uint32_t s = 0; s < merge.size(); ++s) {
    if (merge.into[s] != s) continue;
    auto& mine = children[s];  // complete: children have smaller numbers
    std::stable_sort(mine.begin(), mine.end(), [&peak, &left](std::uint32_t a, std::uint32_t b) {
      return peak[a] - left[a] > peak[b] - left[b];
    });
    double waiting = 0.0;
    for (const std::uint32_t child : mine) {
      peak[s] = std::max(peak[s], waiting + peak[child]);
      waiting += left[child];
    }
    const auto rows = static_cast<double>(merge.rows[s]);
    peak[s] = std::max(peak[s], waiting + rows * rows);
    left[s] = rows * rows / 2.0;
    if (merge.parent[s] == no_parent)
      roots.push_back(s);
    else
      children[merge.find(merge.parent[s])].push_back(s);
  }
  std::stable_sort(roots.begin(), roots.end(), [&peak, &left](std::uint32_t a, std::uint32_t b) {
    return peak[a] - left[a] > peak[b] - left[b];
  });
  std::vector<std::uint32_t> order, waiting(roots);
  while (!waiting.empty()) {  // parents before children, the last first; then reversed
    const std::uint32_t s = waiting.back();
    waiting.pop_back();
    order.push_back(s);
    waiting.insert(waiting.end(), children[s].begin(), children[s].end());
  }
  std::reverse(order.begin(), order.end());
  return order;
}

// Renumbers the columns in the order of the merged supernodes.
void renumber(const MergeTree& merge, const std::vector<std::uint32_t>& supernode_order,
              const std::vector<std::uint32_t>& node_at, SymbolicFactor& result) {
  std::vector<std::vector<std::uint32_t>> parts(merge.size());
  for (std::uint32_t s = 0; s < merge.size(); ++s) parts[merge.find(s)].push_back(s);  // ascending: children first
  for (const std::uint32_t s : supernode_order) {
    Supernode supernode;
    supernode.first = static_cast<std::uint32_t>(result.order.size());
    supernode.columns = static_cast<std::uint32_t>(merge.columns[s]);
    supernode.rows = static_cast<std::uint32_t>(merge.rows[s]);
    result.supernodes.push_back(supernode);
    for (const std::uint32_t part : parts[s])
      result.order.insert(result.order.end(), node_at.begin() + merge.begin[part],
                          node_at.begin() + merge.begin[part + 1]);
  }
}

// The rows of every supernode: later neighbours of its columns, and rows from its children.
void find_rows(const NodeGraph& graph, SymbolicFactor& result) {
  const auto nodes = static_cast<std::uint32_t>(result.order.size());
  std::vector<std::uint32_t> supernode_of(nodes), seen(nodes, no_parent);
  std::vector<std::vector<std::uint32_t>> children(result.supernodes.size());
  for (std::uint32_t s = 0; s < result.supernodes.size(); ++s)
    for (std::uint32_t k = 0; k < result.supernodes[s].columns; ++k) supernode_of[result.supernodes[s].first + k] = s;
  for (std::uint32_t s = 0; s < result.supernodes.size(); ++s) {
    Supernode& supernode = result.supernodes[s];
    const std::uint32_t end = supernode.first + supernode.columns;
    supernode.rows_at = result.rows.size();
    const auto add = [&](std::uint32_t row) {
      if (row < end || seen[row] == s) return;
      seen[row] = s;
      result.rows.push_back(row);
    };
    for (std::uint32_t k = supernode.first; k < end; ++k) {
      const std::uint32_t node = result.order[k];
      for (std::size_t i = graph.start[node]; i < graph.start[node + 1]; ++i)
        add(result.position[graph.neighbours[i]]);
    }
    for (const std::uint32_t child : children[s]) {
      const Supernode& from = result.supernodes[child];
      for (std::size_t i = from.rows_at; i < from.rows_at + from.rows; ++i) add(result.rows[i]);
    }
    supernode.children = static_cast<std::uint32_t>(children[s].size());
    supernode.rows = static_cast<std::uint32_t>(result.rows.size() - supernode.rows_at);
    std::sort(result.rows.begin() + static_cast<std::ptrdiff_t>(supernode.rows_at), result.rows.end());
    if (supernode.rows > 0) children[supernode_of[result.rows[supernode.rows_at]]].push_back(s);
  }
}

void add_up(SymbolicFactor& result) {
  std::vector<std::size_t> waiting;  // contents of the supernodes on the stack
  std::size_t held = 0;
  for (std::size_t s = 0; s < result.supernodes.size(); ++s) {
    Supernode& supernode = result.supernodes[s];
    supernode.panel_at = result.factor_size;
    result.factor_size += supernode.panel_size();
    const bool is_last = result.last > 0 && s + 1 == result.supernodes.size();
    if (!is_last) result.largest_panel = std::max(result.largest_panel, supernode.panel_size());
    const std::size_t below = 3 * std::size_t{supernode.rows};
    result.stack_size = std::max(result.stack_size, held + below * below);
    for (std::uint32_t child = 0; child < supernode.children; ++child) {
      held -= waiting.back();
      waiting.pop_back();
    }
    if (supernode.rows > 0) waiting.push_back(supernode.update_size());
    if (supernode.rows > 0) held += supernode.update_size();
    result.operations += supernode.operations();
  }
}

}  // namespace

std::size_t SymbolicFactor::bytes(bool keep_field) const noexcept {
  const std::size_t panels = keep_field ? factor_size : largest_panel + last_size();
  const std::size_t lists =
      4 * (order.size() + position.size() + rows.size()) + sizeof(Supernode) * supernodes.size();
  constexpr std::size_t per_block = sizeof(Mat3) + 4 + 24;  // with its row, and its place in the assembly of fronts
  return sizeof(double) * (panels + std::max(stack_size, last_size())) + per_block * blocks + 2 * lists;
}

SymbolicFactor analyse(const NodeGraph& graph, std::span<const std::uint32_t> last) {
  std::vector<std::uint32_t> node_at = nested_dissection(graph, last);
  const auto free = static_cast<std::uint32_t>(node_at.size() - last.size());
  const EliminationTree tree = elimination_tree(graph, node_at, free);
  MergeTree merge = fundamental_supernodes(tree);
  merge_supernodes(merge);

  SymbolicFactor result;
  result.last = static_cast<std::uint32_t>(last.size());
  result.blocks = graph.neighbours.size() / 2 + graph.nodes();
  result.order.reserve(node_at.size());
  renumber(merge, smallest_stack_order(merge), node_at, result);
  if (!last.empty()) {
    result.supernodes.push_back({.first = free, .columns = result.last});
    result.order.insert(result.order.end(), last.begin(), last.end());
  }
  result.position.resize(result.order.size());
  for (std::uint32_t k = 0; k < result.order.size(); ++k) result.position[result.order[k]] = k;
  find_rows(graph, result);
  add_up(result);
  return result;
}

}  // namespace bodkin::fem
