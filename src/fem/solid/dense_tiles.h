#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace bodkin::fem {

// The innermost loops of the dense linear algebra, for one instruction set. Every number is one chain of fused
// multiply-adds in a fixed order, so that all instruction sets and all divisions of the work give the same bits.
// Matrices are column-major; `lead` is the distance between columns.
struct DenseTiles {
  std::string_view name;
  std::size_t rows = 0, columns = 0;  // of a tile
  // c := c + a b^T, one tile. `a` and `b` are packed: the `rows` or `columns` numbers of each of `depth` columns, one
  // column after another.
  void (*add_product)(std::size_t depth, const double* a, const double* b, double* c, std::size_t lead) = nullptr;
  // x := x l^-T for columns `first` to `last` of a strip of `strip` rows; the columns before `first` are already
  // solved.
  std::size_t strip = 0;
  void (*solve_strip)(std::size_t first, std::size_t last, const double* l, std::size_t lead_l, double* x,
                      std::size_t lead) = nullptr;
};

// The tiles available on this processor, fastest first; the last works on all processors.
std::span<const DenseTiles> dense_tiles() noexcept;

// sqrt(a - b_0^2 - b_1^2 - ...), subtracting one square after another by fused multiply-add; NaN if the difference is
// not positive. `step`: distance between two numbers of `b`.
double pivot_of(double a, const double* b, std::size_t count, std::size_t step) noexcept;

}  // namespace bodkin::fem
