#pragma once

#include <cstddef>

#include "core/thread_pool.h"
#include "fem/solid/dense_tiles.h"

namespace bodkin::fem {

// The dense work of the factorisation that is worth running in parallel. It is cut into tiles whose size does not
// depend on the number of threads, and every tile is computed on one thread: the bits are the same for any pool, and
// for any of dense_tiles(). Matrices are column-major, lower triangles.

// The first `width` columns of a symmetric matrix of `height` rows, `panel`, become L; their contribution to the rest
// of the matrix is subtracted from `update`, (height - width) x (height - width). Returns width, or the first column
// without a positive pivot.
std::size_t factorise_front(ThreadPool& pool, std::size_t width, std::size_t height, double* panel, double* update,
                            const DenseTiles& kernel = dense_tiles().front());

// inverse := (L L^T)^-1, both triangles, symmetric to the last bit; size x size, as `lower`, whose upper triangle is
// not read. The two must not overlap.
void invert_from_lower(ThreadPool& pool, std::size_t size, const double* lower, double* inverse,
                       const DenseTiles& kernel = dense_tiles().front());

}  // namespace bodkin::fem
