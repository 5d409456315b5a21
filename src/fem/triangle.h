#pragma once

#include <cstddef>

namespace bodkin::triangle {

// The inner loops of an upper triangle U by rows, and of other rows beside it. Each is compiled for plain x86-64 and
// for AVX2, where the compiler can (GCC), and the processor's own is chosen at start-up; sums have one fixed order,
// so both give the same bits.

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

// U^-T times `count` columns, `stride` apart, in place; room for padded(rows) numbers in each.
void solve_transposed(const Upper& upper, double* columns, std::size_t count) noexcept;
// U^-1 times `values`, in place; room for padded(rows), of which those beyond rows become 0.
void solve(const Upper& upper, double* values) noexcept;
// Givens rotation of two rows of `count` numbers that makes the first of `other` zero: `to` is what becomes of
// `from`, which may be the same.
void rotate(const double* from, double* other, double* to, std::size_t count) noexcept;
// A symmetric positive definite matrix, its upper triangle in `numbers`, becomes U with U^T U = it, in place. Row r
// is sound while its pivot is above least[r]; returns how many rows were, and leaves the others unfinished.
std::size_t factorise(double* numbers, std::size_t stride, std::size_t rows, const double* least) noexcept;

// Sum of a[j] b[j] over `count` numbers, in an order of its own.
double product(const double* a, const double* b, std::size_t count) noexcept;
// values[j] += factors[r] rows[r][j], summed over `count` rows, for j below padded(columns).
void add_rows(const double* const* rows, const double* factors, std::size_t count, double* values,
              std::size_t columns) noexcept;
// products[r] = sum over rows[r * stride + j] values[j], j below padded(columns), for padded(count) rows.
void multiply(const double* rows, std::size_t stride, std::size_t count, const double* values, std::size_t columns,
              double* products) noexcept;
// to = from - a a^T - b b^T, size x padded(size), rows `from_stride` and `to_stride` apart.
void subtract_squares(const double* from, std::size_t from_stride, const double* a, const double* b, std::size_t size,
                      double* to, std::size_t to_stride) noexcept;

}  // namespace bodkin::triangle
