#include "fem/solid/dense_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace bodkin::fem {

namespace {

constexpr std::size_t plain_rows = 4, plain_columns = 4;

void add_product_plain(std::size_t depth, const double* a, const double* b, double* c, std::size_t lead) {
  for (std::size_t k = 0; k < depth; ++k, a += plain_rows, b += plain_columns)
    for (std::size_t j = 0; j < plain_columns; ++j)
      for (std::size_t i = 0; i < plain_rows; ++i) c[j * lead + i] = std::fma(a[i], b[j], c[j * lead + i]);
}

void solve_strip_plain(std::size_t first, std::size_t last, const double* l, std::size_t lead_l, double* x,
                       std::size_t lead) {
  for (std::size_t j = first; j < last; ++j) {
    for (std::size_t i = 0; i < plain_rows; ++i) {
      double sum = x[j * lead + i];
      for (std::size_t k = 0; k < j; ++k) sum = std::fma(-l[k * lead_l + j], x[k * lead + i], sum);
      x[j * lead + i] = sum / l[j * lead_l + j];
    }
  }
}

#if defined(__x86_64__)

[[gnu::target("avx2,fma")]] void add_product_avx2(std::size_t depth, const double* a, const double* b, double* c,
                                                  std::size_t lead) {
  __m256d sum[4][3];
#pragma GCC unroll 4
  for (std::size_t j = 0; j < 4; ++j) {
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) sum[j][i] = _mm256_loadu_pd(c + j * lead + 4 * i);
  }
  for (std::size_t k = 0; k < depth; ++k, a += 12, b += 4) {
    const __m256d a0 = _mm256_loadu_pd(a), a1 = _mm256_loadu_pd(a + 4), a2 = _mm256_loadu_pd(a + 8);
#pragma GCC unroll 4
    for (std::size_t j = 0; j < 4; ++j) {
      const __m256d factor = _mm256_broadcast_sd(b + j);
      sum[j][0] = _mm256_fmadd_pd(a0, factor, sum[j][0]);
      sum[j][1] = _mm256_fmadd_pd(a1, factor, sum[j][1]);
      sum[j][2] = _mm256_fmadd_pd(a2, factor, sum[j][2]);
    }
  }
#pragma GCC unroll 4
  for (std::size_t j = 0; j < 4; ++j) {
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) _mm256_storeu_pd(c + j * lead + 4 * i, sum[j][i]);
  }
}

[[gnu::target("avx2,fma")]] void solve_strip_avx2(std::size_t first, std::size_t last, const double* l,
                                                  std::size_t lead_l, double* x, std::size_t lead) {
  for (std::size_t j = first; j < last; ++j) {
    __m256d sum = _mm256_loadu_pd(x + j * lead), other = _mm256_loadu_pd(x + j * lead + 4);
    for (std::size_t k = 0; k < j; ++k) {
      const __m256d factor = _mm256_broadcast_sd(l + k * lead_l + j);
      sum = _mm256_fnmadd_pd(factor, _mm256_loadu_pd(x + k * lead), sum);
      other = _mm256_fnmadd_pd(factor, _mm256_loadu_pd(x + k * lead + 4), other);
    }
    const __m256d pivot = _mm256_broadcast_sd(l + j * lead_l + j);
    _mm256_storeu_pd(x + j * lead, _mm256_div_pd(sum, pivot));
    _mm256_storeu_pd(x + j * lead + 4, _mm256_div_pd(other, pivot));
  }
}

[[gnu::target("avx512f")]] void add_product_avx512(std::size_t depth, const double* a, const double* b, double* c,
                                                   std::size_t lead) {
  __m512d sum[8][3];
#pragma GCC unroll 8
  for (std::size_t j = 0; j < 8; ++j) {
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) sum[j][i] = _mm512_loadu_pd(c + j * lead + 8 * i);
  }
  for (std::size_t k = 0; k < depth; ++k, a += 24, b += 8) {
    const __m512d a0 = _mm512_loadu_pd(a), a1 = _mm512_loadu_pd(a + 8), a2 = _mm512_loadu_pd(a + 16);
#pragma GCC unroll 8
    for (std::size_t j = 0; j < 8; ++j) {
      const __m512d factor = _mm512_set1_pd(b[j]);
      sum[j][0] = _mm512_fmadd_pd(a0, factor, sum[j][0]);
      sum[j][1] = _mm512_fmadd_pd(a1, factor, sum[j][1]);
      sum[j][2] = _mm512_fmadd_pd(a2, factor, sum[j][2]);
    }
  }
#pragma GCC unroll 8
  for (std::size_t j = 0; j < 8; ++j) {
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) _mm512_storeu_pd(c + j * lead + 8 * i, sum[j][i]);
  }
}

[[gnu::target("avx512f")]] void solve_strip_avx512(std::size_t first, std::size_t last, const double* l,
                                                   std::size_t lead_l, double* x, std::size_t lead) {
  for (std::size_t j = first; j < last; ++j) {
    __m512d sum = _mm512_loadu_pd(x + j * lead), other = _mm512_loadu_pd(x + j * lead + 8);
    for (std::size_t k = 0; k < j; ++k) {
      const __m512d factor = _mm512_set1_pd(l[k * lead_l + j]);
      sum = _mm512_fnmadd_pd(factor, _mm512_loadu_pd(x + k * lead), sum);
      other = _mm512_fnmadd_pd(factor, _mm512_loadu_pd(x + k * lead + 8), other);
    }
    const __m512d pivot = _mm512_set1_pd(l[j * lead_l + j]);
    _mm512_storeu_pd(x + j * lead, _mm512_div_pd(sum, pivot));
    _mm512_storeu_pd(x + j * lead + 8, _mm512_div_pd(other, pivot));
  }
}

#endif

struct Choice {
  std::array<DenseTiles, 3> tiles;
  std::size_t count = 0;

  Choice() noexcept {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f"))
      tiles[count++] = {"avx512", 24, 8, add_product_avx512, 16, solve_strip_avx512};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
      tiles[count++] = {"avx2", 12, 4, add_product_avx2, 8, solve_strip_avx2};
#endif
    tiles[count++] = {"plain", plain_rows, plain_columns, add_product_plain, plain_rows, solve_strip_plain};
  }
};

}  // namespace

std::span<const DenseTiles> dense_tiles() noexcept {
  static const Choice choice;
  return {choice.tiles.data(), choice.count};
}

double pivot_of(double a, const double* b, std::size_t count, std::size_t step) noexcept {
  for (std::size_t k = 0; k < count; ++k) a = std::fma(-b[k * step], b[k * step], a);
  return a > 0.0 && std::isfinite(a) ? std::sqrt(a) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace bodkin::fem
