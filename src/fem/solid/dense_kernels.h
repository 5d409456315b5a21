#pragma once

#include <cstddef>

#include "fem/solid/dense_tiles.h"

namespace bodkin::fem {

// The dense linear algebra of the factorisation. Matrices are column-major; `lead` is the distance between columns.
// Only the lower triangle of a symmetric or triangular matrix is read or written.
//
// The functions with `tiles` have the same bits for each of dense_tiles(), and so on every processor: each number is
// one chain of fused multiply-adds in the order of the columns. The others, for displacements that are only
// displayed, are OpenBLAS's, whose bits depend on the processor.

// Makes every call below run on its calling thread. OpenBLAS has one number of threads for the whole program, which
// stays at one from here on: its own threads wait by spinning.
void use_one_thread_each();

// a := L with a = L L^T. Returns size, or the first column without a positive pivot.
std::size_t cholesky(const DenseTiles& tiles, std::size_t size, double* a, std::size_t lead);

// b := b L^-T, rows x size.
void solve_right_transposed(const DenseTiles& tiles, std::size_t rows, std::size_t size, const double* l,
                            std::size_t lead, double* b, std::size_t lead_b);

// c := c - b b^T, c is rows x rows, b rows x size.
void subtract_outer_product(const DenseTiles& tiles, std::size_t rows, std::size_t size, const double* b,
                            std::size_t lead_b, double* c, std::size_t lead_c);

// c := c - a b^T, c is rows x columns, a rows x size, b columns x size; and c := a^T b, c is rows x columns, a
// size x rows, b size x columns.
void subtract_product_transposed(const DenseTiles& tiles, std::size_t rows, std::size_t size, std::size_t columns,
                                 const double* a, std::size_t lead_a, const double* b, std::size_t lead_b, double* c,
                                 std::size_t lead_c);
void multiply_transposed(const DenseTiles& tiles, std::size_t size, std::size_t rows, std::size_t columns,
                         const double* a, std::size_t lead_a, const double* b, std::size_t lead_b, double* c,
                         std::size_t lead_c);

// x := L^-1 x, x is size x columns.
void invert_lower_times(const DenseTiles& tiles, std::size_t size, std::size_t columns, const double* l,
                        std::size_t lead, double* x, std::size_t lead_x);

// By OpenBLAS: x := L^-1 x and x := L^-T x, x is size x columns.
void solve_lower(std::size_t size, std::size_t columns, const double* l, std::size_t lead, double* x,
                 std::size_t lead_x);
void solve_lower_transposed(std::size_t size, std::size_t columns, const double* l, std::size_t lead, double* x,
                            std::size_t lead_x);

// By OpenBLAS: y := a x, y is rows x columns, a rows x size; and y := y - a^T x, y is size x columns.
void multiply(std::size_t rows, std::size_t size, std::size_t columns, const double* a, std::size_t lead,
              const double* x, std::size_t lead_x, double* y, std::size_t lead_y);
void subtract_transposed_product(std::size_t rows, std::size_t size, std::size_t columns, const double* a,
                                 std::size_t lead, const double* x, std::size_t lead_x, double* y,
                                 std::size_t lead_y);

// The upper triangle becomes the mirror of the lower.
void mirror_lower(std::size_t size, double* a, std::size_t lead);
// Columns `from` to `to` of the lower triangle become the mirror of the upper one; the others are not changed.
void mirror_upper(std::size_t size, double* a, std::size_t lead, std::size_t from, std::size_t to);

}  // namespace bodkin::fem
