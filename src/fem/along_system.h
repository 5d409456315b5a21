#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace bodkin {

// What is left of the equations of a shaft when the forces that hold it firmly across have been eliminated:
//
//   Sigma f = g,   Sigma = A_aa - V^T V,   V = U^-T A_ca,   U^T U = A_cc
//
// A compliance, mm/N; c what is held firmly across, the rows here; a the columns: first some that are never held,
// as those by which a shaft bends outside, then one for every node, its force along the needle. The nodes that stick
// have the triangle T with T^T T = Sigma of them.
//
// Columns come and go at the end, and so do the rows, by twos. Sigma is kept for every number of rows, so that rows
// that go leave what was there before them, to the bit, and nothing piles up. That takes 8/3 n^3 bytes for n nodes
// (12 MB for 160). T is factorised anew when rows come or go. Memory is taken at construction; nothing
// else throws, allocates or locks.
class AlongSystem {
 public:
  // `always`: columns that are never held. There may be two nodes more than pairs of rows.
  AlongSystem(std::size_t most_nodes, std::size_t always);

  // No nodes, no rows, nothing sticks; the first columns are zero.
  void begin() noexcept;
  // A further node. `eliminated`: its column of V, rows() numbers. `own`: its column of A_aa, from the first node to
  // itself. What it has to do with the columns that are never held comes from the rows alone. The caller sees to it
  // that there is room.
  void push_node(std::span<const double> eliminated, std::span<const double> own) noexcept;
  void pop_node() noexcept;
  // Two further rows of V, for all columns.
  void push_rows(std::span<const double> first, std::span<const double> second) noexcept;
  void pop_rows() noexcept;

  std::size_t nodes() const noexcept { return columns_ - always_; }
  std::size_t columns() const noexcept { return columns_; }
  std::size_t stride() const noexcept { return stride_; }
  std::size_t rows() const noexcept { return 2 * level_; }
  double sigma(std::size_t row, std::size_t column) const noexcept { return level_row(level_, row)[column]; }

  // values += V^T factors, and rows() products = V values (room for padded(rows())).
  void add_transposed(const double* factors, double* values) noexcept;
  void multiply(const double* values, double* products) const noexcept;
  // values += Sigma forces, of the columns whose force is not 0.
  void add_displacements(const double* forces, double* values) noexcept;

  // A node sticks: false when T would be singular, and nothing changed. It lets go. The first `count` nodes stick and
  // no others, but for those that cannot.
  bool hold(std::size_t node) noexcept;
  void let_go(std::size_t node) noexcept;
  void hold_first(std::size_t count) noexcept;
  bool holds(std::size_t node) const noexcept { return held_[node] != 0; }
  // How many numbers of T lie behind a node that sticks: what letting it go costs.
  std::size_t release_cost(std::size_t node) const noexcept;
  // Makes T true where rows have come or gone; whether it has changed since the last call.
  bool refresh() noexcept;
  // The nodes that stick, in the order of T.
  std::span<const std::uint32_t> sticking() const noexcept { return {order_.data(), sticking_}; }
  // T^-T times each of `count` vectors, stride() apart, and T^-1 times one, over sticking().
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
  bool border(std::size_t node) noexcept;
  void factorise() noexcept;
  std::size_t place(std::size_t node) const noexcept;

  std::size_t always_, stride_;
  std::vector<double> eliminated_;       // V, rows x stride_
  std::vector<double> sigma_;            // for every pair of rows, one after another
  std::vector<std::size_t> level_at_;    // where each begins
  std::vector<double> own_;              // by node: its own A_aa
  std::vector<double> triangle_;         // T, stride_ x stride_
  std::vector<double> scratch_;          // stride_
  std::vector<double> least_;            // pivots of T
  std::vector<const double*> gathered_;  // rows that are added together
  std::vector<double> factors_;
  std::vector<std::uint32_t> order_;  // the nodes of T
  std::vector<std::uint8_t> held_;    // by node
  std::size_t columns_ = 0, level_ = 0, sticking_ = 0;
  bool stale_ = false, changed_ = true;
};

}  // namespace bodkin
