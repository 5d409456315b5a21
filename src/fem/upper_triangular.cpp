#include "fem/upper_triangular.h"

#include <algorithm>
#include <cmath>

#include "core/simd.h"

namespace bodkin::fem::upper_triangular {

namespace {

constexpr std::size_t block = 8;

// values[j] -= sum over 8 rows of rows[r * stride + j] solved[r] for j in [from, to).
BODKIN_LANES_INLINE void subtract_rows(const double* rows, std::size_t stride, const double* solved, double* values,
                                       std::size_t from, std::size_t to) noexcept {
  const double a = solved[0], b = solved[1], c = solved[2], d = solved[3];
  const double e = solved[4], f = solved[5], g = solved[6], h = solved[7];
  for (std::size_t j = from; j < to; j += lane_count) {
    const auto row = [at = rows + j, stride](std::size_t r) { return lanes_at(at + r * stride); };
    *lanes_at(values + j) -= ((*row(0) * a + *row(1) * b) + (*row(2) * c + *row(3) * d)) +
                             ((*row(4) * e + *row(5) * f) + (*row(6) * g + *row(7) * h));
  }
}

// sums[r] = rows[r * stride + j] values[j] summed over j in [from, to), for 4 rows.
BODKIN_LANES_INLINE void four_products(const double* rows, std::size_t stride, const double* values, std::size_t from,
                                       std::size_t to, double* sums) noexcept {
  Lanes a = {}, b = {}, c = {}, d = {};
  for (std::size_t j = from; j < to; j += lane_count) {
    const Lanes value = *lanes_at(values + j);
    a += *lanes_at(rows + j) * value;
    b += *lanes_at(rows + stride + j) * value;
    c += *lanes_at(rows + 2 * stride + j) * value;
    d += *lanes_at(rows + 3 * stride + j) * value;
  }
  sums[0] = sum_of_lanes(a);
  sums[1] = sum_of_lanes(b);
  sums[2] = sum_of_lanes(c);
  sums[3] = sum_of_lanes(d);
}

// One step of a factorisation by blocks: subtracts U_above^T U_above from four rows, in the columns j to j + 8.
// `above`: the `count` finished rows of U; `pivots`: the column of the first of the four pivots.
BODKIN_LANES_INLINE void subtract_above(double* rows, const double* above, std::size_t pivots, std::size_t stride,
                                        std::size_t count, std::size_t j) noexcept {
  Lanes sums[4][2] = {};
  for (std::size_t k = 0; k < count; ++k) {
    const double* const row = above + k * stride;
    const Lanes left = *lanes_at(row + j), right = *lanes_at(row + j + 4);
    for (std::size_t r = 0; r < 4; ++r) {
      sums[r][0] += left * row[pivots + r];
      sums[r][1] += right * row[pivots + r];
    }
  }
  for (std::size_t r = 0; r < 4; ++r) {
    *lanes_at(rows + r * stride + j) -= sums[r][0];
    *lanes_at(rows + r * stride + j + 4) -= sums[r][1];
  }
}

// turn(row[j], a[j], b[j]) for `count` numbers.
template <typename Turn>
BODKIN_LANES_INLINE void turn_all(double* row, double* a, double* b, std::size_t count, const Turn& turn) noexcept {
  std::size_t j = 0;
  for (; j + lane_count <= count; j += lane_count) {
    Lanes here = *lanes_at(row + j), by_a = *lanes_at(a + j), by_b = *lanes_at(b + j);
    turn(here, by_a, by_b);
    *lanes_at(row + j) = here;
    *lanes_at(a + j) = by_a;
    *lanes_at(b + j) = by_b;
  }
  for (; j < count; ++j) turn(row[j], a[j], b[j]);
}

// One version for every processor. Clang rejects such versions of a function declared without them.
namespace wide {

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
  for (; j + lane_count <= count; j += lane_count) {
    const Lanes here = *lanes_at(from + j);
    const Lanes there = *lanes_at(other + j);
    *lanes_at(to + j) = here * cosine + there * sine;
    *lanes_at(other + j) = there * cosine - here * sine;
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
      const std::size_t from = first + r / lane_count * lane_count;
      for (std::size_t above = 0; above < r; ++above) {
        const double* const other = here + above * stride;
        const double factor = other[first + r];
        for (std::size_t j = from; j < end; j += lane_count) *lanes_at(row + j) -= *lanes_at(other + j) * factor;
      }
      const double pivot = row[first + r];
      if (!(pivot > least[first + r]) || !std::isfinite(pivot)) return first + r;
      const double inverse = 1.0 / std::sqrt(pivot);
      for (std::size_t j = from; j < end; j += lane_count) *lanes_at(row + j) *= inverse;
    }
  }
  return rows;
}

BODKIN_PROCESSOR_CLONES
void add_squares_to_factor(double* numbers, std::size_t stride, std::size_t rows, double* a, double* b) noexcept {
  for (std::size_t r = 0; r < rows; ++r) {
    double* const row = numbers + r * (stride + 1);
    const double first = std::sqrt(row[0] * row[0] + a[r] * a[r]);
    const double cosine_a = row[0] / first, sine_a = a[r] / first;
    const double pivot = std::sqrt(first * first + b[r] * b[r]);
    const double cosine_b = first / pivot, sine_b = b[r] / pivot;
    row[0] = pivot;
    const auto turn = [&](auto& here, auto& by_a, auto& by_b) {
      const auto between = here * cosine_a + by_a * sine_a;
      by_a = by_a * cosine_a - here * sine_a;
      here = between * cosine_b + by_b * sine_b;
      by_b = by_b * cosine_b - between * sine_b;
    };
    turn_all(row + 1, a + r + 1, b + r + 1, rows - r - 1, turn);
  }
}

BODKIN_PROCESSOR_CLONES
bool subtract_squares_from_factor(double* numbers, std::size_t stride, std::size_t rows, double* a, double* b,
                                  const double* least) noexcept {
  for (std::size_t r = 0; r < rows; ++r) {
    double* const row = numbers + r * (stride + 1);
    const double left = row[0] * row[0] - a[r] * a[r], pivot = left - b[r] * b[r];
    if (!(pivot > least[r]) || !std::isfinite(pivot)) return false;
    const double first = std::sqrt(left), second = std::sqrt(pivot);
    const double sine_a = a[r] / row[0], cosine_a = first / row[0], stretch_a = row[0] / first;
    const double sine_b = b[r] / first, cosine_b = second / first, stretch_b = first / second;
    row[0] = second;
    const auto turn = [&](auto& here, auto& by_a, auto& by_b) {
      const auto between = (here - by_a * sine_a) * stretch_a;
      by_a = by_a * cosine_a - between * sine_a;
      here = (between - by_b * sine_b) * stretch_b;
      by_b = by_b * cosine_b - here * sine_b;
    };
    turn_all(row + 1, a + r + 1, b + r + 1, rows - r - 1, turn);
  }
  return true;
}

BODKIN_PROCESSOR_CLONES
double product(const double* a, const double* b, std::size_t count) noexcept {
  Lanes even = {}, odd = {};
  std::size_t j = 0;
  for (; j + 2 * lane_count <= count; j += 2 * lane_count) {
    even += *lanes_at(a + j) * *lanes_at(b + j);
    odd += *lanes_at(a + j + lane_count) * *lanes_at(b + j + lane_count);
  }
  double rest = 0.0;
  for (; j < count; ++j) rest += a[j] * b[j];
  return sum_of_lanes(even + odd) + rest;
}

BODKIN_PROCESSOR_CLONES
void add_rows(const double* const* rows, const double* factors, std::size_t count, double* values,
              std::size_t columns) noexcept {
  const std::size_t end = padded(columns);
  std::size_t r = 0;
  for (; r + 4 <= count; r += 4) {
    const double *a = rows[r], *b = rows[r + 1], *c = rows[r + 2], *d = rows[r + 3];
    const double fa = factors[r], fb = factors[r + 1], fc = factors[r + 2], fd = factors[r + 3];
    for (std::size_t j = 0; j < end; j += lane_count) {
      *lanes_at(values + j) +=
          (*lanes_at(a + j) * fa + *lanes_at(b + j) * fb) + (*lanes_at(c + j) * fc + *lanes_at(d + j) * fd);
    }
  }
  for (; r < count; ++r) {
    for (std::size_t j = 0; j < end; j += lane_count) *lanes_at(values + j) += *lanes_at(rows[r] + j) * factors[r];
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
    for (std::size_t j = 0; j < end; j += lane_count) {
      *lanes_at(result + j) = *lanes_at(row + j) - (*lanes_at(a + j) * a[i] + *lanes_at(b + j) * b[i]);
    }
  }
}

}  // namespace wide

}  // namespace

