#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace bodkin::fem {

// The innermost loops of the dense linear algebra, for one instruction set. Every number is one chain of fused
// multiply-adds in a fixed order, so that all instruction sets give the same bits, and so does every way to divide
// the work. Matrices are column-major; `lead` is the distance between columns.
struct DenseTiles {
  std::string_view name;
  std::size_t rows = 0, columns = 0;  // of a tile
  // c := c + a b^T, one tile. `a` and `b` are packed: the `rows` or `columns` numbers of each of `depth` columns in
  // turn.
  void (*add_product)(std::size_t depth, const double* a, const double* b, double* c, std::size_t lead) = nullptr;
  // x := x l^-T for columns `first` to `last` of a strip of `strip` rows, the columns before `first` being solved.
  std::size_t strip = 0;
  void (*solve_strip)(std::size_t first, std::size_t last, const double* l, std::size_t lead_l, double* x,
                      std::size_t lead) = nullptr;
};

// Those that this processor has, the fastest first and one for all processors last.
std::span<const DenseTiles> dense_tiles() noexcept;

// sqrt(a - b_0^2 - b_1^2 - ...), each square by a fused multiply-add in turn; NaN where the difference is not
// positive. `step`: between two numbers of `b`.
double pivot_of(double a, const double* b, std::size_t count, std::size_t step) noexcept;

}  // namespace bodkin::fem
