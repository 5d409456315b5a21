#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace bodkin::fem {

// The Schur complement of a shaft's contact equations: what remains for the forces along the shaft after the lateral
// contact forces have been eliminated,
//
//   Sigma f = g,   Sigma = A_aa - V^T V,   V = U^-T A_ca,   U^T U = A_cc
//
// A: compliance, mm/N. c: the lateral contact constraints, two for each node ("rows" below). a: the "columns": first
// `always` columns that take part at every number of rows and never stick, such as the bending of the shaft outside
// the tissue, then one for each node, its force along the needle. The nodes in stiction have the Cholesky factor T,
// T^T T = Sigma restricted to them.
//
// Columns and pairs of rows are added and removed at the end. Sigma is kept for every number of rows, so removing
// rows restores the former numbers to the bit and rounding errors do not accumulate; this takes 8/3 n^3 bytes for n
// nodes (12 MB for 160). T follows by a rank-two update where many nodes stick, and is otherwise factorised anew, as
// it is after some updates. All memory is allocated by the constructor; no other function throws, allocates or locks.
class ShaftSchurComplement {
 public:
  // `most_nodes`: capacity; there may be two nodes more than pairs of rows. `always`: as above.
  ShaftSchurComplement(std::size_t most_nodes, std::size_t always);

  // Removes all nodes and rows; the first `always` columns become zero.
  void begin() noexcept;
  // Adds a node; the caller makes sure that it fits. `eliminated`: its column of V, rows() numbers. `own`: its column
  // of A_aa from the first node to itself; its entries with the first `always` columns are zero in A.
  void push_node(std::span<const double> eliminated, std::span<const double> own) noexcept;
  void pop_node() noexcept;
  // Adds two rows of V, columns() numbers each.
  void push_rows(std::span<const double> first, std::span<const double> second) noexcept;
  void pop_rows() noexcept;

  std::size_t nodes() const noexcept { return columns_ - always_; }
  std::size_t columns() const noexcept { return columns_; }
  std::size_t stride() const noexcept { return stride_; }
  std::size_t rows() const noexcept { return 2 * level_; }
  double sigma(std::size_t row, std::size_t column) const noexcept { return level_row(level_, row)[column]; }

  // values += V^T factors; and products = V values, rows() numbers with room for padded(rows()).
  void add_transposed(const double* factors, double* values) noexcept;
  void multiply(const double* values, double* products) const noexcept;
  // values += Sigma forces, columns() numbers each.
  void add_displacements(const double* forces, double* values) noexcept;

  // Puts a node into stiction. Returns false, and changes nothing, if it is in stiction already or T would become
  // singular.
  bool stick(std::size_t node) noexcept;
  // Releases a node from stiction; no effect on a sliding one.
  void release(std::size_t node) noexcept;
  // The first `count` nodes stick and all others slide. A node with which T would be singular slides after refresh().
  void stick_first(std::size_t count) noexcept;
  bool sticks(std::size_t node) const noexcept { return sticks_[node] != 0; }
  // Cost of releasing a node in stiction: how many numbers of T have to be rotated.
  std::size_t release_cost(std::size_t node) const noexcept;
  // Brings T up to date after rows have been added or removed, or nodes made to stick. Returns whether T has changed
  // since the last call.
  bool refresh() noexcept;
  // The nodes in stiction, in the order of T's rows.
  std::span<const std::uint32_t> sticking() const noexcept { return {order_.data(), sticking_}; }
  // x := T^-T x for each of `count` vectors over sticking(), which begin stride() apart; and x := T^-1 x for one.
  void forward(double* vectors, std::size_t count) const noexcept;
  void backward(double* values) const noexcept;

 private:
  double* level_row(std::size_t level, std::size_t row) noexcept {
    return sigma_.data() + level_at_[level] + row * level_stride(level);
  }
  const double* level_row(std::size_t level, std::size_t row) const noexcept {
    return sigma_.data() + level_at_[level] + row * level_stride(level);
  }
  std::size_t level_stride(std::size_t level) const noexcept;
  bool add_column(std::size_t node) noexcept;
  void factorise() noexcept;
  void update_factor(bool rows_added) noexcept;
  std::size_t row_of(std::size_t node) const noexcept;

  std::size_t always_, stride_;
  std::vector<double> eliminated_;       // V, rows x stride_
  std::vector<double> sigma_;            // for each number of pairs of rows ("level"), one after another
  std::vector<std::size_t> level_at_;    // by level: where its Sigma begins
  std::vector<double> own_;              // by node: its diagonal entry of A_aa
  std::vector<double> triangle_;         // T, stride_ x stride_
  std::vector<double> scratch_;          // 2 x stride_
  std::vector<double> least_;            // by row of T: least pivot
  std::vector<const double*> gathered_;  // rows to be added together
  std::vector<double> factors_;          // of gathered_
  std::vector<std::uint32_t> order_;     // by row of T: its node
  std::vector<std::uint8_t> sticks_;     // by node
  std::size_t columns_ = 0, level_ = 0, sticking_ = 0;
  int updates_ = 0;      // of T since it was factorised
  bool stale_ = false;   // T must be recomputed for the present rows and nodes
  bool changed_ = true;  // T has changed since the last refresh()
};

}  // namespace bodkin::fem
