#pragma once

#include <cstddef>

namespace bodkin {

// The dense linear algebra of the factorisation, by OpenBLAS. Matrices are column-major; `lead` is the distance
// between columns. Only the lower triangle of a symmetric or triangular matrix is read or written.

// How many threads OpenBLAS uses while this lives; the number before is restored after. OpenBLAS has one such number
// for the whole program.
class DenseThreads {
 public:
  explicit DenseThreads(int threads);
  ~DenseThreads();
  DenseThreads(const DenseThreads&) = delete;
  DenseThreads& operator=(const DenseThreads&) = delete;

 private:
  int before_;
};

// a := L with a = L L^T. Returns size, or the first column that has no positive pivot.
std::size_t cholesky(std::size_t size, double* a, std::size_t lead);

// b := b L^-T, rows x size.
void solve_right_transposed(std::size_t rows, std::size_t size, const double* l, std::size_t lead, double* b,
                            std::size_t lead_b);

// c := c - b b^T, c is rows x rows, b rows x size.
void subtract_outer_product(std::size_t rows, std::size_t size, const double* b, std::size_t lead_b, double* c,
                            std::size_t lead_c);

// x := L^-1 x and x := L^-T x, x is size x columns.
void solve_lower(std::size_t size, std::size_t columns, const double* l, std::size_t lead, double* x,
                 std::size_t lead_x);
void solve_lower_transposed(std::size_t size, std::size_t columns, const double* l, std::size_t lead, double* x,
                            std::size_t lead_x);

// y := a x, y is rows x columns, a rows x size; and y := y - a^T x, y is size x columns.
void multiply(std::size_t rows, std::size_t size, std::size_t columns, const double* a, std::size_t lead,
              const double* x, std::size_t lead_x, double* y, std::size_t lead_y);
void subtract_transposed_product(std::size_t rows, std::size_t size, std::size_t columns, const double* a,
                                 std::size_t lead, const double* x, std::size_t lead_x, double* y,
                                 std::size_t lead_y);

// The upper triangle becomes the mirror of the lower.
void mirror_lower(std::size_t size, double* a, std::size_t lead);

// l := (L L^T)^-1, both triangles.
void invert_from_cholesky(std::size_t size, double* l, std::size_t lead);

}  // namespace bodkin
