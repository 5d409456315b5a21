#include "fem/solid/dense_front.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "fem/solid/dense_kernels.h"

namespace bodkin::fem {

namespace {

constexpr std::size_t tile = 192;       // columns
constexpr std::size_t tall_tile = 768;  // rows
constexpr double worth_sharing = 2e7;   // multiplications and additions; smaller fronts are done in one piece

std::size_t tiles_of(std::size_t size, std::size_t of) {
  return (size + of - 1) / of;
}

// A piece of a lower triangle: rows from `row` on below the diagonal, or the square on the diagonal.
struct TriangleTile {
  std::size_t row, rows, column, columns;
};

// The lower triangle of size x size in tiles, by columns from the square down; the squares first, since they differ
// from the rest.
std::vector<TriangleTile> tiles_of_triangle(std::size_t size, std::size_t rows) {
  std::vector<TriangleTile> tiles;
  for (std::size_t column = 0; column < rows; column += tile) {
    const std::size_t columns = std::min(tile, rows - column);
    tiles.push_back({column, columns, column, columns});
    for (std::size_t row = column + columns; row < size; row += tall_tile)
      tiles.push_back({row, std::min(tall_tile, size - row), column, columns});
  }
  return tiles;
}

// c := c - b b^T in the lower triangle of the first `columns` columns, c is rows x columns, b rows x size.
void subtract_square(ThreadPool& pool, const DenseTiles& kernel, std::size_t rows, std::size_t columns,
                     std::size_t size, const double* b, std::size_t lead_b, double* c, std::size_t lead_c) {
  const std::vector<TriangleTile> tiles = tiles_of_triangle(rows, columns);
  pool.run(tiles.size(), [&](std::size_t i) {
    const TriangleTile& t = tiles[i];
    double* const to = c + t.column * lead_c + t.row;
    if (t.row == t.column)
      subtract_outer_product(kernel, t.rows, size, b + t.row, lead_b, to, lead_c);
    else
      subtract_product_transposed(kernel, t.rows, size, t.columns, b + t.row, lead_b, b + t.column, lead_b, to,
                                  lead_c);
  });
}

}  // namespace

std::size_t factorise_front(ThreadPool& pool, std::size_t width, std::size_t height, double* panel, double* update,
                            const DenseTiles& kernel) {
  const std::size_t below = height - width;
  const auto w = static_cast<double>(width), b = static_cast<double>(below);
  if (w * w * w / 3.0 + w * w * b + w * b * b < worth_sharing) {
    const std::size_t sound = cholesky(kernel, width, panel, height);
    if (sound < width || below == 0) return sound;
    solve_right_transposed(kernel, below, width, panel, height, panel + width, height);
    subtract_outer_product(kernel, below, width, panel + width, height, update, below);
    return width;
  }
  for (std::size_t first = 0; first < width; first += tile) {
    const std::size_t columns = std::min(tile, width - first), after = first + columns;
    double* const square = panel + first * height + first;
    const std::size_t sound = cholesky(kernel, columns, square, height);
    if (sound < columns) return first + sound;
    pool.run(tiles_of(height - after, tall_tile), [&](std::size_t i) {
      const std::size_t row = after + i * tall_tile;
      solve_right_transposed(kernel, std::min(tall_tile, height - row), columns, square, height,
                             panel + first * height + row, height);
    });
    subtract_square(pool, kernel, height - after, width - after, columns, panel + first * height + after, height,
                    panel + after * height + after, height);
  }
  if (below > 0) subtract_square(pool, kernel, below, below, width, panel + width, height, update, below);
  return width;
}

// X = L^-1 goes into the lower triangle of `inverse`, and X^T X into the upper one, except for the squares on the
// diagonal, which both use.
void invert_from_lower(ThreadPool& pool, std::size_t size, const double* lower, double* inverse,
                       const DenseTiles& kernel) {
  const std::size_t count = tiles_of(size, tile);
  pool.run(count, [&](std::size_t i) {
    const std::size_t first = i * tile, columns = std::min(tile, size - first);
    double* const x = inverse + first * size + first;
    for (std::size_t j = 0; j < columns; ++j) {
      std::fill_n(x + j * size, size - first, 0.0);
      x[j * size + j] = 1.0;
    }
    invert_lower_times(kernel, size - first, columns, lower + first * size + first, size, x, size);
  });
  std::vector<double> squares(count * tile * tile);
  pool.run(count * (count + 1) / 2, [&](std::size_t i) {
    std::size_t across = 0;  // the i-th pair with down <= across
    while ((across + 1) * (across + 2) / 2 <= i) ++across;
    const std::size_t down = i - across * (across + 1) / 2;
    const std::size_t left = across * tile, top = down * tile, columns = std::min(tile, size - left);
    const double* const right = inverse + left * size + left;
    double* const to = down == across ? squares.data() + across * tile * tile : inverse + left * size + top;
    multiply_transposed(kernel, size - left, std::min(tile, size - top), columns, inverse + top * size + left, size,
                        right, size, to, down == across ? tile : size);
  });
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t first = i * tile, columns = std::min(tile, size - first);
    for (std::size_t j = 0; j < columns; ++j)
      std::copy_n(squares.data() + i * tile * tile + j * tile, columns, inverse + (first + j) * size + first);
  }
  pool.run(count, [&](std::size_t i) {
    const std::size_t first = i * tile, columns = std::min(tile, size - first);
    mirror_upper(size, inverse, size, first, first + columns);
  });
}

}  // namespace bodkin::fem
