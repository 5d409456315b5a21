#pragma once

#include <cstddef>

namespace bodkin::triangle {

// The inner loops of an upper triangle U by rows. Each is compiled for plain x86-64 and for AVX2, where the compiler
// can (GCC), and the processor's own is chosen at start-up; sums have one fixed order, so both give the same bits.

// Rows are worked on eight at a time.
constexpr std::size_t padded(std::size_t count) {
  return (count + 7) / 8 * 8;
}

// U and how much of it is in use. There is memory for padded(rows) rows of `stride` numbers, which is padded too;
// what stands below the diagonal or beyond `rows` in a row is finite.
struct Upper {
  const double* numbers;
  std::size_t stride;
  std::size_t rows;
};

// U^-T times `count` (1 to 3) columns, `stride` apart, in place; room for padded(rows) numbers in each.
void solve_transposed(const Upper& upper, double* columns, std::size_t count) noexcept;
// U^-1 times `values`, in place; room for padded(rows), of which those beyond rows become 0.
void solve(const Upper& upper, double* values) noexcept;
// Givens rotation of two rows of `count` numbers that makes the first of `other` zero: `to` is what becomes of
// `from`, which may be the same.
void rotate(const double* from, double* other, double* to, std::size_t count) noexcept;

}  // namespace bodkin::triangle
