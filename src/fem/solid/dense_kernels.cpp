#include "fem/solid/dense_kernels.h"

#include <algorithm>

#include <cblas-openblas.h>

// LAPACK as OpenBLAS has it; Debian's package brings no header for it. Arguments as in the Fortran reference.
extern "C" {
void dpotrf_(const char* triangle, const int* n, double* a, const int* lead, int* info, std::size_t triangle_length);
}

namespace bodkin::fem {

namespace {

constexpr std::size_t mirror_tile = 32;  // rows and columns that stay in the cache together

int as_int(std::size_t value) {
  return static_cast<int>(value);
}

}  // namespace

void use_one_thread_each() {
  if (openblas_get_num_threads() != 1) openblas_set_num_threads(1);
}

std::size_t cholesky(std::size_t size, double* a, std::size_t lead) {
  const int n = as_int(size), distance = as_int(lead);
  int info = 0;
  dpotrf_("L", &n, a, &distance, &info, 1);
  return info == 0 ? size : static_cast<std::size_t>(info - 1);
}

void solve_right_transposed(std::size_t rows, std::size_t size, const double* l, std::size_t lead, double* b,
                            std::size_t lead_b) {
  cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, as_int(rows), as_int(size), 1.0, l,
              as_int(lead), b, as_int(lead_b));
}

void subtract_outer_product(std::size_t rows, std::size_t size, const double* b, std::size_t lead_b, double* c,
                            std::size_t lead_c) {
  cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, as_int(rows), as_int(size), -1.0, b, as_int(lead_b), 1.0, c,
              as_int(lead_c));
}

void solve_lower(std::size_t size, std::size_t columns, const double* l, std::size_t lead, double* x,
                 std::size_t lead_x) {
  if (columns == 1) {
    cblas_dtrsv(CblasColMajor, CblasLower, CblasNoTrans, CblasNonUnit, as_int(size), l, as_int(lead), x, 1);
    return;
  }
  cblas_dtrsm(CblasColMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, as_int(size), as_int(columns), 1.0, l,
              as_int(lead), x, as_int(lead_x));
}

void solve_lower_transposed(std::size_t size, std::size_t columns, const double* l, std::size_t lead, double* x,
                            std::size_t lead_x) {
  if (columns == 1) {
    cblas_dtrsv(CblasColMajor, CblasLower, CblasTrans, CblasNonUnit, as_int(size), l, as_int(lead), x, 1);
    return;
  }
  cblas_dtrsm(CblasColMajor, CblasLeft, CblasLower, CblasTrans, CblasNonUnit, as_int(size), as_int(columns), 1.0, l,
              as_int(lead), x, as_int(lead_x));
}

void multiply(std::size_t rows, std::size_t size, std::size_t columns, const double* a, std::size_t lead,
              const double* x, std::size_t lead_x, double* y, std::size_t lead_y) {
  if (columns == 1) {
    cblas_dgemv(CblasColMajor, CblasNoTrans, as_int(rows), as_int(size), 1.0, a, as_int(lead), x, 1, 0.0, y, 1);
    return;
  }
  cblas_dgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, as_int(rows), as_int(columns), as_int(size), 1.0, a,
              as_int(lead), x, as_int(lead_x), 0.0, y, as_int(lead_y));
}

void subtract_transposed_product(std::size_t rows, std::size_t size, std::size_t columns, const double* a,
                                 std::size_t lead, const double* x, std::size_t lead_x, double* y,
                                 std::size_t lead_y) {
  if (columns == 1) {
    cblas_dgemv(CblasColMajor, CblasTrans, as_int(rows), as_int(size), -1.0, a, as_int(lead), x, 1, 1.0, y, 1);
    return;
  }
  cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, as_int(size), as_int(columns), as_int(rows), -1.0, a,
              as_int(lead), x, as_int(lead_x), 1.0, y, as_int(lead_y));
}

void subtract_product_transposed(std::size_t rows, std::size_t size, std::size_t columns, const double* a,
                                 std::size_t lead_a, const double* b, std::size_t lead_b, double* c,
                                 std::size_t lead_c) {
  cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, as_int(rows), as_int(columns), as_int(size), -1.0, a,
              as_int(lead_a), b, as_int(lead_b), 1.0, c, as_int(lead_c));
}

void multiply_transposed(std::size_t size, std::size_t rows, std::size_t columns, const double* a, std::size_t lead_a,
                         const double* b, std::size_t lead_b, double* c, std::size_t lead_c) {
  cblas_dgemm(CblasColMajor, CblasTrans, CblasNoTrans, as_int(rows), as_int(columns), as_int(size), 1.0, a,
              as_int(lead_a), b, as_int(lead_b), 0.0, c, as_int(lead_c));
}

void mirror_lower(std::size_t size, double* a, std::size_t lead) {
  for (std::size_t left = 0; left < size; left += mirror_tile)
    for (std::size_t top = left; top < size; top += mirror_tile)
      for (std::size_t column = left; column < std::min(left + mirror_tile, size); ++column)
        for (std::size_t row = std::max(top, column + 1); row < std::min(top + mirror_tile, size); ++row)
          a[row * lead + column] = a[column * lead + row];
}

void mirror_upper(std::size_t size, double* a, std::size_t lead, std::size_t from, std::size_t to) {
  for (std::size_t left = from; left < to; left += mirror_tile)
    for (std::size_t top = left; top < size; top += mirror_tile)
      for (std::size_t column = left; column < std::min(left + mirror_tile, to); ++column)
        for (std::size_t row = std::max(top, column + 1); row < std::min(top + mirror_tile, size); ++row)
          a[column * lead + row] = a[row * lead + column];
}

}  // namespace bodkin::fem
