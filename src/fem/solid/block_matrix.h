#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry.h"

namespace bodkin::fem {

// A symmetric sparse matrix of 3 x 3 blocks, one row and column of blocks per node. Only the lower triangle is kept,
// column by column: the blocks of column j are `start[j]` to `start[j + 1]`, the first is the diagonal's.
struct BlockMatrix {
  std::uint32_t nodes = 0;
  std::vector<std::size_t> start;  // nodes + 1
  std::vector<std::uint32_t> row;  // of each block; ascending within a column, the first is the column itself
  std::vector<Mat3> block;         // of each block; diagonal blocks are complete and symmetric
};

}  // namespace bodkin::fem