void solve_transposed(const Upper& upper, double* columns, std::size_t count) noexcept {
  wide::solve_transposed(upper, columns, count);
}

void solve(const Upper& upper, double* values) noexcept {
  wide::solve(upper, values);
}

void rotate(const double* from, double* other, double* to, std::size_t count) noexcept {
  wide::rotate(from, other, to, count);
}

std::size_t factorise(double* numbers, std::size_t stride, std::size_t rows, const double* least) noexcept {
  return wide::factorise(numbers, stride, rows, least);
}

void add_squares_to_factor(double* numbers, std::size_t stride, std::size_t rows, double* a, double* b) noexcept {
  wide::add_squares_to_factor(numbers, stride, rows, a, b);
}

bool subtract_squares_from_factor(double* numbers, std::size_t stride, std::size_t rows, double* a, double* b,
                                  const double* least) noexcept {
  return wide::subtract_squares_from_factor(numbers, stride, rows, a, b, least);
}

double product(const double* a, const double* b, std::size_t count) noexcept {
  return wide::product(a, b, count);
}

void add_rows(const double* const* rows, const double* factors, std::size_t count, double* values,
              std::size_t columns) noexcept {
  wide::add_rows(rows, factors, count, values, columns);
}

void multiply(const double* rows, std::size_t stride, std::size_t count, const double* values, std::size_t columns,
              double* products) noexcept {
  wide::multiply(rows, stride, count, values, columns, products);
}

void subtract_squares(const double* from, std::size_t from_stride, const double* a, const double* b, std::size_t size,
                      double* to, std::size_t to_stride) noexcept {
  wide::subtract_squares(from, from_stride, a, b, size, to, to_stride);
}

}  // namespace bodkin::fem::upper_triangular
