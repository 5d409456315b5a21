#pragma once

#include <cstddef>

namespace bodkin::fem::upper_triangular {

// Dense kernels for an upper triangular matrix U, stored by rows, and for rows of numbers in general. Each is
// compiled for plain x86-64 and for AVX2 (BODKIN_PROCESSOR_CLONES). Sums are added in a fixed order, so both give the
// same bits.

// The kernels process rows and columns in blocks of eight: the next multiple of eight.
constexpr std::size_t padded(std::size_t count) {
  return (count + 7) / 8 * 8;
}

// The leading `rows` rows and columns of U. The memory holds padded(rows) rows of `stride` numbers, `stride` a
// multiple of eight; the numbers below the diagonal and those from `rows` on in a row may be anything finite.
struct Upper {
  const double* numbers;
  std::size_t stride;
  std::size_t rows;
};

// x := U^-T x for each of `count` vectors, which begin `stride` apart and have room for padded(rows) numbers.
void solve_transposed(const Upper& upper, double* columns, std::size_t count) noexcept;
// x := U^-1 x; `values` has room for padded(rows) numbers, and those from `rows` on become 0.
void solve(const Upper& upper, double* values) noexcept;
// Applies to two rows of `count` numbers the Givens rotation that makes the first number of `other` zero. The rotated
// `from` is written to `to`, which may be `from`; the rotated `other` stays in place.
void rotate(const double* from, double* other, double* to, std::size_t count) noexcept;
// Cholesky factorisation A = U^T U in place, A symmetric and given by its upper triangle. Stops at the first row r
// whose pivot is not finite or not above least[r], and returns r; the rows from r on are then undefined. Returns
// `rows` after success.
std::size_t factorise(double* numbers, std::size_t stride, std::size_t rows, const double* least) noexcept;

// U^T U := U^T U + a a^T + b b^T, `rows` numbers each, by Givens rotations. a and b are used up.
void add_squares_to_factor(double* numbers, std::size_t stride, std::size_t rows, double* a, double* b) noexcept;
// U^T U := U^T U - a a^T - b b^T, by hyperbolic rotations in their mixed form, which is stable (Chambers 1971). Stops
// at the first row whose pivot is not finite or not above least[r], and returns false; U is then undefined.
bool subtract_squares_from_factor(double* numbers, std::size_t stride, std::size_t rows, double* a, double* b,
                                  const double* least) noexcept;

// Sum of a[j] b[j] over `count` numbers.
double product(const double* a, const double* b, std::size_t count) noexcept;
// values[j] += sum over r of factors[r] rows[r][j], for `count` rows and j < padded(columns).
void add_rows(const double* const* rows, const double* factors, std::size_t count, double* values,
              std::size_t columns) noexcept;
// products[r] = sum of rows[r * stride + j] values[j] over j < padded(columns), for r < padded(count).
void multiply(const double* rows, std::size_t stride, std::size_t count, const double* values, std::size_t columns,
              double* products) noexcept;
// to = from - a a^T - b b^T, size x padded(size); the rows of `from` and `to` are `from_stride` and `to_stride`
// apart.
void subtract_squares(const double* from, std::size_t from_stride, const double* a, const double* b, std::size_t size,
                      double* to, std::size_t to_stride) noexcept;

}  // namespace bodkin::fem::upper_triangular
