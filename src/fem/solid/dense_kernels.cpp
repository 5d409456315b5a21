#include "fem/solid/dense_kernels.h"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include <cblas-openblas.h>

namespace bodkin::fem {

namespace {

constexpr std::size_t mirror_tile = 32;     // rows and columns that fit into the cache together
constexpr std::size_t solved_columns = 48;  // columns solved together
constexpr std::size_t most_packed_depth = 256, most_packed_rows = 144,
                      most_packed_columns = 192;  // multiples of every tile size

int as_int(std::size_t value) {
  return static_cast<int>(value);
}

// Element (i, k) of a matrix lies at at[i row_step + k depth_step].
struct Operand {
  const double* at;
  std::size_t row_step, depth_step;
};

enum class Extent { all, lower };

// `factor` times rows `from` to `to` and columns `first` to `last`, in strips of `width` rows, the last padded with
// zeros: the `width` numbers of each column in turn. Read in memory order.
template <std::size_t width>
void pack_strips(const Operand& a, double factor, std::size_t from, std::size_t to, std::size_t first,
                 std::size_t last, double* packed) {
  const std::size_t strip = width * (last - first);
  const auto fill = [&](std::size_t row, std::size_t k, double* at) {
    const double* const column = a.at + row * a.row_step + k * a.depth_step;
    if (row + width <= to && a.row_step == 1) {
      for (std::size_t i = 0; i < width; ++i) at[i] = factor * column[i];
      return;
    }
    const std::size_t rows = std::min(width, to - row);
    for (std::size_t i = 0; i < rows; ++i) at[i] = factor * column[i * a.row_step];
    for (std::size_t i = rows; i < width; ++i) at[i] = 0.0;
  };
  if (a.row_step == 1) {
    for (std::size_t k = first; k < last; ++k, packed += width) {
      double* at = packed;
      for (std::size_t row = from; row < to; row += width, at += strip) fill(row, k, at);
    }
  } else {
    for (std::size_t row = from; row < to; row += width)
      for (std::size_t k = first; k < last; ++k, packed += width) fill(row, k, packed);
  }
}

// For the tiles' widths.
void pack(const Operand& a, double factor, std::size_t from, std::size_t to, std::size_t first, std::size_t last,
          std::size_t width, double* packed) {
  if (width == 24) return pack_strips<24>(a, factor, from, to, first, last, packed);
  if (width == 12) return pack_strips<12>(a, factor, from, to, first, last, packed);
  if (width == 8) return pack_strips<8>(a, factor, from, to, first, last, packed);
  pack_strips<4>(a, factor, from, to, first, last, packed);
}

std::size_t rounded_up(std::size_t size, std::size_t to) {
  return (size + to - 1) / to * to;
}

// A partial tile of c, or one of which only the lower triangle is required; its first element is (row, column).
void add_to_part(const DenseTiles& tiles, std::size_t depth, const double* a, const double* b, std::size_t row,
                 std::size_t rows, std::size_t column, std::size_t columns, Extent part, double* c,
                 std::size_t lead) {
  std::array<double, 24 * 8> whole{};
  const auto first_row = [&](std::size_t j) {
    return part == Extent::lower && column + j > row ? std::min(rows, column + j - row) : 0;
  };
  for (std::size_t j = 0; j < columns; ++j)
    for (std::size_t i = first_row(j); i < rows; ++i) whole[j * tiles.rows + i] = c[j * lead + i];
  tiles.add_product(depth, a, b, whole.data(), tiles.rows);
  for (std::size_t j = 0; j < columns; ++j)
    for (std::size_t i = first_row(j); i < rows; ++i) c[j * lead + i] = whole[j * tiles.rows + i];
}

// c := c + factor a b^T, c is rows x columns, only `part` of it is read and written.
void add_product(const DenseTiles& tiles, double factor, std::size_t rows, std::size_t columns, std::size_t depth,
                 const Operand& a, const Operand& b, Extent part, double* c, std::size_t lead) {
  if (rows == 0 || columns == 0 || depth == 0) return;
  const std::size_t deepest = std::min(depth, most_packed_depth);
  const auto left =
      std::make_unique_for_overwrite<double[]>(deepest * rounded_up(std::min(rows, most_packed_rows), tiles.rows));
  const auto right = std::make_unique_for_overwrite<double[]>(
      deepest * rounded_up(std::min(columns, most_packed_columns), tiles.columns));
  for (std::size_t k = 0; k < depth; k += most_packed_depth) {
    const std::size_t deep = std::min(most_packed_depth, depth - k);
    for (std::size_t j0 = 0; j0 < columns; j0 += most_packed_columns) {
      const std::size_t j1 = std::min(columns, j0 + most_packed_columns);
      pack(b, 1.0, j0, j1, k, k + deep, tiles.columns, right.get());
      const std::size_t begin = part == Extent::lower ? j0 / tiles.rows * tiles.rows : 0;
      for (std::size_t i0 = begin; i0 < rows; i0 += most_packed_rows) {
        const std::size_t i1 = std::min(rows, i0 + most_packed_rows);
        pack(a, factor, i0, i1, k, k + deep, tiles.rows, left.get());
        for (std::size_t j = j0; j < j1; j += tiles.columns) {
          for (std::size_t i = i0; i < i1; i += tiles.rows) {
            if (part == Extent::lower && i + tiles.rows <= j) continue;
            const double* const from = left.get() + (i - i0) * deep;
            const double* const by = right.get() + (j - j0) * deep;
            const std::size_t high = std::min(tiles.rows, i1 - i), wide = std::min(tiles.columns, j1 - j);
            const bool crosses = part == Extent::lower && i < j + wide;
            if (high == tiles.rows && wide == tiles.columns && !crosses)
              tiles.add_product(deep, from, by, c + j * lead + i, lead);
            else
              add_to_part(tiles, deep, from, by, i, high, j, wide, part, c + j * lead + i, lead);
          }
        }
      }
    }
  }
}

// Columns `first` to `last` of x := x l^-T, x has any number of rows.
void solve_strips(const DenseTiles& tiles, std::size_t rows, std::size_t first, std::size_t last, const double* l,
                  std::size_t lead_l, double* x, std::size_t lead) {
  std::size_t row = 0;
  for (; row + tiles.strip <= rows; row += tiles.strip) tiles.solve_strip(first, last, l, lead_l, x + row, lead);
  if (row == rows) return;
  std::array<double, 16 * solved_columns> rest{};
  for (std::size_t j = 0; j < last; ++j) std::copy_n(x + j * lead + row, rows - row, rest.data() + j * tiles.strip);
  tiles.solve_strip(first, last, l, lead_l, rest.data(), tiles.strip);
  for (std::size_t j = first; j < last; ++j)
    std::copy_n(rest.data() + j * tiles.strip, rows - row, x + j * lead + row);
}

// For at most `solved_columns` columns, in a copy with complete strips.
std::size_t cholesky_of_block(const DenseTiles& tiles, std::size_t size, double* a, std::size_t lead) {
  constexpr std::size_t high = solved_columns + 16;
  std::array<double, high * solved_columns> copy;
  for (std::size_t j = 0; j < size; ++j) {
    std::copy_n(a + j * lead + j, size - j, copy.data() + j * high + j);
    std::fill_n(copy.data() + j * high + size, high - size, 0.0);
  }
  std::size_t sound = 0;
  for (; sound < size; ++sound) {
    double* const pivot = copy.data() + sound * high + sound;
    *pivot = pivot_of(*pivot, copy.data() + sound, sound, high);
    if (!(*pivot > 0.0)) break;
    for (std::size_t row = sound + 1; row < size; row += tiles.strip)
      tiles.solve_strip(sound, sound + 1, copy.data(), high, copy.data() + row, high);
  }
  for (std::size_t j = 0; j < size; ++j) std::copy_n(copy.data() + j * high + j, size - j, a + j * lead + j);
  return sound;
}

}  // namespace

void use_one_thread_each() {
  if (openblas_get_num_threads() != 1) openblas_set_num_threads(1);
}

std::size_t cholesky(const DenseTiles& tiles, std::size_t size, double* a, std::size_t lead) {
  for (std::size_t first = 0; first < size; first += solved_columns) {
    const std::size_t columns = std::min(solved_columns, size - first), after = first + columns;
    double* const square = a + first * lead + first;
    const Operand above{a + first, 1, lead};
    add_product(tiles, -1.0, size - first, columns, first, above, above, Extent::lower, square, lead);
    const std::size_t sound = cholesky_of_block(tiles, columns, square, lead);
    if (sound < columns) return first + sound;
    solve_strips(tiles, size - after, 0, columns, square, lead, a + first * lead + after, lead);
  }
  return size;
}

void solve_right_transposed(const DenseTiles& tiles, std::size_t rows, std::size_t size, const double* l,
                            std::size_t lead, double* b, std::size_t lead_b) {
  for (std::size_t first = 0; first < size; first += solved_columns) {
    const std::size_t columns = std::min(solved_columns, size - first);
    double* const here = b + first * lead_b;
    add_product(tiles, -1.0, rows, columns, first, {b, 1, lead_b}, {l + first, 1, lead}, Extent::all, here, lead_b);
    solve_strips(tiles, rows, 0, columns, l + first * lead + first, lead, here, lead_b);
  }
}

void subtract_outer_product(const DenseTiles& tiles, std::size_t rows, std::size_t size, const double* b,
                            std::size_t lead_b, double* c, std::size_t lead_c) {
  const Operand operand{b, 1, lead_b};
  add_product(tiles, -1.0, rows, rows, size, operand, operand, Extent::lower, c, lead_c);
}

void subtract_product_transposed(const DenseTiles& tiles, std::size_t rows, std::size_t size, std::size_t columns,
                                 const double* a, std::size_t lead_a, const double* b, std::size_t lead_b, double* c,
                                 std::size_t lead_c) {
  add_product(tiles, -1.0, rows, columns, size, {a, 1, lead_a}, {b, 1, lead_b}, Extent::all, c, lead_c);
}

void multiply_transposed(const DenseTiles& tiles, std::size_t size, std::size_t rows, std::size_t columns,
                         const double* a, std::size_t lead_a, const double* b, std::size_t lead_b, double* c,
                         std::size_t lead_c) {
  for (std::size_t j = 0; j < columns; ++j) std::fill_n(c + j * lead_c, rows, 0.0);
  add_product(tiles, 1.0, rows, columns, size, {a, lead_a, 1}, {b, lead_b, 1}, Extent::all, c, lead_c);
}

// Block by solved_columns; the rows of a block are solved as columns of its transpose.
void invert_lower_times(const DenseTiles& tiles, std::size_t size, std::size_t columns, const double* l,
                        std::size_t lead, double* x, std::size_t lead_x) {
  const std::size_t lanes_up = rounded_up(columns, tiles.strip);
  std::vector<double> transposed(solved_columns * lanes_up, 0.0);
  for (std::size_t first = 0; first < size; first += solved_columns) {
    const std::size_t rows = std::min(solved_columns, size - first);
    add_product(tiles, -1.0, rows, columns, first, {l + first, 1, lead}, {x, lead_x, 1}, Extent::all, x + first,
                lead_x);
    for (std::size_t j = 0; j < columns; ++j)
      for (std::size_t i = 0; i < rows; ++i) transposed[i * lanes_up + j] = x[j * lead_x + first + i];
    solve_strips(tiles, lanes_up, 0, rows, l + first * lead + first, lead, transposed.data(), lanes_up);
    for (std::size_t j = 0; j < columns; ++j)
      for (std::size_t i = 0; i < rows; ++i) x[j * lead_x + first + i] = transposed[i * lanes_up + j];
  }
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
