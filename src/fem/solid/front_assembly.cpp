#include "fem/solid/front_assembly.h"

#include <algorithm>

namespace bodkin::fem {

FrontAssembly::FrontAssembly(const BlockMatrix& matrix, const SymbolicFactor& symbolic)
    : matrix_(matrix), symbolic_(symbolic), start_(std::size_t{matrix.nodes} + 1, 0), place_(matrix.nodes, 0) {
  const auto earlier = [&symbolic](std::uint32_t a, std::uint32_t b) {
    return std::min(symbolic.position[a], symbolic.position[b]);
  };
  for (std::uint32_t column = 0; column < matrix.nodes; ++column)
    for (std::size_t i = matrix.start[column]; i < matrix.start[column + 1]; ++i)
      ++start_[earlier(column, matrix.row[i]) + 1];
  for (std::size_t k = 0; k < matrix.nodes; ++k) start_[k + 1] += start_[k];
  entries_.resize(matrix.row.size());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for (std::uint32_t column = 0; column < matrix.nodes; ++column) {
    for (std::size_t i = matrix.start[column]; i < matrix.start[column + 1]; ++i) {
      const std::uint32_t at_column = symbolic.position[column], at_row = symbolic.position[matrix.row[i]];
      entries_[next[std::min(at_column, at_row)]++] = {std::max(at_column, at_row), at_row < at_column, i};
    }
  }
}

void FrontAssembly::place_rows(const Supernode& supernode) {
  for (std::uint32_t k = 0; k < supernode.columns; ++k) place_[supernode.first + k] = k;
  for (std::uint32_t k = 0; k < supernode.rows; ++k)
    place_[symbolic_.rows[supernode.rows_at + k]] = supernode.columns + k;
}

void FrontAssembly::add_matrix(const Front& front) {
  place_rows(*front.supernode);
  for (std::uint32_t k = 0; k < front.supernode->columns; ++k) {
    const std::uint32_t column = front.supernode->first + k;
    for (std::size_t e = start_[column]; e < start_[column + 1]; ++e) {
      const Mat3& block = matrix_.block[entries_[e].block];
      double* to = front.panel + 3 * std::size_t{k} * front.height() + 3 * std::size_t{place_[entries_[e].row]};
      for (Eigen::Index j = 0; j < 3; ++j, to += front.height())
        for (Eigen::Index i = 0; i < 3; ++i) to[i] += entries_[e].transposed ? block(j, i) : block(i, j);
    }
  }
}

void FrontAssembly::add_update(const Front& front, const Supernode& child, const double* update) {
  runs_.clear();
  for (std::size_t k = 0; k < child.rows; ++k) {
    const std::size_t to = 3 * std::size_t{place_[symbolic_.rows[child.rows_at + k]]};
    if (!runs_.empty() && runs_.back().to + runs_.back().length == to)
      runs_.back().length += 3;
    else
      runs_.push_back({3 * k, to, 3});
  }
  const std::size_t width = front.width(), height = 3 * std::size_t{child.rows};
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    for (std::size_t c = 0; c < runs_[r].length; ++c) {
      const std::size_t from = runs_[r].from + c, to = runs_[r].to + c;  // the column in the child and in the front
      // The column from the front's row `top` on; the child's begins at its own diagonal.
      const std::size_t top = to < width ? 0 : width;
      double* const column =
          to < width ? front.panel + to * front.height() : front.update + (to - width) * front.update_height();
      for (std::size_t i = 0; i < runs_[r].length - c; ++i) column[to - top + i] += update[i];
      for (std::size_t s = r + 1; s < runs_.size(); ++s) {
        double* const rows = column + (runs_[s].to - top);
        const double* const more = update + (runs_[s].from - from);
        for (std::size_t i = 0; i < runs_[s].length; ++i) rows[i] += more[i];
      }
      update += height - from;
    }
  }
}

}  // namespace bodkin::fem
