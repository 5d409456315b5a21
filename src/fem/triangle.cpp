#include "fem/triangle.h"

#include <algorithm>
#include <cmath>

#include "fem/processor_clones.h"

namespace bodkin::triangle {

namespace {

// Four numbers at once, wherever they lie.
using Lanes [[gnu::aligned(8), gnu::may_alias]] = double __attribute__((vector_size(32)));
constexpr std::size_t lanes = 4;
constexpr std::size_t block = 8;

// values[j] -= sum over 8 rows of rows[r * stride + j] solved[r], j in [from, to).
[[gnu::always_inline]] inline void subtract_rows(const double* rows, std::size_t stride, const double* solved,
                                                 double* values, std::size_t from, std::size_t to) noexcept {
  const double a = solved[0], b = solved[1], c = solved[2], d = solved[3];
  const double e = solved[4], f = solved[5], g = solved[6], h = solved[7];
  for (std::size_t j = from; j < to; j += lanes) {
    const double* at = rows + j;
    const auto row = [at, stride](std::size_t r) -> const Lanes& {
      return *reinterpret_cast<const Lanes*>(at + r * stride);
    };
    Lanes& value = *reinterpret_cast<Lanes*>(values + j);
    value -= ((row(0) * a + row(1) * b) + (row(2) * c + row(3) * d)) +
             ((row(4) * e + row(5) * f) + (row(6) * g + row(7) * h));
  }
}

// sums[r] = rows[r * stride + j] values[j] summed over j in [from, to), for 4 rows.
[[gnu::always_inline]] inline void four_products(const double* rows, std::size_t stride, const double* values,
                                                 std::size_t from, std::size_t to, double* sums) noexcept {
  Lanes a = {}, b = {}, c = {}, d = {};
  for (std::size_t j = from; j < to; j += lanes) {
    const Lanes value = *reinterpret_cast<const Lanes*>(values + j);
    a += *reinterpret_cast<const Lanes*>(rows + j) * value;
    b += *reinterpret_cast<const Lanes*>(rows + stride + j) * value;
    c += *reinterpret_cast<const Lanes*>(rows + 2 * stride + j) * value;
    d += *reinterpret_cast<const Lanes*>(rows + 3 * stride + j) * value;
  }
  sums[0] = (a[0] + a[1]) + (a[2] + a[3]);
  sums[1] = (b[0] + b[1]) + (b[2] + b[3]);
  sums[2] = (c[0] + c[1]) + (c[2] + c[3]);
  sums[3] = (d[0] + d[1]) + (d[2] + d[3]);
}

// Rows first to first + 4 of a matrix that is being factorised, columns j to j + 8: takes from them what the `first`
// rows above, at `above`, say of them; `pivots` is where these columns of theirs begin.
[[gnu::always_inline]] inline void subtract_above(double* rows, const double* above, std::size_t pivots,
                                                  std::size_t stride, std::size_t count, std::size_t j) noexcept {
  Lanes sums[4][2] = {};
  for (std::size_t k = 0; k < count; ++k) {
    const double* const row = above + k * stride;
    const Lanes left = *reinterpret_cast<const Lanes*>(row + j), right = *reinterpret_cast<const Lanes*>(row + j + 4);
    for (std::size_t r = 0; r < 4; ++r) {
      sums[r][0] += left * row[pivots + r];
      sums[r][1] += right * row[pivots + r];
    }
  }
  for (std::size_t r = 0; r < 4; ++r) {
    *reinterpret_cast<Lanes*>(rows + r * stride + j) -= sums[r][0];
    *reinterpret_cast<Lanes*>(rows + r * stride + j + 4) -= sums[r][1];
  }
}

}  // namespace

BODKIN_PROCESSOR_CLONES
void solve_transposed(const Upper& upper, double* columns, std::size_t count) noexcept {
  const std::size_t end = padded(upper.rows);
  for (std::size_t first = 0; first < upper.rows; first += block) {
    const std::size_t here = std::min(block, upper.rows - first);
    const double* rows = upper.numbers + first * upper.stride;
    double inverse[block] = {};
    for (std::size_t r = 0; r < here; ++r) inverse[r] = 1.0 / rows[r * upper.stride + first + r];
    for (std::size_t column = 0; column < count; ++column) {
      double* values = columns + column * upper.stride;
      double solved[block] = {};
      for (std::size_t r = 0; r < here; ++r) {
        double value = values[first + r];
        for (std::size_t above = 0; above < r; ++above) {
          value -= rows[above * upper.stride + first + r] * solved[above];
        }
        solved[r] = value * inverse[r];
      }
      std::copy_n(solved, here, values + first);
      subtract_rows(rows, upper.stride, solved, values, first + block, end);
    }
  }
}

BODKIN_PROCESSOR_CLONES
void solve(const Upper& upper, double* values) noexcept {
  const std::size_t end = padded(upper.rows);
  std::fill(values + upper.rows, values + end, 0.0);
  for (std::size_t first = end; first > 0;) {
    first -= block;
    const double* rows = upper.numbers + first * upper.stride;
    double sums[block];
    four_products(rows, upper.stride, values, first + block, end, sums);
    four_products(rows + 4 * upper.stride, upper.stride, values, first + block, end, sums + 4);
    const std::size_t here = std::min(block, upper.rows - first);
    double inverse[block] = {};
    for (std::size_t r = 0; r < here; ++r) inverse[r] = 1.0 / rows[r * upper.stride + first + r];
    for (std::size_t r = here; r > 0;) {
      --r;
      const double* row = rows + r * upper.stride + first;
      double value = values[first + r] - sums[r];
      for (std::size_t j = r + 1; j < here; ++j) value -= row[j] * values[first + j];
      values[first + r] = value * inverse[r];
    }
  }
}

BODKIN_PROCESSOR_CLONES
void rotate(const double* from, double* other, double* to, std::size_t count) noexcept {
  const double length = std::sqrt(from[0] * from[0] + other[0] * other[0]);
  const double cosine = from[0] / length, sine = other[0] / length;
  std::size_t j = 0;
  for (; j + lanes <= count; j += lanes) {
    const Lanes here = *reinterpret_cast<const Lanes*>(from + j);
    const Lanes there = *reinterpret_cast<const Lanes*>(other + j);
    *reinterpret_cast<Lanes*>(to + j) = here * cosine + there * sine;
    *reinterpret_cast<Lanes*>(other + j) = there * cosine - here * sine;
  }
  for (; j < count; ++j) {
    const double here = from[j], there = other[j];
    to[j] = here * cosine + there * sine;
    other[j] = there * cosine - here * sine;
  }
}

BODKIN_PROCESSOR_CLONES
std::size_t factorise(double* numbers, std::size_t stride, std::size_t rows, const double* least) noexcept {
  const std::size_t end = padded(rows);
  for (std::size_t first = 0; first < rows; first += block) {
    double* const here = numbers + first * stride;
    for (std::size_t j = first; j < end; j += block) {
      subtract_above(here, numbers, first, stride, first, j);
      subtract_above(here + 4 * stride, numbers, first + 4, stride, first, j);
    }
    for (std::size_t r = 0; r < std::min(block, rows - first); ++r) {
      double* const row = here + r * stride;
      const std::size_t from = first + r / lanes * lanes;
      for (std::size_t above = 0; above < r; ++above) {
        const double* const other = here + above * stride;
        const double factor = other[first + r];
        for (std::size_t j = from; j < end; j += lanes)
          *reinterpret_cast<Lanes*>(row + j) -= *reinterpret_cast<const Lanes*>(other + j) * factor;
      }
      const double pivot = row[first + r];
      if (!(pivot > least[first + r]) || !std::isfinite(pivot)) return first + r;
      const double inverse = 1.0 / std::sqrt(pivot);
      for (std::size_t j = from; j < end; j += lanes) *reinterpret_cast<Lanes*>(row + j) *= inverse;
    }
  }
  return rows;
}

BODKIN_PROCESSOR_CLONES
double product(const double* a, const double* b, std::size_t count) noexcept {
  Lanes even = {}, odd = {};
  std::size_t j = 0;
  for (; j + 2 * lanes <= count; j += 2 * lanes) {
    even += *reinterpret_cast<const Lanes*>(a + j) * *reinterpret_cast<const Lanes*>(b + j);
    odd += *reinterpret_cast<const Lanes*>(a + j + lanes) * *reinterpret_cast<const Lanes*>(b + j + lanes);
  }
  double rest = 0.0;
  for (; j < count; ++j) rest += a[j] * b[j];
  const Lanes sum = even + odd;
  return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + rest;
}

BODKIN_PROCESSOR_CLONES
void add_rows(const double* const* rows, const double* factors, std::size_t count, double* values,
              std::size_t columns) noexcept {
  const std::size_t end = padded(columns);
  std::size_t r = 0;
  for (; r + 4 <= count; r += 4) {
    const double *a = rows[r], *b = rows[r + 1], *c = rows[r + 2], *d = rows[r + 3];
    const double fa = factors[r], fb = factors[r + 1], fc = factors[r + 2], fd = factors[r + 3];
    for (std::size_t j = 0; j < end; j += lanes) {
      *reinterpret_cast<Lanes*>(values + j) +=
          (*reinterpret_cast<const Lanes*>(a + j) * fa + *reinterpret_cast<const Lanes*>(b + j) * fb) +
          (*reinterpret_cast<const Lanes*>(c + j) * fc + *reinterpret_cast<const Lanes*>(d + j) * fd);
    }
  }
  for (; r < count; ++r) {
    for (std::size_t j = 0; j < end; j += lanes)
      *reinterpret_cast<Lanes*>(values + j) += *reinterpret_cast<const Lanes*>(rows[r] + j) * factors[r];
  }
}

BODKIN_PROCESSOR_CLONES
void multiply(const double* rows, std::size_t stride, std::size_t count, const double* values, std::size_t columns,
              double* products) noexcept {
  const std::size_t end = padded(columns);
  for (std::size_t r = 0; r < count; r += 4) four_products(rows + r * stride, stride, values, 0, end, products + r);
}

BODKIN_PROCESSOR_CLONES
void subtract_squares(const double* from, std::size_t from_stride, const double* a, const double* b, std::size_t size,
                      double* to, std::size_t to_stride) noexcept {
  const std::size_t end = padded(size);
  for (std::size_t i = 0; i < size; ++i) {
    const double* const row = from + i * from_stride;
    double* const result = to + i * to_stride;
    for (std::size_t j = 0; j < end; j += lanes) {
      *reinterpret_cast<Lanes*>(result + j) =
          *reinterpret_cast<const Lanes*>(row + j) -
          (*reinterpret_cast<const Lanes*>(a + j) * a[i] + *reinterpret_cast<const Lanes*>(b + j) * b[i]);
    }
  }
}

}  // namespace bodkin::triangle
